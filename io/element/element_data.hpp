// The user's own points of cyclic strength from a CSV file.
#pragma once

#include "io/element/element_programme.hpp"
#include "io/keys/diagnostics.hpp"

namespace quicksand {

/// Cyclic shear stress over vertical effective stress: no sand bears more, and percents are [-].
inline constexpr double largest_stress_ratio = 2.0;
inline constexpr const char* no_ratio =
    " is no ratio of stresses, as 0.15: are the numbers in per cent, or the columns exchanged?";

/// Read the columns CSR and N and, where it is there, the column named as the key that is varied. Lines with
/// # are comments. What is wrong is added to `findings` at `place`; then the result is empty.
std::optional<StrengthData> read_strength_data(const std::filesystem::path& file, const std::string& varied,
                                               const SourcePlace& place, Diagnostics& findings);

} // namespace quicksand
