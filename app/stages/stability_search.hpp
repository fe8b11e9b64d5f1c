// The search for the factor of safety of a body at rest, with its report and its files.
#pragma once

#include "app/run/journal.hpp"
#include "io/assembly/case_assembly.hpp"
#include "io/results/results_folder.hpp"
#include "solver/run/residual_strength.hpp"
#include "solver/run/strength_reduction.hpp"

namespace quicksand {

/// The file that says of a folder that it is that of a search.
inline constexpr const char* stability_report = "stability.txt";

/// Throws InputError where no soil has a strength that can be reduced.
void require_strength(const AssembledCase& assembled);

/// Throws InputError where the water beyond a curve is not that of the pores.
void require_still_water(const AssembledCase& assembled);

/// Let liquefied sand have its residual strength, and say how many particles that is. Nothing where the ratio
/// is zero.
void weaken_liquefied(const ResidualStrength& residual, AssembledCase& assembled, State& state,
                      Journal& journal);

/// A search that its user stopped after a trial (app/run/stop_signal.hpp).
struct SearchStopped {};

/// Reduce the strength from the state's stresses and pore pressures, tell every trial, and write the curve
/// and the mode of failure into the folder. Throws SearchStopped, NumericalError, FileError.
SafetyFactor search_stability(const AssembledCase& assembled, const StrengthReductionControls& controls,
                              State& state, const ResultsFolder& folder, Journal& journal);

/// Throws NumericalError where the body stands at no strength: as drawn it lacks a wall, while what a run has
/// left may be without strength.
void require_standing(const SafetyFactor& safety);

/// The factor that a search has left in a folder, 0 where the body stands at no strength; none where it has
/// not come to its end. Throws FileError.
std::optional<double> read_factor_of_safety(const ResultsFolder& folder);

} // namespace quicksand
