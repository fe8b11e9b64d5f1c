// Sections that have no closed form, against finite elements (six-node triangles, refined until they change
// by less than 0.1 %): a dike shaken on a slanted base, and a slope that consolidates under a face sealed by
// clay.
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// Error of the crest's displacement relative to the shaken base of a dry elastic dike, in its mean over the
/// history [-]. The dike: 2 m high, crest 2 m wide, slopes of 1:2; its base rises by `slope`. `displacements`
/// are those of the point (4.95, 1.85) at 0.1, 0.15, ... s [1e-6 m].
double error_of_shaken_dike(double slope, const std::string& scheme, const std::vector<double>& displacements)
{
    const double left = -5.0 * slope / (0.5 - slope), right = (5.0 + 5.0 * slope) / (0.5 + slope);
    const std::string scene = scene_with(0.2, {-1.4, -0.8}, 64, 18, "[analysis]\nscheme = \"" + scheme + R"("
strain = "small"
[sampling]
particles_per_cell = [2, 2]
[gravity]
acceleration = 0.0
[materials.soil]
model = "linear_elastic"
shear_modulus = "20 MPa"
poisson_ratio = 0.3
grain_density = 2650.0
porosity = 0.4
[regions.soil]
material = "soil"
[boundaries.base]
soil = "fixed"
[motion]
kind = "sine"
amplitude = 1.0
frequency = 8.0
cycles = 4
ramp_cycles = 2
)");
    AssembledCase assembled = assemble(scene, polygon_section({{{left, 0.5 * left}, "base"},
                                                               {{right, 0.5 * (10.0 - right)}, ""},
                                                               {{6.0, 2.0}, ""},
                                                               {{4.0, 2.0}, ""}}));
    State& state = assembled.state;
    begin_shaking(assembled.problem, state);
    std::int32_t crest = -1;
    for (std::size_t p = 0; p < state.particles.size(); ++p)
        if ((state.particles.reference_position[p] - Vector2(4.95, 1.85)).norm() < 1e-6)
            crest = state.particles.identifier[p];
    EXPECT_GE(crest, 0);
    double difference = 0.0, sum = 0.0, time = 0.1;
    for (const double expected : displacements) {
        run(assembled.problem, time, {}, state);
        time += 0.05;
        for (std::size_t p = 0; p < state.particles.size(); ++p) {
            if (state.particles.identifier[p] != crest) continue;
            const double moved =
                1e6 * (state.particles.position.x[p] - state.particles.reference_position.x[p]);
            difference += (moved - expected) * (moved - expected);
            sum += expected * expected;
        }
    }
    return std::sqrt(difference / sum);
}

// The dike's own vibration goes on when the shaking is over, after 0.5 s: implicit steps give way to those
// that follow it.
TEST(ShakenDike, MovesOnASlantedBaseAsExactlyAsOnALevelOne)
{
    for (const std::string scheme : {"explicit", "implicit"}) {
        const double level = error_of_shaken_dike(
            0.0, scheme, {67.77, -82.47, 75.41, 5.81, -99.08, 145.33, -161.82, 97.68, 9.11, 76.42, 74.10});
        const double slanted = error_of_shaken_dike(
            0.05, scheme, {68.06, -82.59, 75.40, 5.57, -99.43, 145.78, -161.74, 98.28, 9.10, 76.42, 72.92});
        EXPECT_LT(level, 0.01) << scheme; // measured 0.59 and 0.58 %
        EXPECT_LT(slanted, 1.5 * level) << scheme;
    }
}

struct Pressure {
    Vector2 place; // [m]
    double value;  // [Pa]
};

/// The value at a point of the plane through the pressures of the particles within a distance [Pa].
double pressure_at(const Particles& particles, const Vector2& place, double distance)
{
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 from = particles.reference_position[p] - place;
        if (from.norm() > distance) continue;
        const Eigen::Vector3d row(1.0, from.x(), from.y());
        normal += particles.volume[p] * row * row.transpose();
        right += particles.volume[p] * particles.pore_pressure[p] * row;
    }
    return Eigen::Vector3d(normal.ldlt().solve(right))[0];
}

struct Difference {
    double mean = 0.0;   // of the whole body's pressure [-]
    double points = 0.0; // root of the mean square at the points [-]
};

/// Differences of the excess pressures of a slope of 1:2 from `expected`, of the 1 kPa that they had 2.5 s
/// before.
Difference differences_in_slope(double h, double offset, const std::string& face, double mean,
                                const std::vector<Pressure>& expected)
{
    const std::string scene =
        scene_with(h, {-(2.0 + offset) * h, -(2.0 + offset) * h}, static_cast<int>(12.0 / h) + 5,
                   static_cast<int>(4.0 / h) + 5, R"([analysis]
scheme = "semi_implicit"
strain = "small"
[sampling]
particles_per_cell = [2, 2]
[gravity]
acceleration = 0.0
[water]
level = 10.0
bulk_modulus = "0.2 GPa"
[materials.soil]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
porosity = 0.4
hydraulic_conductivity = 2e-4
[regions.soil]
material = "soil"
[boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "roller"
[boundaries.crest]
pressure = 1000.0
[boundaries.ground]
pressure = 1000.0
[initial]
excess_pore_pressure = 1000.0
[boundaries.face]
pressure = 1000.0
soil = "free"
water = ")" + face + "\"\n");
    AssembledCase assembled = assemble(scene, polygon_section({{{0.0, 0.0}, "base"},
                                                               {{12.0, 0.0}, "right"},
                                                               {{12.0, 2.0}, "ground"},
                                                               {{8.0, 2.0}, "face"},
                                                               {{4.0, 4.0}, "crest"},
                                                               {{0.0, 4.0}, "left"}}));
    State& state = assembled.state;
    run(assembled.problem, 2.5, {}, state);
    const Particles& particles = state.particles;
    double sum = 0.0, volume = 0.0, square = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        sum += particles.volume[p] * particles.pore_pressure[p];
        volume += particles.volume[p];
    }
    for (const Pressure& point : expected) {
        const double apart = pressure_at(particles, point.place, 1.5 * h) - point.value;
        square += apart * apart;
    }
    return {(sum / volume - mean) / 1000.0,
            std::sqrt(square / static_cast<double>(expected.size())) / 1000.0};
}

TEST(SealedSlope, ConsolidatesAsFiniteElements)
{
    const std::vector<Pressure> expected = {{{1.0, 1.0}, 1000.9}, {{4.0, 1.0}, 967.8},  {{6.0, 1.0}, 891.4},
                                            {{8.0, 1.0}, 595.2},  {{10.5, 1.0}, 450.6}, {{2.0, 3.0}, 529.0},
                                            {{5.0, 3.0}, 788.2},  {{6.4, 2.4}, 816.3}};
    for (const double offset : {0.0, 0.25, 0.5}) {
        const Difference coarse = differences_in_slope(0.5, offset, "impervious", 696.2, expected);
        const Difference fine = differences_in_slope(0.25, offset, "impervious", 696.2, expected);
        EXPECT_LT(std::abs(coarse.mean), 0.02) << offset; // measured 1.1 % at most
        EXPECT_LT(std::abs(fine.mean), 0.01) << offset;   // 0.44 %
        EXPECT_LT(fine.points, 0.01) << offset;           // 0.56 %
    }
}

TEST(DrainedSlope, ConsolidatesAsFiniteElements)
{
    const std::vector<Pressure> expected = {{{1.0, 1.0}, 983.7}, {{4.0, 1.0}, 943.4},  {{6.0, 1.0}, 743.8},
                                            {{8.0, 1.0}, 480.6}, {{10.5, 1.0}, 430.7}, {{2.0, 3.0}, 504.5},
                                            {{5.0, 3.0}, 233.6}};
    for (const double offset : {0.0, 0.5}) {
        const Difference fine = differences_in_slope(0.25, offset, "drained", 590.8, expected);
        EXPECT_LT(std::abs(fine.mean), 0.005) << offset; // measured 0.17 %
        EXPECT_LT(fine.points, 0.01) << offset;          // 0.22 %
    }
}

} // namespace
} // namespace quicksand
