// Solids and interfaces in runs: the same bits for any number of threads and from a checkpoint, and what they
// do with every member of the family, strain and scheme.
#include "io/results/checkpoint.hpp"
#include "solver/base/threads.hpp"
#include "tests/fixtures/drawn_section.hpp"
#include "tests/fixtures/same_bits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

/// A block of concrete that stands half in saturated sand, its faces within cells, shaken until it slides.
AssembledCase block_in_sand(const std::string& analysis)
{
    Section section = polygon_section({{{0.0, 0.0}, "base"},
                                       {{6.0, 0.0}, "right"},
                                       {{6.0, 2.0}, ""},
                                       {{3.6, 2.0}, ""},
                                       {{3.6, 1.1}, ""},
                                       {{2.3, 1.1}, ""},
                                       {{2.3, 2.0}, ""},
                                       {{0.0, 2.0}, "left"}});
    section.regions.push_back(
        {"block", {{{{2.3, 1.1}, {3.6, 1.1}, {3.6, 2.0}, {3.6, 3.0}, {2.3, 3.0}, {2.3, 2.0}}, {}}}});
    bound_section(section);
    AssembledCase assembled = assemble(scene_with(0.5, {-0.5, -0.5}, 14, 9, analysis + R"([sampling]
particles_per_cell = [2, 2]
[water]
level = 2.5
[materials.sand]
model = "ubcsand"
relative_density = 0.6
porosity = 0.4
hydraulic_conductivity = 1e-3
[materials.concrete]
model = "linear_elastic"
water = "none"
density = 2400.0
shear_modulus = "50 MPa"
poisson_ratio = 0.2
[regions.soil]
material = "sand"
[regions.block]
material = "concrete"
[interfaces.foot]
regions = ["block", "soil"]
strength_ratio = 0.5
[motion]
kind = "sine"
amplitude = "0.3 g"
frequency = 2.0
)" + base_and_sides),
                                       section);
    RelaxationControls controls;
    controls.tolerance = 1e-2;
    EXPECT_TRUE(relax(assembled.problem, controls, assembled.state).settled);
    begin_shaking(assembled.problem, assembled.state);
    return assembled;
}

const std::string implicit = "[analysis]\nscheme = \"implicit\"\n";

TEST(SolidsInRuns, AreTheSameBitsForAnyNumberOfThreads)
{
    const int threads_before = thread_count();
    set_thread_count(1);
    AssembledCase one = block_in_sand(implicit);
    run(one.problem, 0.15, {}, one.state);
    set_thread_count(2);
    AssembledCase two = block_in_sand(implicit);
    run(two.problem, 0.15, {}, two.state);
    set_thread_count(threads_before);
    expect_same_bits(one.state.particles, two.state.particles);
}

TEST(SolidsInRuns, GoOnFromACheckpointWithTheSameBits)
{
    AssembledCase whole = block_in_sand(implicit);
    State stopped = whole.state;
    run(whole.problem, 0.15, {}, whole.state);
    run(whole.problem, 0.15, {}, stopped, [&] { return stopped.step >= 20; });
    ASSERT_LT(stopped.time, 0.15);
    const TemporaryFolder folder;
    write_checkpoint(folder / "checkpoint", stopped, "hash");
    State resumed = read_checkpoint(folder / "checkpoint", "hash");
    run(whole.problem, 0.15, {}, resumed);
    expect_same_bits(resumed.particles, whole.state.particles);
}

/// How far the block has moved, and the root mean square of the excess pore pressures of the sand.
struct Outcome {
    Vector2 moved = Vector2::Zero(); // [m]
    double pressure = 0.0;           // [Pa]
};

Outcome outcome(const std::string& analysis)
{
    AssembledCase assembled = block_in_sand(analysis);
    run(assembled.problem, 0.5, {}, assembled.state);
    const Particles& particles = assembled.state.particles;
    Outcome result;
    double solid = 0.0, soil = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double V = particles.volume[p];
        if (has_pores(assembled.problem, particles, p)) {
            result.pressure += V * std::pow(excess_pore_pressure(particles, p), 2);
            soil += V;
        } else {
            result.moved += V * (particles.position[p] - particles.reference_position[p]);
            solid += V;
        }
    }
    return {result.moved / solid, std::sqrt(result.pressure / soil)};
}

TEST(SolidsInRuns, DoTheSameWithEveryMemberStrainAndScheme)
{
    const Outcome reference = outcome(implicit);
    for (const std::string other :
         {"scheme = \"implicit\"\ninterpolation = \"cpdi2\"\n", "scheme = \"implicit\"\nstrain = \"small\"\n",
          "scheme = \"semi_implicit\"\n", "scheme = \"explicit\"\n"}) {
        const Outcome result = outcome("[analysis]\n" + other);
        EXPECT_NEAR((result.moved - reference.moved).norm() / reference.moved.norm(), 0.0, 0.1) << other;
        EXPECT_NEAR(result.pressure / reference.pressure, 1.0, 0.1) << other;
    }
}

} // namespace
} // namespace quicksand
