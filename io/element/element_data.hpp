// The user's own points of cyclic strength from a CSV file.
#pragma once

#include "io/element/element_programme.hpp"
#include "io/keys/diagnostics.hpp"

namespace quicksand {

/// Read the columns CSR and N and, where it is there, the column named as the key that is varied. Lines with
/// # are comments. What is wrong is added to `findings` at `place`; then the result is empty.
std::optional<StrengthData> read_strength_data(const std::filesystem::path& file, const std::string& varied,
                                               const SourcePlace& place, Diagnostics& findings);

} // namespace quicksand
