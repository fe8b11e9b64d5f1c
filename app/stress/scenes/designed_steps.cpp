#include "app/stress/scenes/designed_set.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

/// Up to 1 the scene says it itself, beyond that the laboratory takes the step.
void add_shares(const std::string& scheme, StressRows& rows)
{
    for (const double share : {0.5, 0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 2.0}) {
        SceneDraft scene = block_scene(scheme);
        if (share < 1.0) scene.set("analysis.step_share", share);
        StressRow row = block_row("steps", fmt::format("{}-{}", scheme, share), scene);
        if (share > 1.0) row.step_factor = share;
        row.measures_step = share == 1.0;
        rows.push_back(std::move(row));
    }
}

} // namespace

void add_step_rows(StressRows& rows)
{
    const auto schemes = {explicit_scheme, semi_implicit_scheme, dry_scheme};
    for (const char* scheme : schemes) add_shares(scheme, rows);
    for (const char* scheme : schemes) {
        for (const char* interpolation : {"cpdi2", "gimp", "cpgimp", "linear"}) {
            SceneDraft scene = block_scene(scheme);
            scene.set("analysis.interpolation", interpolation);
            rows.push_back(block_row("interpolations", fmt::format("{}-{}", scheme, interpolation), scene));
            rows.back().measures_step = true;
        }
        SceneDraft scene = block_scene(scheme);
        scene.set("analysis.strain", "small");
        rows.push_back(block_row("interpolations", fmt::format("{}-small_strain", scheme), scene));
        rows.back().measures_step = true;
    }
}

} // namespace quicksand
