#include "app/commands/commands.hpp"
#include "io/element/sand_calibration.hpp"
#include "io/keys/scene_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

namespace quicksand {

namespace {

constexpr double poor_fit = 0.7; // ln of 2: twice or half the cycles

/// "12.4", or ">49" where the test ended before.
std::string cycles_text(double cycles, const StrengthObservation& point)
{
    return cycles > longest_test(point) ? fmt::format(">{:.3g}", longest_test(point))
                                        : fmt::format("{:.3g}", cycles);
}

void print_points(const std::vector<StrengthObservation>& points, const SandCalibration& fit)
{
    std::cout << "    CSR   alpha      k0  s'v kPa  N measured   before   fitted\n";
    for (std::size_t k = 0; k < points.size(); ++k) {
        const StrengthObservation& point = points[k];
        std::cout << fmt::format("{:7.4g} {:7.3g} {:7.3g} {:8.4g} {:11.4g} {:>8} {:>8}\n", point.csr,
                                 point.static_shear_ratio, point.k0, 1e-3 * point.vertical_stress,
                                 point.cycles, cycles_text(fit.cycles_before[k], point),
                                 cycles_text(fit.cycles_after[k], point));
    }
}

/// "materials.sand.h" -> "h"
std::string last_word(const std::string& path)
{
    return path.substr(path.rfind('.') + 1);
}

} // namespace

ExitCode calibrate_sand(const CalibrateChoice& choice)
{
    const std::vector<StrengthObservation> points =
        read_observations(choice.data, conditions_of_first_test(choice.file, choice.overrides));
    const SandCalibration fit = calibrate_sand(choice.file, choice.overrides, choice.keys, points);
    print_points(points, fit);
    const auto percent = [](double error) { return 100.0 * (std::exp(error) - 1.0); };
    std::cout << fmt::format(
        "Cycles differ by {:.0f} % before and {:.0f} % fitted (root mean square of ln N; {} "
        "evaluations)\n{}\nFor the scene:\n",
        percent(fit.error_before), percent(fit.error_after), fit.evaluations,
        fit.error_after > poor_fit
            ? "Warning: no values of these keys give such points; look at the data, or "
              "fit other keys\n"
            : "");
    const std::string& path = fit.keys.front().path;
    std::cout << "[" << path.substr(0, path.rfind('.')) << "]\n";
    for (const FittedKey& key : fit.keys)
        std::cout << fmt::format("{} = {:.4g} # was {:.4g}\n", last_word(key.path), key.value, key.start);
    return ExitCode::good;
}

} // namespace quicksand
