// Whether a results folder holds what is no number.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

/// The first file and column of histories, probes and frames that holds NaN or an infinite number where there
/// is soil; "" where all is well. Throws FileError.
std::string find_bad_numbers(const std::filesystem::path& results);

} // namespace quicksand
