#include "io/element/element_results.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <sstream>
#include <system_error>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "element_files.txt";
constexpr const char* list_head =
    "# Quicksand element tests: the files of the last run, replaced by the next";

/// Remove what a former run has listed; folders that are empty then go as well.
void remove_former(const fs::path& directory)
{
    std::istringstream list(read_text(directory / list_name));
    std::error_code ignored;
    for (std::string line; std::getline(list, line);) {
        const fs::path file = fs::path(line).lexically_normal();
        if (line.empty() || line.starts_with('#') || file.is_absolute() || *file.begin() == "..") continue;
        fs::remove(directory / file, ignored);
        if (file.has_parent_path()) fs::remove(directory / file.parent_path(), ignored); // only when empty
    }
    fs::remove(directory / list_name, ignored);
}

} // namespace

ElementResults::ElementResults(fs::path directory, const ElementProgramme& programme)
    : directory_(std::move(directory))
{
    std::error_code error;
    if (fs::exists(directory_) && !fs::is_directory(directory_))
        throw InputError(directory_.string() + " is a file, not a folder for results");
    if (fs::equivalent(directory_, fs::absolute(programme.file).parent_path(), error))
        throw InputError(directory_.string() +
                         " is the folder of the test file: choose another one for the results");
    if (fs::exists(directory_ / list_name)) {
        remove_former(directory_);
    } else if (fs::exists(directory_) && !fs::is_empty(directory_)) {
        throw InputError(
            directory_.string() +
            " holds files that are not of element tests; nothing was removed. Choose another folder");
    }
    fs::create_directories(directory_, error);
    if (error) throw FileError(directory_, "cannot create the folder", error.message(), "");
    write_atomically(add("test.toml"), programme.text);
    finish(); // so that a run that fails half-way can be replaced
}

fs::path ElementResults::add(const std::string& name)
{
    files_.push_back(name);
    return directory_ / name;
}

fs::path ElementResults::add(const std::string& test, const std::string& name)
{
    std::error_code error;
    fs::create_directories(directory_ / test, error);
    if (error) throw FileError(directory_ / test, "cannot create the folder", error.message(), "");
    return add(test + "/" + name);
}

void ElementResults::finish() const
{
    std::string text = std::string(list_head) + "\n";
    for (const std::string& file : files_) text += file + "\n";
    write_atomically(directory_ / list_name, text);
}

} // namespace quicksand
