#include "app/stress/rows/row_process.hpp"

#include "io/files/file_error.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <list>
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

pid_t start_process(std::vector<std::string> words, const RowFiles& files)
{
    words.insert(words.begin(), "quicksand");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const std::string output = files.words().string(), messages = files.complaints().string();
    constexpr int mode = O_WRONLY | O_CREAT | O_TRUNC, rights = 0644;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), mode, rights);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, messages.c_str(), mode, rights);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw FileError(files.folder, "cannot start a process for", system_reason(error), "");
    return child;
}

/// Whether it has ended, and how.
bool has_ended(const RunningProcess& running, const ProcessLimits& limits, ProcessEnd& end)
{
    int status = 0;
    if (waitpid(running.child, &status, WNOHANG) != running.child) return false;
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
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
