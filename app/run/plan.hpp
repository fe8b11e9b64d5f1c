// The text of `check`: what a run of the scene will be.
#pragma once

#include "app/run/scene_setup.hpp"
#include "app/run/trial.hpp"
#include "solver/run/patch_test.hpp"
#include "solver/run/staged_run.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// Every key with its value in SI and where it comes from.
std::string describe_scene_keys(const SceneSetup& setup);

/// Regions, particles, grid and masses.
std::string describe_soil(const AssembledCase& assembled);

/// What slides along what, and at which strength; "" without interfaces.
std::string describe_interfaces(const AssembledCase& assembled);

/// The conditions on every boundary curve, and the total force of every load.
std::string describe_boundaries(const AssembledCase& assembled, const std::vector<PatchTest>& tests);

/// Throws InputError where a curve that holds or carries something leaves more than two per cent of a
/// pressure on it unbalanced (solver/run/patch_test.hpp).
void refuse_failed_patches(const AssembledCase& assembled, const std::vector<PatchTest>& tests);

/// What the laws say of their materials; nothing where they have nothing to say.
std::string describe_laws(const AssembledCase& assembled);

/// What the initial state leaves out of balance, and what becomes of it.
std::string describe_initial_state(const AssembledCase& assembled);

/// What a run should be warned of about its shaking, for the journal.
std::vector<std::string> warnings_of_motion(const Scene& scene);

/// Peaks, intensity, duration and baseline of the shaking, and whether its peaks are seen; nothing without
/// any.
std::string describe_motion(const AssembledCase& assembled);

/// Wave speeds, the first time step of the shaking and what limits it.
std::string describe_time_step(const AssembledCase& assembled, const TimeStep& step);

/// Steps and time of a stage that settles.
std::string describe_settling_cost(const RelaxationForecast& forecast);

/// Steps, memory, disk and run time.
std::string describe_cost(const Forecast& forecast);

/// What the run of the scene, which starts from a state called `start`, does not need and is left out.
std::string describe_left_out(const Scene& scene, const StagedRun& run, const std::string& start);

/// "One column of 9 is computed ...", for the journal of a run.
std::string describe_column(const SoilColumn& column);

} // namespace quicksand
