// The folder of a command's files, which its next call replaces.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

/// Make the folder. One that holds files, but none with the name of the command's report, is the user's own.
/// Throws InputError where the folder is a file or the user's own, and FileError.
void make_output_folder(const std::filesystem::path& directory, const std::string& report);

} // namespace quicksand
