#include "geometry/section/section_mesh.hpp"

#include "geometry/section/region_locator.hpp"
#include "geometry/section/section_rim.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace quicksand {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Delaunay_mesh_vertex_base_2<Kernel>;
using Faces = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                               CGAL::Exact_predicates_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;

constexpr double least_angle = 0.125; // as the square of its sine: 20.7 degrees, above which the method ends
constexpr double same_place = 1e-9;   // points of neighbours so near are one [of the section's size]

/// The vertices of the drawing, each once: neighbours may have rounded a common one differently.
class CommonVertices {
public:
    explicit CommonVertices(const Section& section)
        : origin_(section.lower), step_(same_place * (section.upper - section.lower).maxCoeff())
    {
    }

    Kernel::Point_2 find(const Vector2& point)
    {
        const auto x = static_cast<std::int64_t>(std::llround((point.x() - origin_.x()) / step_));
        const auto y = static_cast<std::int64_t>(std::llround((point.y() - origin_.y()) / step_));
        for (std::int64_t a = x - 1; a <= x + 1; ++a) {
            for (std::int64_t b = y - 1; b <= y + 1; ++b) {
                const auto found = points_.find({a, b});
                if (found != points_.end()) return found->second;
            }
        }
        return points_.emplace(std::pair(x, y), Kernel::Point_2(point.x(), point.y())).first->second;
    }

private:
    Vector2 origin_; // [m]
    double step_;    // [m]
    std::map<std::pair<std::int64_t, std::int64_t>, Kernel::Point_2> points_;
};

/// The ends of a segment with the points on it between them, in their order.
std::vector<Vector2> stations(const Segment& segment, const std::vector<Vector2>& points)
{
    const Vector2 along = segment.end - segment.start;
    std::vector<std::pair<double, Vector2>> between = {{0.0, segment.start}, {1.0, segment.end}};
    for (const Vector2& point : points) {
        const double fraction = (point - segment.start).dot(along) / along.squaredNorm();
        const double aside = (segment.start + fraction * along - point).norm();
        if (fraction > same_place && fraction < 1.0 - same_place && aside < 1e-6 * along.norm())
            between.emplace_back(fraction, point);
    }
    std::sort(between.begin(), between.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Vector2> stations;
    for (const auto& [fraction, point] : between) stations.push_back(point);
    return stations;
}

/// The triangles in the soil, and the nodes that they have.
TriangleMesh take_soil(const Triangulation& triangulation, const Section& section)
{
    const RegionLocator locator(section);
    TriangleMesh mesh;
    std::map<Triangulation::Vertex_handle, std::size_t> number;
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
        if (!face->is_in_domain()) continue;
        std::array<Vector2, 3> corner;
        for (int k = 0; k < 3; ++k) {
            const Kernel::Point_2& point = face->vertex(k)->point();
            corner[static_cast<std::size_t>(k)] = {point.x(), point.y()};
        }
        const auto region = locator.locate((corner[0] + corner[1] + corner[2]) / 3.0);
        if (!region) continue; // in a void that soil surrounds
        std::array<std::size_t, 3> triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [entry, is_new] = number.emplace(face->vertex(static_cast<int>(k)), mesh.nodes.size());
            if (is_new) mesh.nodes.push_back(corner[k]);
            triangle[k] = entry->second;
        }
        mesh.triangles.push_back(triangle);
        mesh.region.push_back(*region);
    }
    return mesh;
}

} // namespace

TriangleMesh mesh_section(const Section& section, double size, const std::vector<Vector2>& points)
{
    Triangulation triangulation;
    CommonVertices vertices(section);
    for (const Segment& edge : divided_edges(section)) {
        const std::vector<Vector2> places = stations(edge, points);
        for (std::size_t k = 0; k + 1 < places.size(); ++k) {
            const Kernel::Point_2 a = vertices.find(places[k]), b = vertices.find(places[k + 1]);
            if (a != b) triangulation.insert_constraint(a, b);
        }
    }
    CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangulation, Criteria(least_angle, size));
    mesher.refine_mesh();
    return take_soil(triangulation, section);
}

} // namespace quicksand
