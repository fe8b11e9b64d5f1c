// The designed set of the stability laboratory: one group of rows a question.
#pragma once

#include "app/stress/scenes/scene_draft.hpp"
#include "app/stress/scenes/stress_row.hpp"

namespace quicksand {

/// Schemes as a row's name has them; "dry" is the explicit one without water.
inline constexpr const char* explicit_scheme = "explicit";
inline constexpr const char* semi_implicit_scheme = "semi_implicit";
inline constexpr const char* dry_scheme = "dry";

/// Saturated elastic sand, 8 m by 8 m in cells of 1 m, between rollers on a fixed base that shakes with
/// 1 m/s2 and 5 Hz, for 0.3 s.
SceneDraft block_scene(const std::string& scheme);

/// A row on the block's drawing, or on another one.
StressRow block_row(const std::string& group, const std::string& name, const SceneDraft& scene);
StressRow drawn_row(const std::string& group, const std::string& name, const std::string& drawing,
                    const SceneDraft& scene);

/// Steps from 0.5 to 2 of the own one; every interpolation at its own one.
void add_step_rows(StressRows& rows);
/// Conductivity, water, porosity, Poisson's ratio, contrasts, particles in a cell, sand that has liquefied.
void add_soil_rows(StressRows& rows);
/// Every pair of boundaries at 30 to 180 degrees, at rest; slivers at walls and surfaces.
void add_corner_rows(StressRows& rows);
/// Sides that move into the soil and away from it, along and between grid lines; a base of which half moves.
void add_moving_rows(StressRows& rows);
/// Large shear, turning, leaving the grid, parting and meeting again; with `long_ones` a bar of 10^6 steps.
void add_motion_rows(bool long_ones, StressRows& rows);

/// All of them, group by group.
StressRows designed_rows(bool long_ones);

/// Names of the groups, with that of the random scenes.
std::vector<std::string> stress_groups();

} // namespace quicksand
