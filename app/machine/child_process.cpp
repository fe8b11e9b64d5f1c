#include "app/machine/child_process.hpp"

#include "io/files/file_error.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace quicksand {

namespace {

constexpr int cannot_execute = 127; // as of a shell

bool send_to(int descriptor, const char* file)
{
    constexpr int mode = O_WRONLY | O_CREAT | O_TRUNC, rights = 0644;
    const int opened = open(file, mode, rights);
    if (opened < 0 || dup2(opened, descriptor) < 0) return false;
    return opened == descriptor || close(opened) == 0;
}

/// In the new process: calls only what is allowed between fork and exec.
[[noreturn]] void become(char** arguments, const ProcessFiles& files, ProcessTie tie, pid_t parent)
{
    bool good = send_to(STDOUT_FILENO, files.output.c_str());
    good = good && (files.messages == files.output ? dup2(STDOUT_FILENO, STDERR_FILENO) >= 0
                                                   : send_to(STDERR_FILENO, files.messages.c_str()));
    if (tie == ProcessTie::ends_with_parent) {
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        good = good && getppid() == parent; // else it has gone before the line above
    }
    if (good) execv("/proc/self/exe", arguments);
    _exit(cannot_execute);
}

} // namespace

pid_t start_program(std::vector<std::string> words, const ProcessFiles& files, ProcessTie tie)
{
    words.insert(words.begin(), "quicksand");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t parent = getpid(), child = fork();
    if (child == 0) become(arguments.data(), files, tie, parent);
    if (child < 0) throw FileError(files.output, "cannot start a process for", system_reason(errno), "");
    return child;
}

std::optional<int> end_code(pid_t child)
{
    int status = 0;
    if (waitpid(child, &status, WNOHANG) != child) return std::nullopt;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace quicksand
