// Reading a file as a whole.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

/// The whole text of a file. Throws FileError, also where the path is a folder.
std::string read_text(const std::filesystem::path& path);

} // namespace quicksand
