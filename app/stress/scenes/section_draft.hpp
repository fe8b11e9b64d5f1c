// The drawing of a section as it is put together: regions with corners and named edges, in gmsh's words.
#pragma once

#include "solver/base/conventions.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

/// An edge of a region from one of its corners to the next.
struct DraftCorner {
    Vector2 at = Vector2::Zero(); // [m]
    std::string curve;            // physical curve of the edge that begins here; "" inside the soil
};

/// Corners that lie at one place are one point, and an edge between two of them is one line, so that regions
/// side by side share what is between them.
class SectionDraft {
public:
    /// A region with its corners, counter-clockwise.
    void add_region(const std::string& name, const std::vector<DraftCorner>& corners);

    /// The .geo file.
    std::string text() const;

private:
    int point_at(const Vector2& place);
    int line_between(int first, int last, const std::string& curve);

    std::vector<Vector2> points_;
    std::vector<std::pair<int, int>> lines_;
    std::vector<std::vector<int>> loops_; // signed numbers of lines
    std::vector<std::string> regions_;    // names, one a loop
    std::map<std::string, std::vector<int>> curves_;
};

/// One region "soil" from (left, lower) to (right, upper) [m] with the curves base, right, surface, left.
SectionDraft draft_rectangle(double left, double lower, double right, double upper);

} // namespace quicksand
