#include "solver/vibration/vibration_limit.hpp"

#include "solver/vibration/largest_eigenvalue.hpp"
#include "solver/vibration/single_phase_vibration.hpp"
#include "solver/vibration/two_phase_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace quicksand {

namespace {

// Ritz values of so few iterations are within some per cent of the eigenvalue.
constexpr double tolerance = 0.01;
constexpr int max_iterations = 24;

std::unique_ptr<NodalEquations> equations_of(const Problem& problem, const State& state, double dt)
{
    if (water_flow(problem) == WaterFlow::coupled)
        return std::make_unique<TwoPhaseEquations>(problem, state, dt);
    return std::make_unique<SinglePhaseEquations>(problem, state);
}

/// The node where the grains move most.
Vector2 place_of_motion(const BackgroundGrid& grid, const Scalars& velocity)
{
    const std::size_t components = velocity.size() / grid.node_count(); // 0 where nothing can move
    if (components == 0) return Vector2::Zero();
    std::size_t fastest = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < grid.node_count(); ++i) {
        const double speed = std::hypot(velocity[components * i], velocity[components * i + 1]);
        if (speed > most) most = speed, fastest = i;
    }
    return grid.node_position(fastest);
}

} // namespace

VibrationLimit vibration_limit(const Problem& problem, const State& state, double largest)
{
    constexpr double close = 1.02; // of (dt / limit)^2
    constexpr int most_steps = 8;  // of the limit, which depends on dt by drag and water
    VibrationLimit limit{largest, Vector2::Zero(), 0};
    for (int k = 0; k < most_steps; ++k) {
        const auto equations = equations_of(problem, state, limit.dt);
        const LargestEigenvalue found = find_largest_eigenvalue(*equations, tolerance, max_iterations);
        limit.iterations += found.iterations;
        limit.place = place_of_motion(problem.grid, found.eigenvector);
        const double excess = limit.dt * limit.dt * found.value;
        if (excess > 1.0) limit.dt /= std::sqrt(excess);
        if (!(excess > close)) break;
    }
    return limit;
}

} // namespace quicksand
