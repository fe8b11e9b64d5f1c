// How stiff what lies beyond a viscous curve is, beside sand whose stiffness follows its stress.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double width = 1.0, height = 2.0; // of the sand [m]

/// Nevada sand on a viscous base between rollers.
Problem sand_on_viscous_base(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 2, 5};
    problem.materials = {stiff_sand()};
    problem.materials[0].law = make_ubcsand(sand_of_runs());
    problem.gravity = 0.0;
    if (saturated) problem.water = water_to(height);
    problem.boundaries = rectangle(0.0, 0.0, width, height, ViscousFace{}, RollerWall{}, FreeFace{});
    return problem;
}

/// Mean stress in the plane at an x: 25 kPa in the left half, 400 kPa in the right, at K0 = 0.5 [Pa].
double mean_stress_at(double x)
{
    return x < 0.5 * width ? 25e3 : 400e3;
}

State state_of(Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2& x) { return x.y() < height; });
    SymmetricTensors& stress = state.particles.stress;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const double s = mean_stress_at(state.particles.position.x[p]);
        stress.yy[p] = -s / 0.75;
        stress.xx[p] = stress.zz[p] = -0.5 * s / 0.75;
    }
    attach_boundaries(problem, state.particles);
    return state;
}

/// rho V_p and rho V_s of the sand at a mean stress, water and grains moving as one [Pa s/m].
Impedance impedance_at(const Problem& problem, double s)
{
    const Material& sand = problem.materials[0];
    const auto& law = std::get<UbcSand>(sand.law);
    UbcSandState stress;
    stress.sigma_x = stress.sigma_y = stress.sigma_z = s;
    const double n = sand.porosity, water = problem.water ? n * problem.water->density : 0.0;
    const double stiffness = problem.water ? problem.water->bulk_modulus / n : 0.0;
    const double density = (1.0 - n) * sand.grain_density + water;
    return {std::sqrt(density * (constrained_modulus(law, stress) + stiffness)),
            std::sqrt(density * shear_modulus(law, stress))};
}

TEST(Dashpots, BesideSandHaveItsStiffnessAtItsOwnStress)
{
    for (const bool saturated : {false, true}) {
        Problem problem = sand_on_viscous_base(saturated);
        State state = state_of(problem);
        ParticlePlaces places;
        for (const BoundaryPiece& piece : problem.boundaries[0].pieces) {
            const std::size_t p = places.find(state.particles, piece.identifier);
            const Impedance beyond = impedance(problem, problem.boundaries[0], state.particles, p);
            const Impedance expected = impedance_at(problem, mean_stress_at(state.particles.position.x[p]));
            EXPECT_NEAR(beyond.normal, expected.normal, 1e-12 * expected.normal);
            EXPECT_NEAR(beyond.shear, expected.shear, 1e-12 * expected.shear);
        }
        std::vector<Dashpot> dashpots;
        gather_dashpots(problem, state.particles, node_conditions(problem), places, dashpots);
        double normal = 0.0, shear = 0.0;
        for (const Dashpot& dashpot : dashpots) {
            normal += dashpot.yy;
            shear += dashpot.xx;
        }
        const Impedance soft = impedance_at(problem, 25e3), stiff = impedance_at(problem, 400e3);
        EXPECT_NEAR(normal, 0.5 * width * (soft.normal + stiff.normal), 1e-12 * normal);
        EXPECT_NEAR(shear, 0.5 * width * (soft.shear + stiff.shear), 1e-12 * shear);
        EXPECT_NEAR(stiff.shear / soft.shear, 2.0, 1e-12) << "the fourth root of the stress";
    }
}

TEST(Dashpots, FollowTheSandAsItSoftens)
{
    Problem problem = sand_on_viscous_base(true);
    State state = state_of(problem);
    const Boundary& base = problem.boundaries[0];
    ParticlePlaces places;
    const std::size_t p = places.find(state.particles, base.pieces.front().identifier);
    const double before = impedance(problem, base, state.particles, p).shear;
    for (Scalars* stress : {&state.particles.stress.xx, &state.particles.stress.yy}) (*stress)[p] /= 16.0;
    EXPECT_NEAR(impedance(problem, base, state.particles, p).shear, 0.5 * before, 1e-12 * before);
}

// With the stiffness that nothing but shocks meet, a surface moved by 4 and 17 % too much over a base in soil
// that is damped by 5 and 20 %.
TEST(Dashpots, OfDampedSoilAreThoseOfItsStiffnessAtTheMiddleOfItsBand)
{
    Problem problem = sand_on_viscous_base(true);
    const State state = state_of(problem);
    const auto impedance_with = [&](double damping_ratio) {
        LinearElastic law{30e6, 0.3};
        law.damping_ratio = damping_ratio;
        for (Material& material : problem.materials) material.law = law;
        return impedance(problem, problem.boundaries[0], state.particles, 0);
    };
    const Impedance undamped = impedance_with(0.0), damped = impedance_with(0.2);
    EXPECT_EQ(damped.shear, undamped.shear);
    EXPECT_EQ(damped.normal, undamped.normal);
}

TEST(Dashpots, BesideSandDoNotChangeTheRock)
{
    Problem problem = sand_on_viscous_base(true);
    problem.boundaries[0].soil = ViscousFace{HalfSpace{2400.0, 800.0, 1600.0}};
    State state = state_of(problem);
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Impedance rock = impedance(problem, problem.boundaries[0], state.particles, p);
        EXPECT_EQ(rock.normal, 2400.0 * 1600.0);
        EXPECT_EQ(rock.shear, 2400.0 * 800.0);
    }
}

} // namespace
} // namespace quicksand
