// The bytes of an input file as text: what is no readable UTF-8 text is refused with advice.
#pragma once

#include "io/keys/diagnostics.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace quicksand {

/// Read a text file of at most 64 MiB. What is wrong is added to `findings` at `place`; then the result is
/// empty.
std::optional<std::string> read_text_file(const std::filesystem::path& file, const SourcePlace& place,
                                          Diagnostics& findings);

/// Check that the text is UTF-8 and, outside comments and quotes, plain ASCII.
void check_characters(const std::filesystem::path& file, std::string_view text, Diagnostics& findings);

} // namespace quicksand
