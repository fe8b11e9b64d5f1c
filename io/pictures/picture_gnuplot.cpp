#include "io/pictures/picture_gnuplot.hpp"

#include "io/files/file_error.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>

namespace quicksand {
namespace {

constexpr const char* still_good = "the results themselves are untouched";

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

/// Files instead of pipes: neither side can wait for the other to read.
TemporaryFile open_temporary(const std::filesystem::path& picture)
{
    TemporaryFile file(std::tmpfile());
    if (!file) throw FileError(picture, "cannot draw", system_reason(errno), still_good);
    return file;
}

/// Start gnuplot with the script as its input and its messages in `messages`; 0 or an errno value.
int start_gnuplot(std::FILE* script, std::FILE* messages, pid_t& child)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, fileno(script), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(messages), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, fileno(messages), STDERR_FILENO);
    // -d: the user's own start-up file shall not change the pictures.
    // A file by its name: of its standard input gnuplot reads each character by a call of the system.
    std::string program = "gnuplot", defaults = "-d", input = "/dev/stdin";
    const std::array<char*, 4> arguments{program.data(), defaults.data(), input.data(), nullptr};
    const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

int wait_for(pid_t child)
{
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The last non-empty line of what gnuplot said.
std::string last_words(std::FILE* messages)
{
    std::rewind(messages);
    std::string last;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), static_cast<int>(line.size()), messages) != nullptr) {
        std::string text = line.data();
        text.erase(text.find_last_not_of(" \t\r\n") + 1);
        text.erase(0, text.find_first_not_of(" \t"));
        if (!text.empty()) last = text;
    }
    return last;
}

} // namespace

std::string gnuplot_text(const std::string& text)
{
    // Nothing but the quote itself is special.
    std::string result = "'";
    for (const char letter : text) {
        if (letter == '\n' || letter == '\r') continue;
        result += letter;
        if (letter == '\'') result += letter;
    }
    return result + "'";
}

std::string gnuplot_number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.7g}", value) : "NaN";
}

void run_gnuplot(const std::string& script, const std::filesystem::path& picture)
{
    const TemporaryFile input = open_temporary(picture);
    const TemporaryFile messages = open_temporary(picture);
    const bool written = std::fwrite(script.data(), 1, script.size(), input.get()) == script.size();
    if (!written || std::fflush(input.get()) != 0)
        throw FileError(picture, "cannot draw", system_reason(errno), still_good);
    std::rewind(input.get());

    pid_t child = 0;
    const int error = start_gnuplot(input.get(), messages.get(), child);
    if (error == ENOENT)
        throw FileError(picture, "cannot draw", "the program gnuplot is not installed (Debian: gnuplot-nox)",
                        still_good);
    if (error != 0) throw FileError(picture, "cannot start gnuplot for", system_reason(error), still_good);

    const int exit_code = wait_for(child);
    if (exit_code != 0) {
        const std::string words = last_words(messages.get());
        throw FileError(picture, "cannot draw",
                        fmt::format("gnuplot failed{}", words.empty() ? "" : ": " + words), still_good);
    }
}

} // namespace quicksand
