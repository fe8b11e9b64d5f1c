// A short measured trial of a run: what its steps, its settling and its output will cost.
#pragma once

#include "io/assembly/case_assembly.hpp"
#include "solver/run/staged_run.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

namespace quicksand {

/// Settling before the shaking.
struct RelaxationForecast {
    bool needed = false;
    bool reliable = false;     // false: the trial was too short to see the end
    std::int64_t steps = 0;    // [-]
    double step_seconds = 0.0; // wall time of a step [s]

    double seconds() const { return static_cast<double>(steps) * step_seconds; }
};

struct OutputForecast {
    std::int64_t frames = 0;         // of fields.pvd, and as many of grid.pvd [-]
    double seconds = 0.0;            // wall time that all output takes from the run's threads [s]
    double background_seconds = 0.0; // of the thread that writes frames while the run goes on [s]
    bool has_own_core = false;       // that thread, beside those of the run
    double bytes = 0.0;              // of the results folder at the end [byte]
};

struct Forecast {
    std::int64_t steps = 0;    // of the shaking [-]
    double step_seconds = 0.0; // wall time of a step [s]
    RelaxationForecast relaxation;
    OutputForecast output;
    double memory = 0.0; // most that this process has held so far [byte]

    double shaking_seconds() const { return static_cast<double>(steps) * step_seconds; }
    double seconds() const
    {
        const double shaking = shaking_seconds() + output.seconds;
        return relaxation.seconds() + (output.has_own_core ? std::max(shaking, output.background_seconds)
                                                           : shaking + output.background_seconds);
    }
};

/// Steps that a run takes that begins with one, which it shortens so that the output times are hit.
std::int64_t count_steps(const AssembledCase& assembled, const TimeStep& step);

/// Let the run settle for a few seconds: it then stands where the trial ended.
RelaxationForecast forecast_settling(const RelaxationControls& controls, StagedRun& run);

/// Let copies of the run of the scene go on for a few seconds and write a few frames into a folder of their
/// own in `directory`, which is removed again: so the disk of the results is measured. `step` is the first
/// one of the shaking. Throws FileError.
Forecast forecast_run(const AssembledCase& assembled, const StagedRun& run, const TimeStep& step,
                      const std::filesystem::path& directory);

} // namespace quicksand
