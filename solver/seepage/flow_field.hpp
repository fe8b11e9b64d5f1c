// Heads at any point of a section in which water flows, and the free surface.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/seepage/triangle_mesh.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace quicksand {

/// Heads of a mesh's nodes, linear in its triangles.
class FlowField {
public:
    /// One head for every node [m].
    FlowField(TriangleMesh mesh, Scalars head);

    /// The head at a point of the section; just outside it that of the nearest triangle, continued [m].
    double head(const Vector2& point) const { return interpolate(head_, point); }

    /// The same of any values of the nodes.
    double interpolate(const Scalars& of_nodes, const Vector2& point) const;

    /// Height to which the water of the highest wet soil at x stands: the free surface in the soil, or the
    /// level of open water above it; none where the soil at x is dry [m].
    std::optional<double> surface(double x) const;

    const TriangleMesh& mesh() const { return mesh_; }

private:
    std::size_t column_of(double x) const;
    std::size_t row_of(double y) const;
    const std::vector<std::size_t>& box(std::size_t column, std::size_t row) const
    {
        return boxes_[row * columns_ + column];
    }
    std::optional<std::size_t> find(const Vector2& point, std::size_t column, std::size_t row,
                                    double& best) const;

    TriangleMesh mesh_;
    Scalars head_;
    Vector2 lower_ = Vector2::Zero(); // of the boxes that triangles are looked for in [m]
    double box_size_ = 0.0;           // [m]
    std::size_t columns_ = 0, rows_ = 0;
    std::vector<std::vector<std::size_t>> boxes_; // the triangles that reach into each
};

} // namespace quicksand
