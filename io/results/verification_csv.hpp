// The measured errors of `verify` as a CSV file: one row for each quantity and grid.
#pragma once

#include "solver/verification/solutions/convergence.hpp"

#include <filesystem>
#include <vector>

namespace quicksand {

/// Replace the file. Columns: problem, quantity, norm, cells, error, limit, order, least_order, seconds,
/// reference; empty where there is no limit or order. Throws FileError.
void write_verification_csv(const std::filesystem::path& file, const std::vector<Convergence>& results);

} // namespace quicksand
