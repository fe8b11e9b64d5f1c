// A drawn cross-section: named regions (one material each), named boundary curves and named points.
#pragma once

#include "solver/problem/problem.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// A simple closed polygon, without repeating the first vertex [m].
using Ring = std::vector<Vector2>;

/// A polygon with holes: the outer ring counter-clockwise, the holes clockwise.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
};

/// A physical surface: one or several polygons that share a name and a material.
struct Region {
    std::string name;
    std::vector<Polygon> polygons;
};

/// A physical curve. Segments that lie on the rim of the soil have the soil on their left.
struct NamedCurve {
    std::string name;
    std::vector<Segment> segments;
};

/// A physical point.
struct NamedPoint {
    std::string name;
    Vector2 position = Vector2::Zero(); // [m]
};

/// A quadrilateral of a recombined mesh, corners counter-clockwise [m].
struct MeshQuad {
    Vector2 corners[4];
    std::size_t region = 0; // index into Section::regions
};

struct Box {
    Vector2 lower, upper; // corners [m]
};

struct Section {
    std::vector<Region> regions;
    std::vector<NamedCurve> curves;
    std::vector<NamedPoint> points;
    std::vector<MeshQuad> quads;                              // only when asked for
    std::vector<Box> nameless;                                // around drawn surfaces in no region
    Vector2 lower = Vector2::Zero(), upper = Vector2::Zero(); // bounding box [m]
};

/// Set the bounding box from the regions' outlines.
void bound_section(Section& section);

/// Exact area of a region's polygons, holes taken out [m2].
double area(const Region& region);

/// Length of soil of each region on the vertical line above a point [m]; one entry per region.
std::vector<double> thickness_above(const Section& section, const Vector2& point);

} // namespace quicksand
