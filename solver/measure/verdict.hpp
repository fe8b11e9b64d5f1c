// What a run's own balances say of it: good, usable or bad.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace quicksand {

enum class Grade { good, usable, bad };

/// A quantity of the body that is judged, by its largest amount over the run.
struct Criterion {
    std::string_view quantity; // name in the table of body_quantities.hpp
    std::string_view meaning;  // what a large one says
    double good = 0.0;         // up to here good [-]
    double usable = 0.0;       // up to here usable, bad beyond; infinite: never bad [-]
};

/// The energy and water that the scheme has lost or made (`numerical_loss_J` over the energy put in), strains
/// that small strain cannot tell, and pressures that change sign from cell to cell.
std::span<const Criterion> verdict_criteria();

/// The largest amount of a quantity over a run.
struct Finding {
    const Criterion* criterion = nullptr;
    double worst = 0.0; // NaN: the quantity was no number [-]
    double time = 0.0;  // when [s]
    Grade grade = Grade::good;
};

/// Judge the values at the times, row by row. With weights, a value counts by its weight over the largest
/// one: an error relative to little energy, as in the first steps, is little of what the run has turned over.
Finding judge(const Criterion& criterion, std::span<const double> times, std::span<const double> values,
              std::span<const double> weights = {});

/// The worst of them; good without any.
Grade worst_grade(const std::vector<Finding>& findings);

std::string_view name_of(Grade grade);

} // namespace quicksand
