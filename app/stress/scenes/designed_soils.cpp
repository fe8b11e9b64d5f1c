#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/section_draft.hpp"

#include <fmt/format.h>

#include <array>

namespace quicksand {

namespace {

constexpr std::array wet_schemes = {explicit_scheme, semi_implicit_scheme};

/// A row of the block at its own step, whose margin is measured.
void add_measured(const std::string& group, const std::string& name, const SceneDraft& scene,
                  StressRows& rows)
{
    rows.push_back(block_row(group, name, scene));
    rows.back().measures_step = true;
}

/// One key of the block over values, in the schemes given.
template <class Schemes>
void add_key_rows(const std::string& group, const std::string& key, const std::vector<double>& values,
                  const Schemes& schemes, StressRows& rows)
{
    for (const char* scheme : schemes) {
        for (const double value : values) {
            SceneDraft scene = block_scene(scheme);
            scene.set(key, value);
            add_measured(group, fmt::format("{}-{:g}", scheme, value), scene, rows);
        }
    }
}

/// Water with air, and stiffer than any.
void add_water_rows(StressRows& rows)
{
    add_key_rows("saturation", "water.saturation", {0.9, 0.95, 0.99, 0.999}, wet_schemes, rows);
    for (const char* scheme : wet_schemes) {
        SceneDraft scene = block_scene(scheme);
        scene.set("water.saturation", 0.99).set("materials.soil.shear_modulus", 1e9);
        add_measured("saturation", fmt::format("{}-0.99-stiff", scheme), scene, rows);
    }
    add_key_rows("water_modulus", "water.bulk_modulus", {2.2e8, 2.2e10, 2.2e11}, wet_schemes, rows);
}

/// The block in two layers whose moduli or densities differ; "soil" is above.
void add_contrast_rows(StressRows& rows)
{
    SectionDraft section;
    section.add_region("below", {{{0, 0}, "base"}, {{8, 0}, "right"}, {{8, 3.4}, ""}, {{0, 3.4}, "left"}});
    section.add_region("soil", {{{0, 3.4}, ""}, {{8, 3.4}, "right"}, {{8, 8}, "surface"}, {{0, 8}, "left"}});
    const auto add = [&](const char* scheme, const std::string& name, double modulus, double density) {
        SceneDraft scene = block_scene(scheme);
        scene.set("materials.below.model", "linear_elastic")
            .set("materials.below.porosity", 0.4)
            .set("materials.below.shear_modulus", modulus)
            .set("materials.below.poisson_ratio", 0.3)
            .set("materials.below.grain_density", density)
            .set("regions.below.material", "below");
        if (scheme != dry_scheme) scene.set("materials.below.hydraulic_conductivity", 1e-3);
        rows.push_back(drawn_row("contrasts", fmt::format("{}-{}", scheme, name), section.text(), scene));
        rows.back().measures_step = true;
    };
    for (const char* scheme : {explicit_scheme, semi_implicit_scheme, dry_scheme}) {
        for (const double ratio : {1e-3, 1e-2, 1e2, 1e3})
            add(scheme, fmt::format("stiffness-{:g}", ratio), 5e7 * ratio, 2650.0);
        for (const double ratio : {0.5, 10.0, 1000.0})
            add(scheme, fmt::format("density-{:g}", ratio), 5e7, 2650.0 * ratio);
    }
}

void add_particle_rows(StressRows& rows)
{
    for (const char* scheme : {explicit_scheme, semi_implicit_scheme, dry_scheme}) {
        for (const auto& [x, y] : {std::pair(1, 1), {2, 2}, {3, 3}, {4, 4}, {5, 5}, {1, 5}, {5, 1}, {2, 4}}) {
            SceneDraft scene = block_scene(scheme);
            scene.set_whole("sampling.particles_per_cell", x, y);
            add_measured("particles", fmt::format("{}-{}x{}", scheme, x, y), scene, rows);
        }
    }
}

/// Loose sand that has lost its strength, or loses it, below a load.
void add_liquefied_rows(StressRows& rows)
{
    for (const char* scheme : wet_schemes) {
        for (const double excess : {0.0, 2e4, 4e4, 8e4}) {
            SceneDraft scene = block_scene(scheme);
            for (const char* key : {"shear_modulus", "poisson_ratio"})
                scene.remove(std::string("materials.soil.") + key);
            scene.set("materials.soil.model", "ubcsand")
                .set("materials.soil.relative_density", 0.4)
                .set("materials.soil.hydraulic_conductivity", 1e-4)
                .set("boundaries.surface.pressure", 2e4)
                .set("boundaries.surface.ramp_time", 0.2)
                .set("motion.amplitude", 3.0)
                .set("run.end_time", 0.8)
                .set("output.history_interval", 0.02);
            if (excess > 0.0) scene.set("initial.excess_pore_pressure", excess);
            rows.push_back(block_row("liquefied", fmt::format("{}-{:g}_kPa", scheme, 1e-3 * excess), scene));
        }
    }
}

} // namespace

void add_soil_rows(StressRows& rows)
{
    add_key_rows("conductivity", "materials.soil.hydraulic_conductivity",
                 {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0}, wet_schemes, rows);
    add_water_rows(rows);
    add_key_rows("porosity", "materials.soil.porosity", {0.2, 0.3, 0.5, 0.6, 0.7}, wet_schemes, rows);
    add_key_rows("poisson", "materials.soil.poisson_ratio", {0.0, 0.2, 0.4, 0.45, 0.48, 0.49},
                 std::array{explicit_scheme, semi_implicit_scheme, dry_scheme}, rows);
    add_contrast_rows(rows);
    add_particle_rows(rows);
    add_liquefied_rows(rows);
}

} // namespace quicksand
