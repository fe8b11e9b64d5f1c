#include "app/sweep/process_pool.hpp"

#include "app/machine/child_process.hpp"
#include "app/run/stop_signal.hpp"

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <list>
#include <optional>
#include <thread>

namespace quicksand {

namespace {

using Clock = std::chrono::steady_clock;

struct PoolProcess {
    std::size_t number = 0;
    pid_t child = 0;
    Clock::time_point start;
};

std::optional<PoolEnd> end_of(const PoolProcess& process)
{
    const std::optional<int> code = end_code(process.child);
    if (!code) return std::nullopt;
    return PoolEnd{*code, std::chrono::duration<double>(Clock::now() - process.start).count()};
}

/// The processes under way. When a failure ends the program's work they are asked to stop, and waited for.
class Processes {
public:
    Processes() = default;
    Processes(const Processes&) = delete;
    Processes& operator=(const Processes&) = delete;
    ~Processes()
    {
        stop();
        for (const PoolProcess& process : running) waitpid(process.child, nullptr, 0);
    }
    /// A second signal would end a run at once, without its checkpoint.
    void stop()
    {
        if (stopping) return;
        stopping = true;
        for (const PoolProcess& process : running) kill(process.child, SIGTERM);
    }

    std::list<PoolProcess> running;
    bool stopping = false;
};

} // namespace

void run_pool(const std::vector<PoolTask>& tasks, int at_once,
              const std::function<void(std::size_t, const PoolEnd&)>& ended)
{
    constexpr auto pause = std::chrono::milliseconds(10);
    Processes processes;
    std::list<PoolProcess>& running = processes.running;
    for (std::size_t next = 0; !running.empty() || (next < tasks.size() && !processes.stopping);) {
        if (StopSignal::received()) processes.stop();
        while (!processes.stopping && next < tasks.size() && static_cast<int>(running.size()) < at_once) {
            const PoolTask& task = tasks[next];
            running.push_back({next,
                               start_program(task.words, {task.log, task.log}, ProcessTie::ends_with_parent),
                               Clock::now()});
            ++next;
        }
        std::this_thread::sleep_for(pause);
        for (auto each = running.begin(); each != running.end();) {
            const PoolProcess process = *each;
            const std::optional<PoolEnd> end = end_of(process);
            each = end ? running.erase(each) : std::next(each);
            if (end) ended(process.number, *end);
        }
    }
}

} // namespace quicksand
