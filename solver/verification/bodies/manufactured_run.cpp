#include "solver/verification/bodies/manufactured_run.hpp"

#include "solver/motion/particle_order.hpp"
#include "solver/run/simulation.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step_length/time_step_control.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

/// The body: a square between walls.
struct Square {
    double lower, side; // [m]
    SoilCondition walls;
};

Square square_of(const ManufacturedMotion& motion)
{
    if (std::holds_alternative<AxisAlignedMotion>(motion)) return {0.0, 1.0, RollerWall{}};
    return {-1.5, 3.0, FixedWall{}};
}

Problem make_problem(const ManufacturedRun& run, const ManufacturedBody& body)
{
    const Square square = square_of(run.motion);
    const double a = square.lower, b = square.lower + square.side;
    Problem problem;
    problem.grid = {{a, a}, square.side / run.cells, run.cells, run.cells};
    Material material;
    material.name = "neo-Hookean";
    material.law = NeoHookean{body.shear_modulus(), body.poisson_ratio};
    material.grain_density = body.density;
    problem.materials = {material};
    problem.gravity = 0.0;
    const Boundary walls{"walls",
                         square.walls,
                         Impervious{},
                         {{{a, a}, {b, a}}, {{b, a}, {b, b}}, {{b, b}, {a, b}}, {{a, b}, {a, a}}}};
    problem.boundaries = {walls};
    return problem;
}

/// Velocity gradient at t = 0 by central differences.
void set_initial_motion(const ManufacturedMotion& motion, const ManufacturedBody& body, Particles& particles)
{
    constexpr double step = 1e-6; // [m]
    const auto slope = [&](const Vector2& X, const Vector2& direction) -> Vector2 {
        return (velocity(motion, body, X + step * direction, 0.0) -
                velocity(motion, body, X - step * direction, 0.0)) /
               (2.0 * step);
    };
    Gradients& L = particles.affine_velocity_solid;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 X = particles.position[p];
        particles.velocity_solid.set(p, velocity(motion, body, X, 0.0));
        const Vector2 along_x = slope(X, Vector2::UnitX()), along_y = slope(X, Vector2::UnitY());
        L.xx[p] = along_x.x(), L.yx[p] = along_x.y();
        L.xy[p] = along_y.x(), L.yy[p] = along_y.y();
    }
}

State make_state(const ManufacturedRun& run, const ManufacturedBody& body, const Problem& problem)
{
    const BackgroundGrid& grid = problem.grid;
    const int per_side = run.cells * run.per_cell;
    const double size = grid.cell_size / run.per_cell;
    State state;
    Particles& particles = state.particles;
    const auto count = static_cast<std::size_t>(per_side) * static_cast<std::size_t>(per_side);
    resize_particles(problem, count, particles);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto i = static_cast<double>(p % static_cast<std::size_t>(per_side));
        const auto j = static_cast<double>(p / static_cast<std::size_t>(per_side));
        particles.identifier[p] = static_cast<std::int32_t>(p);
        particles.position.set(p, grid.origin + size * Vector2(i + 0.5, j + 0.5));
        particles.half_edge_1.set(p, {0.5 * size, 0.0});
        particles.half_edge_2.set(p, {0.0, 0.5 * size});
        particles.volume[p] = size * size;
        particles.mass_solid[p] = body.density * size * size;
    }
    begin_shaking(state);
    return state;
}

double root_mean_square_error(const ManufacturedMotion& motion, const ManufacturedBody& body,
                              const State& state)
{
    double sum = 0.0;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        const Vector2 X = state.particles.reference_position[p];
        sum += (state.particles.position[p] - X - displacement(motion, body, X, state.time)).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(state.particles.size()));
}

/// The body force of the motion, and its velocities at t = 0.
void prepare(const ManufacturedMotion& motion, const ManufacturedBody& body, Interpolation interpolation,
             Problem& problem, Particles& particles)
{
    problem.interpolation = interpolation;
    problem.gravity = 0.0;
    problem.body_acceleration = [motion, body](const Vector2& X, double t) {
        return body_acceleration(motion, body, X, t);
    };
    if (interpolation == Interpolation::cpdi2 && particles.twist.x.empty())
        particles.twist.x = particles.twist.y = Scalars(particles.size(), 0.0);
    particles.stress = {Scalars(particles.size()), Scalars(particles.size()), Scalars(particles.size()),
                        Scalars(particles.size())};
    set_initial_motion(motion, body, particles);
}

} // namespace

ManufacturedError run_manufactured(const ManufacturedRun& run, const ManufacturedBody& body, Problem problem,
                                   State state)
{
    prepare(run.motion, body, run.interpolation, problem, state.particles);
    SinglePhaseWorkspace work = make_single_phase_workspace(problem);
    const Material& material = problem.materials.front();
    const double wave = wave_speeds(material, problem.water, material.porosity).skeleton;
    const double nominal = run.courant_number * problem.grid.cell_size / wave;
    const double amplitude = std::visit([](const auto& motion) { return motion.amplitude; }, run.motion);
    constexpr double rounding = 1e-6; // of a step [-]
    ManufacturedError error;
    while (state.time < run.end_time) {
        // equal steps, unless the soil has stretched so far that it takes shorter ones
        const double stable = std::min(nominal, stable_time_step(problem, state.particles).dt);
        const double remaining = run.end_time - state.time;
        const double steps = std::ceil(remaining / stable - rounding);
        const double dt = remaining / std::max(1.0, steps);
        advance_single_phase_step(problem, dt, 0.0, state, work);
        if (steps <= 1.0) state.time = run.end_time;
        check_particles(dt, state);
        error.displacement_error =
            std::max(error.displacement_error, root_mean_square_error(run.motion, body, state) / amplitude);
        error.scaled_domains = std::max(error.scaled_domains, work.limited_domains);
    }
    return error;
}

ManufacturedError run_manufactured(const ManufacturedRun& run)
{
    const ManufacturedBody body;
    Problem problem = make_problem(run, body);
    State state = make_state(run, body, problem);
    return run_manufactured(run, body, std::move(problem), std::move(state));
}

} // namespace quicksand
