// Soil placed layer by layer settles as a column of elastic layers does: what lies above an interface when it
// is there moves it, what was there before does not.
#include "io/scene/scene_file.hpp"
#include "solver/run/staged_run.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr int layers = 4;
constexpr double height = 2.0, width = 3.0, cell = 0.5; // of a layer, of the column and of a cell [m]
constexpr double shear_modulus = 100e6, poisson = 0.25; // [Pa], [-]
constexpr double modulus = 2.0 * shear_modulus * (1.0 - poisson) / (1.0 - 2.0 * poisson); // M [Pa]
constexpr double grain_density = 2650.0, porosity = 0.4;

struct Drawing {
    Vector2 shift = Vector2::Zero(); // of the section in the grid [m]
    int particles = 2;               // across a cell [-]
    bool mirrored = false;
    std::string water = {}; // keys of [water] and its analysis
    std::string strain = "large";
    std::vector<std::vector<int>> steps = {{1}, {2}, {3}}; // layers that each stage places
};

std::string name_of(int layer)
{
    return "layer_" + std::to_string(layer);
}

Section stack(const Drawing& drawing)
{
    Section section;
    std::vector<Segment> left, right;
    const auto at = [&](double x, double y) -> Vector2 { return Vector2(x, y) + drawing.shift; };
    for (int k = 0; k < layers; ++k) {
        const double lower = k * height, upper = lower + height;
        section.regions.push_back(
            {name_of(k), {{{at(0.0, lower), at(width, lower), at(width, upper), at(0.0, upper)}, {}}}});
        left.push_back({at(0.0, upper), at(0.0, lower)});
        right.push_back({at(width, lower), at(width, upper)});
    }
    if (drawing.mirrored) std::reverse(section.regions.begin(), section.regions.end());
    section.curves = {{"base", {{at(0.0, 0.0), at(width, 0.0)}}},
                      {drawing.mirrored ? "right" : "left", left},
                      {drawing.mirrored ? "left" : "right", right}};
    bound_section(section);
    return section;
}

std::string scene_of(const Drawing& drawing)
{
    std::string text =
        "scene_version = 1\n[geometry]\nfile = \"drawing.geo\"\n[grid]\norigin = [-2.0, -2.0]\n"
        "cell_size = 0.5\ncells = [16, 28]\n[analysis]\nstrain = \"" +
        drawing.strain + "\"\n[sampling]\nparticles_per_cell = [" + std::to_string(drawing.particles) + ", " +
        std::to_string(drawing.particles) + "]\n" + drawing.water + base_and_sides +
        "[initial]\nk0 = 0.3333333333333333\n[relaxation]\ntolerance = 1e-9\n"
        "[materials.soil]\nmodel = \"linear_elastic\"\nshear_modulus = 100e6\n"
        "poisson_ratio = 0.25\ngrain_density = 2650\nporosity = 0.4\n";
    if (!drawing.water.empty()) text += "hydraulic_conductivity = 1e-4\n";
    for (int k = 0; k < layers; ++k) text += "[regions." + name_of(k) + "]\nmaterial = \"soil\"\n";
    text += "[[stages]]\nname = \"ground\"\nkind = \"settle\"\n";
    for (std::size_t s = 0; s < drawing.steps.size(); ++s) {
        std::string names;
        for (const int layer : drawing.steps[s])
            names += (names.empty() ? "\"" : ", \"") + name_of(layer) + '"';
        text += "[[stages]]\nname = \"step_" + std::to_string(s) + "\"\nkind = \"settle\"\nplace = [" +
                names + "]\n";
    }
    return text;
}

/// What the stages come to.
struct Build {
    std::vector<std::map<std::int32_t, Vector2>> begins, ends; // places by lasting number, of each stage [m]
    State state;                                               // at the end
};

std::map<std::int32_t, Vector2> places(const Particles& particles)
{
    std::map<std::int32_t, Vector2> places;
    for (std::size_t p = 0; p < particles.size(); ++p)
        places[particles.identifier[p]] = particles.position[p];
    return places;
}

Build build(const Drawing& drawing)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "drawing.geo") << "Point(1) = {0, 0, 0};\n";
    std::ofstream(folder / "scene.toml") << scene_of(drawing);
    Build result;
    for (SceneReading& reading : read_scene_stages(folder / "scene.toml", {})) {
        AssembledCase assembled = assemble_case(std::move(reading), stack(drawing));
        StagedRun run(assembled.problem, std::move(assembled.state), {0.0, ColumnsComputed::all, false});
        StageStart start;
        start.settles = true;
        if (!result.ends.empty()) run.go_on_from(std::move(result.state), start);
        result.begins.push_back(places(run.state().particles));
        run.settle(*assembled.scene.relaxation);
        result.ends.push_back(places(run.state().particles));
        result.state = run.state();
    }
    return result;
}

double unit_weight(const Drawing& drawing)
{
    const double buoyancy = drawing.water.empty() ? 0.0 : 1000.0;
    return (1.0 - porosity) * (grain_density - buoyancy) * standard_gravity;
}

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
    for (std::size_t s = 0; s < drawing.steps.size(); ++s) {
        const double placed = height * static_cast<double>(drawing.steps[s].size());
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
    at_once.steps = {{1, 2, 3}};
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

} // namespace
} // namespace quicksand
