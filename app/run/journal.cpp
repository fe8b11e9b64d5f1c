#include "app/run/journal.hpp"

#include "io/files/file_error.hpp"

#include <cerrno>
#include <iostream>

namespace quicksand {

void Journal::keep(const std::filesystem::path& file)
{
    open(file, std::ios::trunc);
}

void Journal::go_on_with(const std::filesystem::path& file)
{
    open(file, std::ios::app);
}

void Journal::open(const std::filesystem::path& file, std::ios::openmode mode)
{
    errno = 0;
    path_ = file;
    file_.open(file, mode);
    if (!file_) throw FileError(file, "cannot write", system_reason(errno), "");
}

void Journal::say(const std::string& text)
{
    std::cout << text << std::endl;
    note(text);
}

void Journal::note(const std::string& text)
{
    errno = 0;
    note_failure(text);
    if (!file_) throw FileError(path_, "cannot write", system_reason(errno), "");
}

void Journal::note_failure(const std::string& text)
{
    if (file_.is_open()) file_ << text << std::endl;
}

void Journal::complain(const std::string& text)
{
    std::cout.flush();
    std::cerr << text << std::endl;
    note_failure(text);
}

} // namespace quicksand
