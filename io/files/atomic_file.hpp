// Files that are replaced as a whole: a reader sees the old text or the new one, never a half.
#pragma once

#include "geometry/drawing/text_file.hpp" // read_text()

#include <filesystem>
#include <string>
#include <string_view>

namespace quicksand {

/// Name of the temporary file beside `path`.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Rename the finished temporary file to `path`. Throws FileError.
void replace_file(const std::filesystem::path& path);

/// Write `text` to the temporary file and rename it to `path`. Throws FileError.
void write_atomically(const std::filesystem::path& path, std::string_view text);

/// As write_atomically(), and on the disk itself when it returns: it survives a power cut. Throws FileError.
void write_durably(const std::filesystem::path& path, std::string_view bytes);

} // namespace quicksand
