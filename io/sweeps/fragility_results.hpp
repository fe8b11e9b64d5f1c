// A sweep's fragility: the runs counted, the curve through them, its table and its picture.
#pragma once

#include "io/pictures/line_plot.hpp"
#include "io/sweeps/fragility_fit.hpp"
#include "io/sweeps/sweep_outcomes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// The runs of one intensity.
struct FragilityLevel {
    double intensity = 0.0; // SI
    int runs = 0, exceeding = 0;
    double share() const { return static_cast<double>(exceeding) / runs; }
};

struct FragilityResults {
    std::size_t varied = 0;             // number of the varied key that is the intensity
    std::string unit;                   // of the intensity, SI
    std::vector<FragilityLevel> levels; // by intensity
    int left_out = 0;                   // runs that are not finished or have no value
    FragilityFit fit;
};

/// Throws InputError where no run will have the quantity of the sweep's fragility curve; before any run.
void require_quantity(const Sweep& sweep, const std::vector<CheckedRun>& runs);

/// Throws InputError where an intensity of the sweep's fragility curve is not above 0; before any run.
void require_intensities(const Sweep& sweep, const std::vector<CheckedRun>& runs);

/// Count the finished runs. Throws InputError where no run has the quantity.
FragilityResults assess_fragility(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes);

/// "median 0.213 g, beta 0.41", or why there is no curve.
std::string describe_fragility(const FragilityResults& results);

/// One row an intensity, with the curve's probability there. Throws FileError.
void write_fragility_csv(const std::filesystem::path& path, const Sweep& sweep,
                         const FragilityResults& results);

LinePlot fragility_plot(const Sweep& sweep, const std::vector<SweepOutcome>& outcomes,
                        const FragilityResults& results);

} // namespace quicksand
