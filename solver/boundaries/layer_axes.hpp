// The axes of a node's drag: those of the grid, or along and across slanted layers.
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/boundaries/nodes.hpp"

namespace quicksand {

/// Whether the axes of the drag are not those of the grid. Such nodes have no conditions on their directions.
inline bool is_slanted(const TwoPhaseSums& node)
{
    return node.layer_y != 0.0;
}
inline bool is_slanted(const SinglePhaseSums&)
{
    return false;
}

/// Components of a vector along the axes of the drag, and back.
inline Vector2 along_layers(const TwoPhaseSums& node, const Vector2& v)
{
    return {node.layer_x * v.x() + node.layer_y * v.y(), node.layer_x * v.y() - node.layer_y * v.x()};
}
inline Vector2 along_grid(const TwoPhaseSums& node, const Vector2& v)
{
    return {node.layer_x * v.x() - node.layer_y * v.y(), node.layer_y * v.x() + node.layer_x * v.y()};
}

/// The symmetric tensor with these principal values, by the axes of the grid.
inline Eigen::Matrix2d tensor_along_grid(const TwoPhaseSums& node, double first, double second)
{
    if (!is_slanted(node)) return Vector2(first, second).asDiagonal();
    const double x = node.layer_x, y = node.layer_y, xy = x * y * (first - second);
    return (Eigen::Matrix2d() << x * x * first + y * y * second, xy, xy, y * y * first + x * x * second)
        .finished();
}
inline Eigen::Matrix2d tensor_along_grid(const SinglePhaseSums&, double first, double second)
{
    return Vector2(first, second).asDiagonal();
}

/// The drag on the velocities at the end of the step; none where there is no water [N s/m2].
inline Eigen::Matrix2d drag_tensor(const TwoPhaseSums& node)
{
    if (node.mass_fluid == 0.0) return Eigen::Matrix2d::Zero();
    return tensor_along_grid(node, node.drag_1, node.drag_2);
}

} // namespace quicksand
