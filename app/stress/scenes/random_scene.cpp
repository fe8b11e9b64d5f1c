#include "app/stress/scenes/random_scene.hpp"

#include "app/stress/scenes/random_section.hpp"
#include "app/stress/scenes/random_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double one_g = standard_gravity;

/// What the parts of a scene have to know of each other.
struct Course {
    double factor = 1.0;   // gravity over one g, and lengths of a prototype over the model's [-]
    double stiffest = 0.0; // largest constrained modulus [Pa]
    double least_porosity = 1.0;
    bool can_settle = true;
    bool has_water = false, flows = false, has_pressure = false;
    double level = 0.0;    // of the water [m]
    double duration = 0.0; // of the run [s]
};

void set_elastic(const std::string& table, RandomNumbers& random, SceneDraft& scene, Course& course)
{
    const double shear = random.logarithmic(1e6, 1e9);
    const double nu = random.one_of({0.0, 0.2, 0.3, 0.3, 0.4, 0.45, 0.49});
    scene.set(table + ".shear_modulus", shear).set(table + ".poisson_ratio", nu);
    course.stiffest = std::max(course.stiffest, 2.0 * shear * (1.0 - nu) / (1.0 - 2.0 * nu));
}

void set_strength(const std::string& table, RandomNumbers& random, SceneDraft& scene)
{
    const bool friction = random.chance(0.75);
    const double angle = friction ? random.between(15.0, 45.0) : 0.0;
    scene.set(table + ".friction_angle", angle);
    if (!friction || random.chance(0.6)) scene.set(table + ".cohesion", random.logarithmic(3e2, 1e5));
    if (friction && random.chance(0.3)) scene.set(table + ".dilation_angle", angle * random.fraction());
    if (random.chance(0.2)) scene.set(table + ".tension_strength", 0.0);
}

void set_sand(const std::string& table, RandomNumbers& random, SceneDraft& scene, Course& course)
{
    const int kind = random.whole(0, 2);
    if (kind == 0) scene.set(table + ".preset", "nevada_sand_dr55");
    if (kind == 1) scene.set(table + ".relative_density", random.between(0.3, 0.85));
    if (kind == 2) scene.set(table + ".n1_60", random.between(4.0, 30.0));
    course.stiffest = std::max(course.stiffest, 6e8);
}

void set_soil(const std::string& name, RandomNumbers& random, SceneDraft& scene, Course& course)
{
    const std::string table = "materials." + name;
    const double draw = random.fraction();
    const bool sand = draw < 0.35;
    scene.set(table + ".model", sand          ? "ubcsand"
                                : draw < 0.65 ? "mohr_coulomb"
                                : draw < 0.95 ? "linear_elastic"
                                              : "neo_hookean");
    if (draw >= 0.95) course.can_settle = false; // neo-Hookean soil is free of stress as drawn
    if (sand) {
        set_sand(table, random, scene, course);
    } else {
        set_elastic(table, random, scene, course);
    }
    if (!sand && draw < 0.65) set_strength(table, random, scene);
    const double porosity = sand ? random.between(0.35, 0.5) : random.between(0.2, 0.7);
    scene.set(table + ".porosity", porosity);
    course.least_porosity = std::min(course.least_porosity, porosity);
    if (random.chance(0.3)) scene.set(table + ".grain_density", random.between(2000.0, 3300.0));
    if (random.chance(0.15)) scene.set(table + ".volumetric_strain", random.one_of({"cell", "particle"}));
    if (course.flows) {
        scene.set(table + ".hydraulic_conductivity", random.logarithmic(1e-9, 1e-1));
        if (random.chance(0.2)) scene.set(table + ".permeability_law", "kozeny_carman");
    }
    if (course.has_water && random.chance(0.3))
        scene.set(table + ".saturation_above_water", random.fraction());
}

void set_soils(const RandomSection& section, RandomNumbers& random, SceneDraft& scene, Course& course)
{
    const int count = std::min(random.whole(1, 3), static_cast<int>(section.regions.size()));
    for (int k = 0; k < count; ++k) set_soil(fmt::format("soil_{}", k + 1), random, scene, course);
    for (std::size_t k = 0; k < section.regions.size(); ++k) {
        const int soil = std::min(static_cast<int>(k) + 1, count);
        scene.set("regions." + section.regions[k] + ".material", fmt::format("soil_{}", soil));
    }
}

/// K_w of water with air at atmospheric pressure, as the scene has it [Pa].
double modulus_of(double saturation)
{
    return 1.0 / (saturation / 2.2e9 + (1.0 - saturation) / 1e5);
}

/// Returns the modulus of the water.
double set_water(const RandomSection& section, RandomNumbers& random, SceneDraft& scene, Course& course)
{
    course.has_water = random.chance(0.88);
    if (!course.has_water) return 0.0;
    const double draw = random.fraction();
    course.flows = draw < 0.75;
    course.has_pressure = draw < 0.9;
    course.level = section.lowest + section.height * random.between(0.2, 2.0);
    scene.set("water.level", course.level);
    if (!course.flows) scene.set("water.flow", course.has_pressure ? "undrained" : "drained");
    if (course.has_pressure && random.chance(0.15))
        scene.set("water.cavitation_pressure", random.one_of({0.0, 2e3}));
    if (!course.has_pressure || !random.chance(0.4)) return 2.2e9;
    const double saturation = 1.0 - random.logarithmic(1e-4, 0.15);
    scene.set("water.saturation", saturation);
    return modulus_of(saturation);
}

/// As long as some hundred steps at the speed of sound.
double duration_of(const RandomSection& section, double water_modulus, const Course& course,
                   RandomNumbers& random)
{
    const double n = course.least_porosity;
    const double mixture = (1.0 - n) * 2650.0 + (course.has_water ? n * 1000.0 : 0.0);
    const double pressure = course.has_pressure ? water_modulus / n : 0.0;
    const double speed = std::sqrt((course.stiffest + pressure) / mixture);
    return 0.6 * section.cell_size / speed * random.between(150.0, 400.0);
}

void set_analysis(RandomNumbers& random, SceneDraft& scene)
{
    const bool mesh = random.chance(0.15);
    if (random.chance(0.4))
        scene.set("analysis.interpolation",
                  mesh ? "cpdi2" : random.one_of({"cpdi2", "gimp", "cpgimp", "linear", "linear"}));
    if (random.chance(0.12)) scene.set("analysis.strain", "small");
    if (random.chance(0.3)) scene.set("analysis.columns", "all");
    if (mesh) {
        scene.set("sampling.kind", "mesh");
    } else {
        scene.set_whole("sampling.particles_per_cell", random.whole(1, 4), random.whole(1, 4));
    }
}

void set_start(const Course& course, double cell_size, RandomNumbers& random, SceneDraft& scene)
{
    scene.set("initial.k0", random.between(0.3, 1.0));
    if (course.has_pressure && random.chance(0.15))
        scene.set("initial.excess_pore_pressure", random.logarithmic(1e2, 3e4));
    if (random.chance(0.3) && course.can_settle) {
        scene.set("relaxation.tolerance", random.logarithmic(1e-4, 1e-2));
        scene.set("relaxation.max_steps", 30000.0);
    }
    if (random.chance(0.5)) {
        scene.set("grid.cell_size", cell_size); // a chosen one would resolve the short waves
        scene.set("motion.kind", "sine");
        scene.set("motion.amplitude", course.factor * one_g * random.logarithmic(0.01, 0.5));
        scene.set("motion.frequency", random.between(0.5, 6.0) / course.duration);
    }
}

void set_output(const Course& course, SceneDraft& scene)
{
    scene.set("run.end_time", course.duration);
    scene.set("output.frame_interval", 0.5 * course.duration);
    scene.set("output.history_interval", 0.05 * course.duration);
    scene.set("output.probe_interval", 0.05 * course.duration);
}

} // namespace

StressRows random_rows(std::uint64_t seed, int number)
{
    RandomNumbers random(seed, static_cast<std::uint64_t>(number));
    Course course;
    course.factor = random.one_of({1.0, 1.0, 1.0, 20.0, 50.0, 120.0});
    const double cell_size = random.logarithmic(0.2, 2.0) / course.factor;
    const RandomSection section = draw_random_section(cell_size, random);
    SceneDraft scene;
    scene.set("scene_version", 1.0).set("geometry.file", "section.geo");
    if (!random.chance(0.1)) scene.set("grid.cell_size", cell_size);
    scene.set("gravity.acceleration", course.factor * one_g);
    set_analysis(random, scene);
    const double modulus = set_water(section, random, scene, course);
    set_soils(section, random, scene, course);
    course.duration = duration_of(section, modulus, course, random);
    const double weight = 1500.0 * course.factor * one_g * section.height;
    const bool is_submerged = course.level > section.highest + 0.3 * section.height;
    set_random_walls(section, {course.duration, weight, course.level, course.has_pressure, is_submerged},
                     random, scene);
    set_start(course, cell_size, random, scene);
    set_output(course, scene);

    const auto row_of = [&](const std::string& scheme) {
        StressRow row;
        row.group = "random";
        row.name = fmt::format("{}-{:04}-{}", seed, number, scheme);
        row.drawing = section.draft.text();
        row.scene = scene.text("quicksand stress: " + row.id());
        return row;
    };
    StressRows rows;
    if (course.flows) {
        scene.set("analysis.scheme", "explicit");
        rows = {row_of("explicit")};
        scene.set("analysis.scheme", "semi_implicit");
        rows.push_back(row_of("semi_implicit"));
        rows.back().twin = rows.front().name;
    } else {
        scene.set("analysis.scheme", "explicit");
        rows = {row_of("single")};
    }
    if (!course.flows && course.has_pressure)
        return rows; // water that moves with the grains has no implicit steps
    scene.set("analysis.scheme", "implicit");
    rows.push_back(row_of("implicit"));
    return rows;
}

} // namespace quicksand
