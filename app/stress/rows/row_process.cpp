#include "app/stress/rows/row_process.hpp"

#include "app/machine/child_process.hpp"

#include <signal.h>

#include <chrono>
#include <list>
#include <optional>
#include <thread>

namespace quicksand {

namespace {

using Clock = std::chrono::steady_clock;

struct RunningProcess {
    std::size_t number = 0;
    pid_t child = 0;
    Clock::time_point start = {};
    bool was_late = false;
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
};

pid_t start_process(const std::vector<std::string>& words, const RowFiles& files)
{
    return start_program(words, {files.words(), files.complaints()}, ProcessTie::shares_terminal);
}

/// Whether it has ended, and how.
bool has_ended(const RunningProcess& running, const ProcessLimits& limits, ProcessEnd& end)
{
    const std::optional<int> code = end_code(running.child);
    if (!code) return false;
    end.code = *code;
    end.was_late = running.was_late;
    end.seconds = running.was_late ? limits.seconds : running.seconds();
    return true;
}

} // namespace

void run_processes(const std::vector<std::vector<std::string>>& words, const std::vector<RowFiles>& files,
                   const ProcessLimits& limits,
                   const std::function<void(std::size_t, const ProcessEnd&)>& ended)
{
    constexpr auto pause = std::chrono::milliseconds(5);
    std::list<RunningProcess> running;
    for (std::size_t next = 0; next < words.size() || !running.empty();) {
        while (next < words.size() && static_cast<int>(running.size()) < limits.at_once) {
            running.push_back({next, start_process(words[next], files[next]), Clock::now()});
            ++next;
        }
        std::this_thread::sleep_for(pause);
        for (auto each = running.begin(); each != running.end();) {
            if (!each->was_late && each->seconds() > limits.seconds) {
                each->was_late = true;
                kill(each->child, SIGKILL);
            }
            ProcessEnd end;
            const bool over = has_ended(*each, limits, end);
            if (over) ended(each->number, end);
            each = over ? running.erase(each) : std::next(each);
        }
    }
}

} // namespace quicksand
