#include "solver/measure/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace quicksand {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// The examples that do not churn lose less than 1e-3 of their energy and 2e-4 of their water; the sea dike
// under 100 g, whose crest splashes, 6e-3 of its water. Runs whose step was too long lost tenths of both.
// Terms of second order in the strain are a tenth of it at 0.1.
// Of 600 random scenes the sound ones lose up to 0.8 of the energy that is put in, those that blow up 36 to
// 1,900 times it: energy that their steps make in the soil.
constexpr std::array criteria = {
    Criterion{"energy_error", "energy is lost or made by the steps", 0.01, 0.1},
    Criterion{"water_error", "water is lost or made by the steps", 1e-3, 0.01},
    Criterion{"numerical_loss_J", "more is lost between particles and grid than was put in", 2.0, 10.0},
    Criterion{"max_strain", "strains are beyond what analysis.strain = \"small\" can tell", 0.1, never},
    Criterion{"mean_stress_checkerboard", "mean stresses of neighbouring cells disagree", 0.1, never},
    Criterion{"pore_pressure_checkerboard", "pore pressures of neighbouring cells disagree", 0.1, never},
};

Grade grade_of(const Criterion& criterion, double worst)
{
    if (worst <= criterion.good) return Grade::good;
    return worst <= criterion.usable ? Grade::usable : Grade::bad; // also what is no number
}

} // namespace

std::span<const Criterion> verdict_criteria()
{
    return criteria;
}

Finding judge(const Criterion& criterion, std::span<const double> times, std::span<const double> values,
              std::span<const double> weights)
{
    Finding finding{&criterion};
    const double heaviest = weights.empty() ? 1.0 : *std::max_element(weights.begin(), weights.end());
    for (std::size_t row = 0; row < std::min(times.size(), values.size()); ++row) {
        const double weight = weights.empty() || !(heaviest > 0.0) ? 1.0 : weights[row] / heaviest;
        const double size = weight * std::abs(values[row]);
        if (size <= finding.worst) continue;
        finding.worst = size; // NaN, too
        finding.time = times[row];
        if (std::isnan(size)) break;
    }
    finding.grade = grade_of(criterion, finding.worst);
    return finding;
}

Grade worst_grade(const std::vector<Finding>& findings)
{
    Grade worst = Grade::good;
    for (const Finding& finding : findings) worst = std::max(worst, finding.grade);
    return worst;
}

std::string_view name_of(Grade grade)
{
    constexpr std::array<std::string_view, 3> names = {"good", "usable", "bad"};
    return names.at(static_cast<std::size_t>(grade));
}

} // namespace quicksand
