// A section divided into triangles that fit its outlines.
#pragma once

#include "geometry/section/section.hpp"
#include "solver/seepage/triangle_mesh.hpp"

#include <vector>

namespace quicksand {

/// Delaunay triangles with edges up to `size` [m] and angles of 20 degrees or more, but for sharper corners
/// of the drawing (Ruppert 1995, by CGAL). No triangle reaches over an edge of a region, and every one of
/// `points` that lies on such an edge is a node. The outlines must be sound, see section_check.hpp.
TriangleMesh mesh_section(const Section& section, double size, const std::vector<Vector2>& points = {});

} // namespace quicksand
