// The benchmarks of the command bench.
#pragma once

#include "app/run/choices.hpp"

namespace quicksand {

ExitCode measure_kernel(const BenchChoice& choice);
ExitCode measure_errors(const BenchChoice& choice);
ExitCode measure_grids(const BenchChoice& choice);
ExitCode measure_scale(const BenchChoice& choice);
ExitCode measure_skips(const BenchChoice& choice);

} // namespace quicksand
