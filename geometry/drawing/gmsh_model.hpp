// What the helper program reads out of gmsh's model. Only quicksand-gmsh includes this file.
#pragma once

#include <gmsh.h>

#include <array>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace quicksand {

using Point3 = std::array<double, 3>; // x, y, z [m]
using Polyline = std::vector<Point3>; // a closed one does not repeat its first point

/// A named physical group and the gmsh entities in it.
struct PhysicalGroup {
    std::string name;
    std::vector<int> entities; // gmsh tags
};

/// A quadrilateral, corners counter-clockwise.
using Quad = std::array<Point3, 4>;

/// Curves of the model as polylines, each drawn once, so that neighbouring surfaces share every vertex.
class CurveDrawings {
public:
    /// `tolerance` is the greatest distance of a curved line from its chords [m].
    explicit CurveDrawings(double tolerance) : tolerance_(tolerance) {}

    /// From the curve's start to its end; a closed curve repeats its first point.
    const Polyline& draw(int curve);

private:
    double tolerance_;
    std::map<int, Polyline> drawn_;
};

/// Closed rings of a surface drawn in the .geo file: the outer ring counter-clockwise, holes clockwise.
/// Throws std::string when the surface's curves do not close.
std::vector<Polyline> outline_surface(int surface, CurveDrawings& curves);

/// The mesh's nodes by tag; nodes at the same place are one, as some programs write them once a surface.
class NodeTable {
public:
    NodeTable();
    std::size_t node(std::size_t tag) const { return node_of_tag_.at(tag); }
    const Point3& place(std::size_t node) const { return place_of_node_.at(node); }

private:
    std::unordered_map<std::size_t, std::size_t> node_of_tag_;
    std::unordered_map<std::size_t, Point3> place_of_node_;
};

/// The same rings from the elements: edges that occur once.
std::vector<Polyline> outline_elements(const PhysicalGroup& surfaces, const NodeTable& nodes);

/// The chords of a curve's line elements.
std::vector<Polyline> chords_of_elements(const PhysicalGroup& curves, const NodeTable& nodes);

/// The quadrilaterals of the surfaces' mesh; a triangle is split in three.
std::vector<Quad> quads_of_elements(const PhysicalGroup& surfaces, const NodeTable& nodes);

/// Twice the signed area of a closed polyline in x-y [m2].
double twice_signed_area(const Polyline& ring);

} // namespace quicksand
