#include "io/files/output_folder.hpp"

#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <system_error>

namespace quicksand {

namespace fs = std::filesystem;

void make_output_folder(const fs::path& directory, const std::string& report)
{
    if (fs::exists(directory) && !fs::is_directory(directory))
        throw InputError(directory.string() + " is a file, not a folder for results");
    if (fs::exists(directory) && !fs::is_empty(directory) && !fs::exists(directory / report))
        throw InputError(directory.string() + " holds files, but no " + report +
                         " of a former call: nothing was written. Choose another folder with -o");
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) throw FileError(directory, "cannot create the folder", error.message(), "");
}

} // namespace quicksand
