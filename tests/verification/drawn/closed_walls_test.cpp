// Sealed bodies of any shape keep a constant pressure, a wall that moves through the grid feels no grid
// lines, one that starts at once makes no energy at any angle, and one that goes round, as that of a culvert,
// is the same wherever its drawing begins.
#include "solver/measure/balances.hpp"
#include "solver/step/stepper.hpp"
#include "solver/step_length/time_step_control.hpp"
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace quicksand {
namespace {

using namespace fixtures;

const std::string saturated = R"([sampling]
particles_per_cell = [2, 2]
[gravity]
acceleration = 0.0
[water]
level = 20.0
[materials.soil]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
porosity = 0.4
hydraulic_conductivity = 1e-4
[regions.soil]
material = "soil"
)";

/// All edges sealed rollers, with their tables.
struct SealedBody {
    Section section;
    std::string tables;
};

SealedBody sealed_body(const std::vector<Vector2>& corners, const std::string& tables)
{
    std::vector<NamedCorner> named;
    std::string with_edges = tables;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        named.push_back({corners[k], "edge" + std::to_string(k)});
        with_edges += "[boundaries.edge" + std::to_string(k) + "]\nsoil = \"roller\"\n";
    }
    return {polygon_section(named), with_edges};
}

/// Largest relative deviation of a pressure of 10 kPa in the body after 1,000 steps.
double deviation_in(const SealedBody& body, const std::string& scheme)
{
    AssembledCase assembled = assemble(
        scene_with(0.25, {-0.55, -0.45}, 26, 22, "[analysis]\nscheme = \"" + scheme + "\"\n" + body.tables),
        body.section);
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    std::fill(state.particles.pore_pressure.begin(), state.particles.pore_pressure.end(), 1e4);
    const auto stepper = make_stepper(assembled.problem);
    for (int step = 0; step < 1000; ++step)
        stepper->advance(assembled.problem, stable_time_step(assembled.problem, state.particles).dt, state);
    double deviation = 0.0;
    for (const double p : state.particles.pore_pressure)
        deviation = std::max(deviation, std::abs(p / 1e4 - 1.0));
    return deviation;
}

TEST(SealedBody, KeepsAConstantPressureWhateverItsCorners)
{
    const double tangent = std::tan(20.0 * std::numbers::pi / 180.0);
    const std::vector<std::vector<Vector2>> shapes = {
        {{0.0, 0.0}, {5.0, 0.1}, {2.0, 2.0}},             // two acute corners
        {{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0 * tangent}},   // 20 degrees
        {{1.0, 0.0}, {3.7, 0.6}, {4.1, 2.9}, {0.2, 2.3}}, // irregular
        {{2.0, 0.0}, {4.0, 2.0}, {2.0, 4.0}, {0.0, 2.0}}, // a square at 45 degrees
    };
    for (std::size_t k = 0; k < shapes.size(); ++k)
        for (const std::string scheme : {"explicit", "semi_implicit"})
            EXPECT_LT(deviation_in(sealed_body(shapes[k], saturated), scheme), 1e-5) << k << ' ' << scheme;
}

// A constant pressure p acts with n p on the water and (1 - n) p on the grains: the walls have to answer both
// where n changes along them.
TEST(SealedBody, KeepsAConstantPressureAcrossLayersOfUnlikePorosity)
{
    const std::string firm = R"(model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
hydraulic_conductivity = 1e-4
)";
    std::string tables = saturated.substr(0, saturated.find("[materials"));
    tables += "[materials.dense]\nporosity = 0.3\n" + firm + "[materials.loose]\nporosity = 0.45\n" + firm;
    tables += "[regions.lower]\nmaterial = \"dense\"\n[regions.upper]\nmaterial = \"loose\"\n";
    const Vector2 left(0.0, 2.0), right(4.0, 1.6), bottom(2.2, 0.0), top(1.9, 4.0);
    SealedBody body = sealed_body({left, bottom, right, top}, tables);
    body.section.regions = {{"lower", {{{left, bottom, right}, {}}}}, {"upper", {{{left, right, top}, {}}}}};
    for (const std::string scheme : {"explicit", "semi_implicit", "implicit"})
        EXPECT_LT(deviation_in(body, scheme), 1e-5) << scheme;
}

/// Mean pressure that a sealed, level piston raises in a dry elastic column when it presses it by 1 mm from
/// `top` on.
double stress_under_piston(double top)
{
    std::string tables = saturated;
    tables.replace(tables.find("[water]\nlevel = 20.0\n"), 21, "");
    tables.replace(tables.find("hydraulic_conductivity = 1e-4\n"), 30, "");
    tables +=
        "[boundaries.base]\nsoil = \"fixed\"\n[boundaries.right]\nsoil = \"roller\"\n[boundaries.left]\nsoil "
        "= "
        "\"roller\"\n[boundaries.top]\nsoil = \"moving\"\nnormal_displacement = 0.001\nramp_time = 0.2\n";
    AssembledCase assembled = assemble(
        scene_with(0.25, {0.0, 0.0}, 4, 14, tables),
        polygon_section(
            {{{0.0, 0.0}, "base"}, {{1.0, 0.0}, "right"}, {{1.0, top}, "top"}, {{0.0, top}, "left"}}));
    State& state = assembled.state;
    run(assembled.problem, 0.2, {}, state);
    double sum = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        sum -= state.particles.volume[p] * state.particles.stress.yy[p];
        volume += state.particles.volume[p];
    }
    return sum / volume * top; // M times the displacement
}

TEST(Piston, FeelsNoGridLines)
{
    // M = 24 MPa; the walls' places go through two cells
    double last = stress_under_piston(2.5);
    for (int k = 0; k <= 40; ++k) {
        const double stress = stress_under_piston(2.5 + 0.0125 * k);
        EXPECT_NEAR(stress / 24e3, 1.0, 0.01) << k;
        EXPECT_NEAR(stress / last, 1.0, 0.01) << k;
        last = stress;
    }
}

/// Two cells high, between rollers; it drains to the right. The plate on top has moved by 10 micrometres
/// after 0.1 s.
std::string slab_scene(int particles)
{
    const std::string two = "[2, 2]", count = std::to_string(particles);
    std::string tables = saturated;
    tables.replace(tables.find(two), two.size(), "[" + count + ", " + count + "]");
    return "[analysis]\nstrain = \"small\"\nscheme = \"semi_implicit\"\n" + tables + R"([boundaries.base]
soil = "roller"
[boundaries.middle]
soil = "roller"
[boundaries.plate]
soil = "moving"
normal_displacement = "0.01 mm"
ramp_time = "0.1 s"
)";
}

/// The energy made or lost in 60 steps, without the watchdog, over the energy turned over.
double energy_error(double degrees, int particles)
{
    const auto corners =
        turned({{{0.0, 0.0}, "base"}, {{1.0, 0.0}, "right"}, {{1.0, 0.1}, "plate"}, {{0.0, 0.1}, "middle"}},
               degrees, {0.0, 0.0});
    AssembledCase assembled =
        assemble(scene_with(0.05, {-0.6, -0.5}, 36, 36, slab_scene(particles)), polygon_section(corners));
    const Problem& problem = assembled.problem;
    State& state = assembled.state;
    begin_shaking(problem, state);
    open_balances(problem, state);
    const auto stepper = make_stepper(problem);
    for (int step = 0; step < 60; ++step)
        stepper->advance(problem, stable_time_step(problem, state.particles).dt, state);
    return energy_balance(problem, state).error();
}

TEST(PressedSlab, MakesNoEnergyAtAnyAngle)
{
    for (const int particles : {2, 3})
        for (const double degrees : {0.0, 10.0, 25.0, 45.0, 70.0, 115.0})
            EXPECT_LT(std::abs(energy_error(degrees, particles)), 0.01)
                << degrees << " degrees, " << particles;
}

constexpr double ground_width = 10.0, ground_height = 6.0; // about the ring [m]

/// Ground with this ring, which is drawn clockwise, for the soil lies outside.
Section ground_with_ring(const Ring& ring)
{
    Section section = polygon_section({{{0.0, 0.0}, "base"},
                                       {{ground_width, 0.0}, "right"},
                                       {{ground_width, ground_height}, "top"},
                                       {{0.0, ground_height}, "left"}});
    section.regions.front().polygons.front().holes = {ring};
    NamedCurve curve{"ring", {}};
    for (std::size_t k = 0; k < ring.size(); ++k)
        curve.segments.push_back({ring[k], ring[(k + 1) % ring.size()]});
    section.curves.push_back(curve);
    bound_section(section);
    return section;
}

/// A ring of as many sides as given in the middle, from the corner `first` on, itself at an angle of so many
/// sides.
Section ground_with_ring(int sides, double radius, int first, double from)
{
    Ring ring;
    for (int k = 0; k < sides; ++k) {
        const double angle = -2.0 * std::numbers::pi * (k + first + from) / sides;
        ring.push_back(
            {0.5 * ground_width + radius * std::cos(angle), 0.5 * ground_height + radius * std::sin(angle)});
    }
    return ground_with_ring(ring);
}

/// Vertical stresses at rest, by place in tenths of a millimetre [Pa].
using Stresses = std::map<std::pair<long, long>, double>;

Stresses stresses_at_rest(const std::string& wall, const Section& section)
{
    const std::string tables = elastic + base_and_sides + "[boundaries.ring]\nsoil = \"" + wall +
                               "\"\n[relaxation]\ntolerance = 1e-8\n";
    AssembledCase assembled = assemble(scene_with(0.5, {0.0, 0.0}, 20, 13, tables), section);
    relax(assembled.problem, *assembled.scene.relaxation, assembled.state);
    const Particles& particles = assembled.state.particles;
    Stresses stresses;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 place = 1e4 * particles.reference_position[p];
        stresses[{std::lround(place.x()), std::lround(place.y())}] = particles.stress.yy[p];
    }
    return stresses;
}

/// Largest difference of stresses at the same places, of which `b` may be mirrored, over the largest stress.
double stress_difference(const Stresses& a, const Stresses& b, bool mirrored)
{
    double worst = 0.0, largest = 0.0;
    for (const auto& [place, stress] : a) {
        largest = std::max(largest, std::abs(stress));
        double nearest = 1e30;
        for (long dx = -1; dx <= 1; ++dx)
            for (long dy = -1; dy <= 1; ++dy) {
                const long x = mirrored ? std::lround(1e4 * ground_width) - place.first : place.first;
                const auto found = b.find({x + dx, place.second + dy});
                if (found != b.end()) nearest = std::min(nearest, std::abs(stress - found->second));
            }
        worst = std::max(worst, nearest);
    }
    return worst / largest;
}

TEST(RingOfAWall, IsTheSameWhereverItsDrawingBeginsAndInAMirror)
{
    for (const std::string wall : {"fixed", "roller"}) {
        const Stresses stresses = stresses_at_rest(wall, ground_with_ring(16, 1.1, 0, 0.0));
        EXPECT_LT(stress_difference(stresses, stresses, true), 1e-5) << wall;
        EXPECT_LT(
            stress_difference(stresses, stresses_at_rest(wall, ground_with_ring(16, 1.1, 3, 0.0)), false),
            1e-5)
            << wall;
    }
    for (const double from : {0.0, 0.2}) { // a flat top; no symmetry
        const Stresses stresses = stresses_at_rest("fixed", ground_with_ring(14, 1.3, 0, from));
        if (from == 0.0) {
            EXPECT_LT(stress_difference(stresses, stresses, true), 1e-5);
        }
        EXPECT_LT(
            stress_difference(stresses, stresses_at_rest("fixed", ground_with_ring(14, 1.3, 5, from)), false),
            1e-5);
    }
}

/// A box of 2.2 x 1.6 m, clockwise from its upper left on, with corners of as many edges as given, whose flat
/// top has a corner more than its shape needs.
Ring round_box(int edges)
{
    const Vector2 middle(0.5 * ground_width, 0.5 * ground_height);
    constexpr double radius = 0.3, quarter = 0.5 * std::numbers::pi;
    Ring box;
    for (int corner = 0; corner < 4; ++corner) {
        const Vector2 centre(corner == 0 || corner == 3 ? -0.8 : 0.8, corner < 2 ? 0.5 : -0.5);
        for (int k = 0; k <= edges; ++k) {
            const double angle = quarter * (2 - corner - static_cast<double>(k) / edges);
            box.push_back(middle + centre + radius * Vector2(std::cos(angle), std::sin(angle)));
        }
        if (corner == 0) box.push_back(middle + Vector2(0.0, 0.8));
    }
    return box;
}

TEST(RingOfAWall, IsTheSameWhereverItBeginsOnAFlatTop)
{
    for (const int edges : {3, 4}) {
        Ring ring = round_box(edges);
        const Stresses stresses = stresses_at_rest("fixed", ground_with_ring(ring));
        EXPECT_LT(stress_difference(stresses, stresses, true), 1e-8) << edges;
        for (int turn = 0; turn < 3; ++turn) {
            std::rotate(ring.begin(), ring.begin() + edges, ring.end()); // on, beside and far from the top
            EXPECT_LT(stress_difference(stresses, stresses_at_rest("fixed", ground_with_ring(ring)), false),
                      1e-8)
                << edges << ' ' << turn;
        }
    }
}

/// One corner of 45 degrees and more: the wall ends there, and has no hats that go round.
TEST(RingOfAWall, WithOneSharpCornerIsItsMirrorImage)
{
    const Vector2 middle(0.5 * ground_width, 0.5 * ground_height - 0.4);
    constexpr double radius = 0.9, opening = 0.25 * std::numbers::pi; // to either side of the top [m, rad]
    constexpr int sides = 14;
    for (const std::string wall : {"fixed", "roller"}) {
        Ring drop = {middle + Vector2(0.0, radius * std::numbers::sqrt2)};
        for (int k = 0; k <= sides; ++k) {
            const double angle =
                0.5 * std::numbers::pi - opening - 2.0 * (std::numbers::pi - opening) * k / sides;
            drop.push_back(middle + radius * Vector2(std::cos(angle), std::sin(angle)));
        }
        const Stresses stresses = stresses_at_rest(wall, ground_with_ring(drop));
        EXPECT_LT(stress_difference(stresses, stresses, true), 1e-8) << wall;
    }
}

} // namespace
} // namespace quicksand
