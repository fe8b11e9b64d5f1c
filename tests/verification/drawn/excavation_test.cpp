// Soil that a stage removes: level elastic ground heaves as the weight that is taken away lets it, has the
// stress of what is left above it, and rests in the steps of every scheme.
#include "tests/fixtures/layer_stack.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures::layer_stack;

constexpr double drawn_top = layers * height; // of the ground as drawn [m]

/// Removes `depth` m from the top, in one stage or layer by layer.
Drawing excavation(int removed, bool at_once)
{
    Drawing drawing;
    drawing.changes.clear();
    std::vector<int> all;
    for (int k = layers - 1; k >= layers - removed; --k) {
        all.push_back(k);
        if (!at_once) drawing.changes.push_back({{}, {k}});
    }
    if (at_once) drawing.changes.push_back({{}, all});
    return drawing;
}

/// Vertical effective stress at a height z beneath ground up to a height, compression positive [Pa]. Above
/// `water`, a height, soil is dry.
double overburden(double ground, double z, double water)
{
    const double dry = (1.0 - porosity) * grain_density * standard_gravity,
                 buoyant = (1.0 - porosity) * (grain_density - 1000.0) * standard_gravity; // [N/m3]
    const double above = std::max(0.0, ground - std::max(z, water));
    return dry * above + buoyant * std::max(0.0, ground - z - above);
}

struct Errors {
    double heave = 0.0;  // over the largest heave of a stage [-]
    double stress = 0.0; // of the vertical and of the horizontal stress over that at the base before [-]
};

/// `water`: height of the water table in the drawing [m].
Errors errors_of(const Drawing& drawing, const Build& built, double water)
{
    Errors errors;
    double largest = 0.0, ground = drawn_top;
    for (std::size_t s = 0; s < drawing.changes.size(); ++s) {
        const double left = ground - height * static_cast<double>(drawing.changes[s].remove.size());
        const double unloading = overburden(ground, left, water);
        for (const auto& [number, place] : built.begins[s + 1]) {
            const double heave = built.ends[s + 1].at(number).y() - place.y();
            const double expected = unloading * (place.y() - drawing.shift.y()) / modulus;
            errors.heave = std::max(errors.heave, std::abs(heave - expected));
            largest = std::max(largest, expected);
        }
        ground = left;
    }
    errors.heave /= largest;
    const Particles& particles = built.settled.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double vertical = -overburden(ground, particles.position.y[p] - drawing.shift.y(), water);
        errors.stress =
            std::max({errors.stress, std::abs(particles.stress.yy[p] - vertical),
                      std::abs(particles.stress.xx[p] - vertical / 3.0), std::abs(particles.stress.xy[p])});
    }
    errors.stress /= overburden(drawn_top, 0.0, water);
    return errors;
}

TEST(Excavation, LetsLevelGroundHeave)
{
    for (const bool at_once : {false, true})
        for (const int particles : {2, 3}) {
            Drawing drawing = excavation(2, at_once);
            drawing.particles = particles;
            const Errors errors = errors_of(drawing, build(drawing), -1.0);
            EXPECT_LT(errors.heave, 0.01) << at_once << particles;
            EXPECT_LT(errors.stress, 0.03) << at_once << particles;
        }
}

TEST(Excavation, MayEndAnywhereInTheGrid)
{
    for (const int particles : {2, 3})
        for (const bool mirrored : {false, true}) {
            Drawing drawing = excavation(1, false);
            drawing.particles = particles;
            drawing.mirrored = mirrored;
            drawing.shift = {0.43 * cell, 0.37 * cell};
            const Errors errors = errors_of(drawing, build(drawing), -1.0);
            EXPECT_LT(errors.heave, 0.02) << particles << mirrored;
            EXPECT_LT(errors.stress, 0.05) << particles << mirrored;
        }
}

/// A water level in the drawing, and the keys that say it where the section lies [m].
Drawing wet_excavation(double level, const Vector2& shift)
{
    Drawing drawing = excavation(2, false);
    drawing.shift = shift;
    drawing.water = "[water]\nlevel = " + std::to_string(level + shift.y()) + "\n";
    drawing.scheme = "semi_implicit";
    return drawing;
}

// Under water, and with a pit that ends above, at and below the water level.
TEST(Excavation, HeavesByWhatTheSoilWeighsInWater)
{
    for (const Vector2& shift : {Vector2(0.0, 0.0), Vector2(0.43 * cell, 0.37 * cell)})
        for (const double level : {10.0, 5.0, 4.0, 3.0}) {
            const Drawing drawing = wet_excavation(level, shift);
            const Build built = build(drawing);
            const Errors errors = errors_of(drawing, built, level);
            EXPECT_LT(errors.heave, 0.02) << level << ' ' << shift.x();
            EXPECT_LT(errors.stress, 0.05) << level << ' ' << shift.x();
            const Scalars& pressure = built.settled.particles.pore_pressure;
            EXPECT_TRUE(std::all_of(pressure.begin(), pressure.end(), [](double p) { return p == 0.0; }));
        }
}

TEST(Excavation, LeavesGroundAtRestInEveryScheme)
{
    for (const Vector2& shift : {Vector2(0.0, 0.0), Vector2(0.43 * cell, 0.37 * cell)})
        for (const double level : {-1.0, 10.0, 3.0})
            for (const std::string scheme : {"explicit", "semi_implicit", "implicit"}) {
                Drawing drawing = wet_excavation(level, shift);
                if (level < 0.0 && scheme == "semi_implicit") continue; // dry
                if (level < 0.0) drawing.water.clear();
                drawing.scheme = scheme;
                drawing.rest = 0.05;
                const Unrest unrest = unrest_of(drawing, build(drawing));
                EXPECT_LT(unrest.velocity, 1e-6) << scheme << ' ' << level << ' ' << shift.x();
                EXPECT_LT(unrest.stress, 1e-5) << scheme << ' ' << level << ' ' << shift.x();
            }
}

} // namespace
} // namespace quicksand
