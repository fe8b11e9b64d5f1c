#include "geometry/drawing/child_process.hpp"

#include "solver/base/failure.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

namespace quicksand {

namespace {

pid_t start_program(const std::filesystem::path& program, const std::vector<std::string>& arguments)
{
    std::vector<std::string> texts = {program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    }
    pid_t child = 0;
    const int error = posix_spawn(&child, texts.front().c_str(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        throw FileError(program, "cannot be started",
                        system_reason(error) + "\nhint: is Quicksand installed completely?", "");
    }
    return child;
}

} // namespace

ChildResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                        double time_limit)
{
    using namespace std::chrono;
    const pid_t child = start_program(program, arguments);
    const auto limit = steady_clock::now() + duration<double>(time_limit);
    int status = 0;
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) break;
        if (steady_clock::now() >= limit) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return {ChildEnd::out_of_time, SIGKILL};
        }
        std::this_thread::sleep_for(milliseconds(2));
    }
    if (WIFSIGNALED(status)) return {ChildEnd::signalled, WTERMSIG(status)};
    return {ChildEnd::exited, WEXITSTATUS(status)};
}

} // namespace quicksand
