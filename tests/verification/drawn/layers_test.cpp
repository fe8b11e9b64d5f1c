// Soil placed layer by layer settles as a column of elastic layers does: what lies above an interface when it
// is there moves it, what was there before does not.
#include "tests/fixtures/layer_stack.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using namespace fixtures::layer_stack;

/// Settlement in the stage that places soil of thickness `placed` on ground of height `ground`, at a height z
/// [m].
double settlement(double weight, double ground, double placed, double z)
{
    if (z <= ground) return weight * placed * z / modulus;
    const double above = z - ground;
    return weight * (placed * ground + placed * above - 0.5 * above * above) / modulus;
}

/// Largest error of the settlements of all stages over the largest settlement [-].
double error_of_settlements(const Drawing& drawing, const Build& built)
{
    const double weight = unit_weight(drawing);
    double error = 0.0, largest = 0.0, ground = height;
    for (std::size_t s = 0; s < drawing.changes.size(); ++s) {
        const double placed = height * static_cast<double>(drawing.changes[s].place.size());
        for (const auto& [number, place] : built.begins[s + 1]) {
            const double moved = place.y() - built.ends[s + 1].at(number).y();
            const double expected = settlement(weight, ground, placed, place.y() - drawing.shift.y());
            error = std::max(error, std::abs(moved - expected));
            largest = std::max(largest, expected);
        }
        ground += placed;
    }
    return error / largest;
}

/// Largest error of the stresses at the end over that at the base [-].
double error_of_stresses(const Drawing& drawing, const Build& built)
{
    const double weight = unit_weight(drawing), top = layers * height;
    const Particles& particles = built.state.particles;
    double error = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double vertical = -weight * (top - (particles.position.y[p] - drawing.shift.y()));
        error =
            std::max({error, std::abs(particles.stress.yy[p] - vertical),
                      std::abs(particles.stress.xx[p] - vertical / 3.0), std::abs(particles.stress.xy[p])});
    }
    return error / (weight * top);
}

TEST(Layers, SettleAsAColumnBuiltInSteps)
{
    for (const int particles : {2, 3}) {
        Drawing drawing;
        drawing.particles = particles;
        const Build built = build(drawing);
        EXPECT_LT(error_of_settlements(drawing, built), 0.01) << particles;
        EXPECT_LT(error_of_stresses(drawing, built), 0.03) << particles; // half a particle of its own weight
    }
}

TEST(Layers, OfAnInterfaceCountWhatIsPlacedAfterIt)
{
    const Drawing drawing;
    const Build built = build(drawing);
    const double weight = unit_weight(drawing);
    for (int interface = 1; interface < layers; ++interface) {
        double moved = 0.0, expected = 0.0, nearest = 1.0;
        std::int32_t number = 0; // of a particle beneath the interface
        for (const auto& [candidate, place] : built.begins.back()) {
            const double below = interface * height - place.y();
            if (below > 0.0 && below < nearest) {
                nearest = below;
                number = candidate;
            }
        }
        const double z = built.begins.back().at(number).y();
        for (std::size_t s = static_cast<std::size_t>(interface); s < built.ends.size(); ++s) {
            moved += built.begins[s].at(number).y() - built.ends[s].at(number).y();
            expected += weight * height * z / modulus;
        }
        EXPECT_NEAR(moved, expected, 0.005 * expected) << "interface " << interface;
    }
}

TEST(Layers, InOneStepMoveAsTheirNumberSays)
{
    Drawing at_once;
    at_once.changes = {{{1, 2, 3}}};
    const Build built = build(at_once);
    EXPECT_LT(error_of_settlements(at_once, built), 0.01);
    EXPECT_LT(error_of_stresses(at_once, built), 0.03);
}

TEST(Layers, MayLieAnywhereInTheGrid)
{
    for (const int particles : {2, 3}) {
        for (const bool mirrored : {false, true}) {
            Drawing drawing;
            drawing.particles = particles;
            drawing.mirrored = mirrored;
            drawing.shift = {0.43 * cell, 0.37 * cell};
            const Build built = build(drawing);
            EXPECT_LT(error_of_settlements(drawing, built), 0.02) << particles << mirrored;
            EXPECT_LT(error_of_stresses(drawing, built), 0.05) << particles << mirrored;
        }
    }
}

TEST(Layers, PlacedUnderWaterWeighLess)
{
    Drawing drawing;
    drawing.water = "[water]\nlevel = 10.0\n";
    const Build built = build(drawing);
    EXPECT_LT(error_of_settlements(drawing, built), 0.01);
    EXPECT_LT(error_of_stresses(drawing, built), 0.03);
    const Scalars& pressure = built.state.particles.pore_pressure;
    EXPECT_TRUE(std::all_of(pressure.begin(), pressure.end(), [](double p) { return p == 0.0; }));
}

TEST(Layers, InSmallStrainLieWhereTheyAreDrawn)
{
    Drawing drawing;
    drawing.strain = "small";
    const Build built = build(drawing);
    EXPECT_LT(error_of_stresses(drawing, built), 0.03);
    for (std::size_t s = 1; s < built.begins.size(); ++s)
        for (const auto& [number, place] : built.begins[s - 1]) EXPECT_EQ(place, built.begins[s].at(number));
}

/// Largest error of the mean stresses of the rows of cells at the end over the stress at the base: K0 = 1/2
/// below level ground. Within a cell, whose strain is one, sand that is stiffer takes more.
double error_of_sand(const Drawing& drawing, const Build& built)
{
    const double weight = unit_weight(drawing), top = layers * height;
    const Particles& particles = built.settled.particles;
    struct Row {
        double volume = 0.0, vertical = 0.0, horizontal = 0.0; // [m3/m], errors times volume [N m/m]
    };
    std::map<int, Row> rows;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p], volume = particles.volume[p];
        const double expected = -weight * (top - (y - drawing.shift.y()));
        Row& row = rows[static_cast<int>(std::floor(y / cell))];
        row.volume += volume;
        row.vertical += volume * (particles.stress.yy[p] - expected);
        row.horizontal += volume * (particles.stress.xx[p] - 0.5 * expected);
    }
    double error = 0.0;
    for (const auto& [number, row] : rows)
        error = std::max({error, std::abs(row.vertical / row.volume), std::abs(row.horizontal / row.volume)});
    return error / (weight * top);
}

TEST(Layers, OfSandAreAtRestWhereTheyArePlaced)
{
    for (const std::string model : {"ubcsand", "pm4sand"})
        for (const Vector2& shift : {Vector2(0.0, 0.0), Vector2(0.43 * cell, 0.37 * cell)})
            for (const std::string scheme : {"explicit", "semi_implicit", "implicit"}) {
                Drawing drawing;
                drawing.law = "model = \"" + model + "\"\nrelative_density = 0.6\n";
                drawing.k0 = "0.5";
                drawing.shift = shift;
                drawing.water = "[water]\nlevel = 10.0\n";
                drawing.scheme = scheme;
                drawing.rest = 0.05;
                const Build built = build(drawing);
                const Unrest unrest = unrest_of(drawing, built);
                EXPECT_LT(error_of_sand(drawing, built), shift.x() > 0.0 ? 0.05 : 0.03)
                    << model << ' ' << shift.x();
                EXPECT_LT(unrest.velocity, 1e-6) << model << ' ' << scheme << ' ' << shift.x();
                EXPECT_LT(unrest.stress, 1e-4) << model << ' ' << scheme << ' ' << shift.x();
            }
}

} // namespace
} // namespace quicksand
