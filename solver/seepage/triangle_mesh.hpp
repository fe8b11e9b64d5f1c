// A section divided into triangles.
#pragma once

#include "solver/base/conventions.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace quicksand {

/// Triangles that meet in whole edges, corners counter-clockwise.
struct TriangleMesh {
    std::vector<Vector2> nodes; // [m]
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::size_t> region; // of every triangle: an index into the section's regions
};

/// The area of a triangle and the slopes of its three linear shape functions.
struct TriangleShape {
    explicit TriangleShape(const std::array<Vector2, 3>& corner)
    {
        const Vector2 a = corner[1] - corner[0], b = corner[2] - corner[0];
        area = 0.5 * (a.x() * b.y() - a.y() * b.x());
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector2 opposite = corner[(k + 2) % 3] - corner[(k + 1) % 3];
            slope[k] = Vector2(-opposite.y(), opposite.x()) / (2.0 * area);
        }
    }

    double area = 0.0;            // [m2]
    std::array<Vector2, 3> slope; // of the shape function of each corner [1/m]
};

inline std::array<Vector2, 3> corners_of(const TriangleMesh& mesh, std::size_t triangle)
{
    const auto& nodes = mesh.triangles[triangle];
    return {mesh.nodes[nodes[0]], mesh.nodes[nodes[1]], mesh.nodes[nodes[2]]};
}

} // namespace quicksand
