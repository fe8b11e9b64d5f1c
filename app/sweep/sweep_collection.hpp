// The results of a sweep's runs, together: tables and pictures.
#pragma once

#include "app/run/journal.hpp"
#include "app/sweep/sweep_plan.hpp"

namespace quicksand {

/// Write sweep.csv, sweep.png and, where the sweep asks for it, fragility.csv and fragility.png; say what the
/// runs came to. Throws InputError, FileError.
void collect_sweep(const SweepPlan& plan, Journal& journal);

} // namespace quicksand
