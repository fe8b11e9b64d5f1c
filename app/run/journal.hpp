// Messages of a command to the user, on the terminal and in log.txt.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {

class Journal {
public:
    /// Speaks to standard output only, until it is given a file.
    Journal() = default;

    /// Also write to the file from now on, in place of what it held. Throws FileError.
    void keep(const std::filesystem::path& file);
    /// Also write to the file from now on, behind what it holds. Throws FileError.
    void go_on_with(const std::filesystem::path& file);

    /// A line, or several, for the terminal and the file. Throws FileError when the file cannot be written.
    void say(const std::string& text);
    /// For the file only. Throws FileError.
    void note(const std::string& text);
    /// For the file only: a failure that is told elsewhere. That of the file itself is dropped beside it; the
    /// next `say` or `note` throws it.
    void note_failure(const std::string& text);
    /// To standard error and, as `note_failure`, to the file.
    void complain(const std::string& text);

private:
    void open(const std::filesystem::path& file, std::ios::openmode mode);

    std::filesystem::path path_;
    std::ofstream file_;
};

} // namespace quicksand
