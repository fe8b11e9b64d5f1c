#include "io/pictures/picture_gnuplot.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <memory>

namespace quicksand {
namespace {

namespace fs = std::filesystem;

constexpr const char* still_good = "the results themselves are untouched";

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

/// Files instead of pipes: neither side can wait for the other to read.
TemporaryFile open_temporary(const fs::path& picture)
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

/// Run a script and wait for its end; "", or why gnuplot failed. Throws FileError naming `picture` where it
/// cannot be started.
std::string run_gnuplot(const std::string& script, const fs::path& picture)
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
    if (wait_for(child) == 0) return "";
    const std::string words = last_words(messages.get());
    return "gnuplot failed" + (words.empty() ? "" : ": " + words);
}

/// Sheet and style that all pictures share, then what is drawn.
std::string script_of(const Drawing& drawing)
{
    return fmt::format("reset\n"
                       "set encoding utf8\n"
                       "set zero 1e-200\n" // narrower axes are refused
                       "set terminal pngcairo noenhanced rounded size {0:.0f},{1:.0f} "
                       "font 'DejaVu Sans,12' background rgb '#ffffff'\n"
                       "set output {2}\n"
                       "X(left) = left / {0:.1f}\n"
                       "Y(top) = 1.0 - top / {1:.1f}\n"
                       "set minussign\n"
                       "set border 15 front lw 1 lc rgb '#303030'\n"
                       "set tics out nomirror scale 0.6 textcolor rgb '#1a1a1a'\n"
                       "set grid lt 1 lw 0.7 lc rgb '#dddddd'\n"
                       "{3}"
                       "unset output\n",
                       drawing.width, drawing.height, gnuplot_text(temporary_name(drawing.png).string()),
                       drawing.commands);
}

/// gnuplot does not tell of a full disk; what it could not write whole lacks the last part of a PNG.
bool is_whole(const fs::path& png)
{
    const std::string end = "IEND\xae"
                            "B`\x82";
    std::ifstream file(png, std::ios::binary);
    std::string found(end.size(), ' ');
    file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
    file.read(found.data(), static_cast<std::streamsize>(found.size()));
    return file && found == end;
}

} // namespace

std::vector<fs::path> draw_pictures(const std::vector<Drawing>& drawings)
{
    std::vector<fs::path> files;
    if (drawings.empty()) return files;
    std::string script;
    std::error_code ignored;
    for (const Drawing& drawing : drawings) {
        script += script_of(drawing);
        fs::remove(temporary_name(drawing.png), ignored);
        files.push_back(drawing.png);
    }
    std::string failure = run_gnuplot(script, drawings.front().png);
    const Drawing* failed = failure.empty() ? nullptr : &drawings.back();
    for (auto drawing = drawings.rbegin(); drawing != drawings.rend(); ++drawing) {
        if (is_whole(temporary_name(drawing->png))) {
            replace_file(drawing->png);
        } else {
            fs::remove(temporary_name(drawing->png), ignored);
            failed = &*drawing;
        }
    }
    if (failed == nullptr) return files;
    if (failure.empty()) failure = "gnuplot wrote only a part of the picture; is the disk full?";
    throw FileError(failed->png, "cannot draw", failure, still_good);
}

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

std::string label_at(double left, double top, const std::string& text, const std::string& style)
{
    return fmt::format("set label {} at screen X({:g}), screen Y({:g}) {}\n", gnuplot_text(text), left, top,
                       style);
}

std::string axes_in(const PixelBox& box)
{
    return fmt::format("set lmargin at screen X({:g})\nset rmargin at screen X({:g})\n"
                       "set tmargin at screen Y({:g})\nset bmargin at screen Y({:g})\n",
                       box.left, box.right(), box.top, box.bottom());
}

} // namespace quicksand
