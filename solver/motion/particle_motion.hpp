// How particles move, turn and deform with the velocities gathered for them.
#pragma once

#include "solver/base/threads.hpp"
#include "solver/interpolation/cpdi2.hpp"
#include "solver/motion/compact_domains.hpp"
#include "solver/motion/particle_order.hpp"
#include "solver/motion/wall_crossings.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <algorithm>
#include <cstdint>

namespace quicksand {

/// Move and deform the particles as the scene's interpolation and strain form ask, and bring the porosity up
/// to date. `velocity(node)` is the velocity of the grains at a node [m/s]. Throws NumericalError.
template <class Velocity>
void move_particles(const Problem& problem, double dt, const Vectors& grid_velocity, Velocity&& velocity,
                    State& state);

/// x += dt v with the velocity of the grid, r_a <- (I + dt L) r_a, V <- det(I + dt L) V.
void advance_domains(double dt, const Vectors& grid_velocity, Particles& particles);

/// Small strain: x += dt v and r_a += dt L R_a with the reference edges R_a, for displacements and strains
/// that others look at; no equation uses them. The volume stays.
void displace_domains(double dt, const Vectors& grid_velocity, Particles& particles);

/// The corners of quadrilateral domains move with the grid: x_c += dt sum N_i(x_c) v_i; position, edges and
/// twist follow from them, the volume changes as their area. Returns a particle with a corner outside the
/// grid, which stays as it is, or -1.
template <class Velocity>
std::int64_t advance_quadrilaterals(const BackgroundGrid& grid, double dt, Velocity&& velocity,
                                    Particles& particles);

/// L <- L (I + dt/2 L)^-1: the gradient along the shape in the middle of the step, in which velocities stand.
/// A rigid turn has no strain there, however long the step (Hughes and Winget 1980).
void take_gradients_of_the_middle(double dt, Particles& particles);

/// n = 1 - V_grains / V: the grains' volume is constant.
void update_porosity(const Problem& problem, Particles& particles);

/// Turn the stress by the step's rotation (Hughes and Winget 1980: half-angle tangent w/2, w = dt (L_yx -
/// L_xy)/2), then add each material's stress of the step's strain.
void update_effective_stress(const Problem& problem, double dt, Particles& particles);

/// x + dt sum N_i(x) v_i; false where x lies outside the grid.
template <class Velocity>
bool move_with_grid(const BackgroundGrid& grid, double dt, Velocity&& velocity, Vector2& x)
{
    const Vector2 cells = grid.cells_from_rim(x);
    const bool inside = cells.x() >= 0.0 && cells.y() >= 0.0 && cells.x() < grid.all_cells_x() &&
                        cells.y() < grid.all_cells_y(); // written so that NaN is outside
    if (!inside) return false;
    const auto [i, j, xi, eta] = place_in_cell(cells);
    const std::size_t node = grid.node_index(i, j), above = grid.node_index(i, j + 1);
    x += dt * ((1.0 - eta) * ((1.0 - xi) * velocity(node) + xi * velocity(node + 1)) +
               eta * ((1.0 - xi) * velocity(above) + xi * velocity(above + 1)));
    return true;
}

template <class Velocity>
std::int64_t advance_quadrilaterals(const BackgroundGrid& grid, double dt, Velocity&& velocity,
                                    Particles& particles)
{
    const FirstIndex none{particles.size()};
    const auto advance = [&](std::size_t p) {
        std::array<Vector2, 4> corners = quadrilateral_corners(particles, p);
        bool inside = true;
        for (Vector2& x : corners) inside = inside && move_with_grid(grid, dt, velocity, x);
        if (!inside) return false;
        const double area = domain_area(particles, p);
        set_quadrilateral(corners, p, particles);
        particles.volume[p] *= domain_area(particles, p) / area;
        return true;
    };
    const FirstIndex lost = ordered_sum(particles.size(), none, [&](std::size_t first, std::size_t last) {
        FirstIndex part = none;
        for (std::size_t p = first; p < last; ++p)
            if (!advance(p)) part += {p};
        return part;
    });
    return lost.index < none.index ? static_cast<std::int64_t>(lost.index) : -1;
}

template <class Velocity>
void move_particles(const Problem& problem, double dt, const Vectors& grid_velocity, Velocity&& velocity,
                    State& state)
{
    if (problem.strain == StrainForm::small) {
        displace_domains(dt, grid_velocity, state.particles);
        return;
    }
    if (problem.interpolation == Interpolation::cpdi2) {
        const std::int64_t lost = advance_quadrilaterals(problem.grid, dt, velocity, state.particles);
        if (lost >= 0) throw_lost_corner(dt, state, static_cast<std::size_t>(lost));
    } else {
        advance_domains(dt, grid_velocity, state.particles);
        stop_at_walls(problem, dt, grid_velocity, state.particles);
    }
    take_gradients_of_the_middle(dt, state.particles);
    if (problem.interpolation == Interpolation::cpdi) keep_domains_compact(problem, state.particles);
    if (problem.water) update_porosity(problem, state.particles);
}

} // namespace quicksand
