// Change of a node's velocities by an impulse, for boundary forces that depend on the velocities (walls in
// motion, dashpots) and are applied after the momentum balance.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/layer_axes.hpp"
#include "solver/boundaries/nodes.hpp"

namespace quicksand {

/// Velocity per impulse along an axis of the drag: of the grains by an impulse on the grains, of the water by
/// one on the grains (or the other way round), of the water by one on the water [m/kg]. The drag is inside,
/// as in the momentum balance; a held phase does not respond.
struct NodeResponse {
    double solid = 0.0, exchange = 0.0, fluid = 0.0;
};

/// Conditions on the directions of a node, x first.
inline constexpr std::uint8_t solid_fixed[2] = {solid_x_fixed, solid_y_fixed};
inline constexpr std::uint8_t fluid_fixed[2] = {fluid_x_fixed, fluid_y_fixed};
inline constexpr std::uint8_t seal[2] = {seal_x, seal_y};

/// Drag of a node along one of its axes [N s/m2].
inline double drag_along(const TwoPhaseSums& node, int axis)
{
    return axis == 0 ? node.drag_1 : node.drag_2;
}

inline NodeResponse response(const SinglePhaseSums& node, double, std::uint8_t held, int axis)
{
    if (!node.active() || (held & solid_fixed[axis])) return {};
    return {1.0 / node.mass, 0.0, 0.0};
}

inline NodeResponse response(const TwoPhaseSums& node, double dt, std::uint8_t held, int axis)
{
    if (!node.active()) return {};
    const double m_s = node.mass_solid, m_w = node.mass_fluid, dt_drag = dt * drag_along(node, axis);
    const bool fluid_held = (held & fluid_fixed[axis]) != 0 || m_w == 0.0;
    const bool sealed = fluid_held || (held & seal[axis]);
    if (held & solid_fixed[axis]) return {0.0, 0.0, sealed ? 0.0 : 1.0 / (m_w + dt_drag)};
    if (fluid_held) return {1.0 / (m_s + dt_drag), 0.0, 0.0};
    if (held & seal[axis]) {
        const double both = 1.0 / (m_s + m_w);
        return {both, both, both};
    }
    const double determinant = m_s * m_w + dt_drag * (m_s + m_w);
    return {(m_w + dt_drag) / determinant, dt_drag / determinant, (m_s + dt_drag) / determinant};
}

/// The same by the axes of the grid, symmetric.
struct NodeResponses {
    Eigen::Matrix2d solid, exchange, fluid;
};

template <class Sums>
NodeResponses responses(const Sums& node, double dt, std::uint8_t held)
{
    const NodeResponse a = response(node, dt, held, 0), b = response(node, dt, held, 1);
    return {tensor_along_grid(node, a.solid, b.solid), tensor_along_grid(node, a.exchange, b.exchange),
            tensor_along_grid(node, a.fluid, b.fluid)};
}

/// Add velocities to a node's motion; the water's are not used for a body that moves as one phase.
inline void add_velocity(SinglePhaseMotion& motion, const Vector2& solid, const Vector2&)
{
    motion.x += solid.x();
    motion.y += solid.y();
    motion.change_x += solid.x();
    motion.change_y += solid.y();
}

inline void add_velocity(TwoPhaseMotion& motion, const Vector2& solid, const Vector2& fluid)
{
    motion.solid_x += solid.x();
    motion.solid_y += solid.y();
    motion.fluid_x += fluid.x();
    motion.fluid_y += fluid.y();
    motion.solid_change_x += solid.x();
    motion.solid_change_y += solid.y();
    motion.fluid_change_x += fluid.x();
    motion.fluid_change_y += fluid.y();
}

inline Vector2 solid_velocity(const SinglePhaseMotion& motion)
{
    return {motion.x, motion.y};
}

inline Vector2 solid_velocity(const TwoPhaseMotion& motion)
{
    return {motion.solid_x, motion.solid_y};
}

/// Velocity of the grains at the start of the step.
inline Vector2 velocity_before(const SinglePhaseMotion& motion)
{
    return {motion.x - motion.change_x, motion.y - motion.change_y};
}

inline Vector2 velocity_before(const TwoPhaseMotion& motion)
{
    return {motion.solid_x - motion.solid_change_x, motion.solid_y - motion.solid_change_y};
}

inline Vector2 fluid_velocity(const SinglePhaseMotion& motion)
{
    return {motion.x, motion.y};
}

inline Vector2 fluid_velocity(const TwoPhaseMotion& motion)
{
    return {motion.fluid_x, motion.fluid_y};
}

} // namespace quicksand
