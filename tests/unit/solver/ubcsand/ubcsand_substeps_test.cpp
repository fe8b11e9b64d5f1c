// Substeps of UBCSAND in second order: what they integrate exactly, and the errors of those whose length
// follows an estimate.
#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_attempt.hpp"
#include "tests/fixtures/sand_stress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace quicksand {
namespace {

using namespace ubcsand;
using fixtures::mean_in_plane;

UbcSand sand_of_runs(double tolerance = UbcSandRunSettings().substep_tolerance)
{
    UbcSandRunSettings settings;
    settings.substep_tolerance = tolerance;
    return make_ubcsand(with(settings, nevada_sand_55()));
}

UbcSandState at(const UbcSand& law, double sigma_x, double sigma_y)
{
    UbcSandState state;
    state.sigma_x = state.sigma_z = sigma_x, state.sigma_y = sigma_y;
    begin_shaking(law, state);
    return state;
}

double distance(const UbcSandState& a, const UbcSandState& b)
{
    const double ds = mean_in_plane(a) - mean_in_plane(b),
                 dx = 0.5 * (a.sigma_x - a.sigma_y - b.sigma_x + b.sigma_y);
    return std::sqrt(ds * ds + dx * dx + (a.tau_xy - b.tau_xy) * (a.tau_xy - b.tau_xy));
}

TEST(UbcSandTurning, HasTheAngleAndTheShearOfItsEquation)
{
    // d theta = -(|dg|/t) sin theta, along = integral of cos theta |dg|: midpoint rule in 20,000 steps
    for (const double angle : {0.0, 0.4, 1.5, 3.0}) {
        for (const double length : {1e-3, 0.3, 2.0, 20.0}) {
            Start start{};
            start.q_x = 5e3 * std::cos(angle), start.q_y = 5e3 * std::sin(angle);
            const Turning turning = turn_towards(start, 5e3, {length * 5e3, 0.0}, 5e3);
            double theta = angle, along = 0.0;
            constexpr int steps = 20000;
            for (int k = 0; k < steps; ++k) {
                const double middle = theta - 0.5 * length / steps * std::sin(theta);
                along += 5e3 * length / steps * std::cos(middle);
                theta -= length / steps * std::sin(middle);
            }
            EXPECT_NEAR(turning.along, along, 1e-6 * 5e3 * length) << angle << " " << length;
            EXPECT_NEAR(turning.n_x, std::cos(theta), 1e-6) << angle << " " << length;
            EXPECT_NEAR(turning.n_y, std::sin(theta), 1e-6) << angle << " " << length;
        }
    }
}

TEST(UbcSandTurning, TakesTheDirectionOfTheShearFromTheIsotropicAxis)
{
    const Turning turning = turn_towards(Start{}, 0.0, {3.0, -4.0}, 0.0);
    EXPECT_NEAR(turning.along, 5.0, 1e-14);
    EXPECT_NEAR(turning.n_x, 0.6, 1e-15);
    EXPECT_NEAR(turning.n_y, -0.8, 1e-15);
}

TEST(UbcSandSubstepsOfSecondOrder, AreExactInElasticCompression)
{
    // K' = K'_1 sqrt(s/s_1): sqrt(s) grows by K'_1/(2 sqrt(s_1)) per strain
    const UbcSand law = sand_of_runs();
    for (const double strain : {1e-5, 2e-4, 2e-3}) {
        UbcSandState state = at(law, 40e3, 40e3);
        const double growth = (law.B_atm + law.G_atm / 3.0) / (2.0 * std::sqrt(100e3));
        update(law, {0.5 * strain, 0.5 * strain, 0.0, 0.0}, state);
        const double root = std::sqrt(40e3) + growth * strain;
        EXPECT_NEAR(mean_in_plane(state), root * root, 1e-9 * root * root) << strain;
    }
}

TEST(UbcSandSubstepsOfSecondOrder, HaveAnErrorEstimateOfSecondOrder)
{
    // at K0 = 0.5, where the principal stresses turn
    const UbcSand law = sand_of_runs();
    const auto estimate = [&](double gamma) {
        UbcSandState state = at(law, 50e3, 100e3);
        const Trial trial = elastic_trial<Integration::second_order, ElasticForm::square_roots>(
            law, state, start_of<ElasticForm::square_roots>(law, state), {-0.5 * gamma, 0.5 * gamma, gamma});
        double error = 0.0;
        finish_in_second_order<Locking::none>(law, trial, state, error);
        return error;
    };
    EXPECT_NEAR(std::log2(estimate(2e-4) / estimate(1e-4)), 2.0, 0.2);
    EXPECT_NEAR(std::log2(estimate(1e-4) / estimate(5e-5)), 2.0, 0.1);
}

/// A strain that wanders: it keeps a direction for some 50 steps, and its volume nearly.
class WanderingStrain {
public:
    WanderingStrain(double size, unsigned seed) : size_(size), random_(seed) {}

    UbcSandIncrement step()
    {
        if (uniform_(random_) < 0.02) x_ = normal_(random_), y_ = normal_(random_);
        const double volume = 2e-3 * size_ * normal_(random_);
        const double x = 0.5 * size_ * x_, gamma = size_ * y_;
        return {x + volume, -x + volume, gamma, 0.0};
    }

private:
    double size_, x_ = 0.0, y_ = 1.0;
    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> uniform_;
};

/// Errors of single steps on a wandering path, over the mean stress, not less than the resolved one; sorted
/// [-].
std::vector<double> errors_of_steps(double tolerance, double size, unsigned seed)
{
    const UbcSand law = sand_of_runs(tolerance);
    UbcSandRunSettings fine;
    fine.substep_tolerance = 1e-5;
    fine.largest_ratio_step = fine.largest_stress_step = 0.01;
    const UbcSand exact = make_ubcsand(with(fine, nevada_sand_55()));
    UbcSandState state = at(law, 50e3, 100e3);
    WanderingStrain path(size, seed);
    std::vector<double> errors;
    for (int step = 0; step < 1000; ++step) {
        const UbcSandIncrement strain = path.step();
        UbcSandState approximate = state;
        update(law, strain, approximate);
        update(exact, strain, state);
        errors.push_back(distance(approximate, state) / std::max(mean_in_plane(state), law.resolved));
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

TEST(UbcSandSubstepsOfSecondOrder, KeepTheirToleranceOnRandomPaths)
{
    // The error is that of second order, less than its estimate; in one step of a hundred the path has met an
    // event that is located to 2 % of a substep.
    for (const double size : {1e-5, 1e-4, 1e-3}) {
        for (const unsigned seed : {1U, 2U, 3U}) {
            for (const double tolerance : {0.003, 0.0003}) {
                const std::vector<double> errors = errors_of_steps(tolerance, size, seed);
                EXPECT_LT(errors[989], tolerance) << size << " " << seed << " " << tolerance;
                EXPECT_LT(errors[900], 0.5 * tolerance) << size << " " << seed << " " << tolerance;
            }
        }
    }
}

} // namespace
} // namespace quicksand
