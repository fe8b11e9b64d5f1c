#include "solver/seepage/flow_field.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

struct Extent {
    Vector2 lower, upper; // [m]
};

Extent extent_of(const std::array<Vector2, 3>& corner)
{
    return {corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]),
            corner[0].cwiseMax(corner[1]).cwiseMax(corner[2])};
}

/// The three shape functions at a point [-].
std::array<double, 3> shares(const std::array<Vector2, 3>& corner, const Vector2& point)
{
    const TriangleShape shape(corner);
    std::array<double, 3> share;
    for (std::size_t k = 0; k < 3; ++k) share[k] = shape.slope[k].dot(point - corner[(k + 1) % 3]);
    return share;
}

/// The highest point of a triangle on a vertical line, of those with positive pressure: y and the height to
/// which its water stands.
struct WetTop {
    double y, stands; // [m]
};

std::optional<WetTop> wet_top(const std::array<Vector2, 3>& corner, const std::array<double, 3>& head,
                              double x)
{
    std::vector<std::pair<double, double>> cuts; // y and head where the line meets the edges [m]
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2 &a = corner[k], &b = corner[(k + 1) % 3];
        if ((a.x() < x && b.x() < x) || (a.x() > x && b.x() > x)) continue;
        if (a.x() == b.x()) {
            cuts.emplace_back(a.y(), head[k]);
            cuts.emplace_back(b.y(), head[(k + 1) % 3]);
            continue;
        }
        const double t = (x - a.x()) / (b.x() - a.x());
        cuts.emplace_back(a.y() + t * (b.y() - a.y()), head[k] + t * (head[(k + 1) % 3] - head[k]));
    }
    if (cuts.empty()) return std::nullopt;
    const auto [low, high] = std::minmax_element(cuts.begin(), cuts.end());
    const double below = low->second - low->first, above = high->second - high->first;
    if (above > 0.0) return WetTop{high->first, high->second};
    if (!(below > 0.0)) return std::nullopt;
    const double y = low->first + below / (below - above) * (high->first - low->first);
    return WetTop{y, y};
}

} // namespace

FlowField::FlowField(TriangleMesh mesh, Scalars head) : mesh_(std::move(mesh)), head_(std::move(head))
{
    ENSURE(!mesh_.triangles.empty() && head_.size() == mesh_.nodes.size());
    Vector2 upper = lower_ = mesh_.nodes.front();
    for (const Vector2& node : mesh_.nodes) {
        lower_ = lower_.cwiseMin(node);
        upper = upper.cwiseMax(node);
    }
    const Vector2 size = upper - lower_;
    box_size_ = std::sqrt(size.x() * size.y() / static_cast<double>(mesh_.triangles.size()));
    columns_ = static_cast<std::size_t>(size.x() / box_size_) + 1;
    rows_ = static_cast<std::size_t>(size.y() / box_size_) + 1;
    boxes_.resize(columns_ * rows_);
    for (std::size_t e = 0; e < mesh_.triangles.size(); ++e) {
        const Extent extent = extent_of(corners_of(mesh_, e));
        for (std::size_t row = row_of(extent.lower.y()); row <= row_of(extent.upper.y()); ++row)
            for (std::size_t column = column_of(extent.lower.x()); column <= column_of(extent.upper.x());
                 ++column)
                boxes_[row * columns_ + column].push_back(e);
    }
}

std::size_t FlowField::column_of(double x) const
{
    return std::min(columns_ - 1, static_cast<std::size_t>(std::max(0.0, (x - lower_.x()) / box_size_)));
}

std::size_t FlowField::row_of(double y) const
{
    return std::min(rows_ - 1, static_cast<std::size_t>(std::max(0.0, (y - lower_.y()) / box_size_)));
}

/// The triangle of a box whose least share of the point is the largest and larger than `best`.
std::optional<std::size_t> FlowField::find(const Vector2& point, std::size_t column, std::size_t row,
                                           double& best) const
{
    std::optional<std::size_t> found;
    for (const std::size_t e : box(column, row)) {
        const auto share = shares(corners_of(mesh_, e), point);
        const double least = std::min({share[0], share[1], share[2]});
        if (!(least > best)) continue;
        best = least;
        found = e;
    }
    return found;
}

double FlowField::interpolate(const Scalars& of_nodes, const Vector2& point) const
{
    constexpr double outside = 1e-6; // a point so little outside counts as inside [-]
    double best = -std::numeric_limits<double>::infinity();
    std::optional<std::size_t> triangle = find(point, column_of(point.x()), row_of(point.y()), best);
    for (std::size_t row = 0; best < -outside && row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column)
            if (const auto nearer = find(point, column, row, best)) triangle = nearer;
    ENSURE(triangle.has_value());
    const auto share = shares(corners_of(mesh_, *triangle), point);
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) sum += share[k] * of_nodes[mesh_.triangles[*triangle][k]];
    return sum;
}

std::optional<double> FlowField::surface(double x) const
{
    std::optional<WetTop> highest;
    const std::size_t column = column_of(x);
    for (std::size_t row = 0; row < rows_; ++row) {
        for (const std::size_t e : box(column, row)) {
            const auto& nodes = mesh_.triangles[e];
            const auto top =
                wet_top(corners_of(mesh_, e), {head_[nodes[0]], head_[nodes[1]], head_[nodes[2]]}, x);
            if (top && (!highest || top->y > highest->y)) highest = top;
        }
    }
    if (!highest) return std::nullopt;
    return highest->stands;
}

} // namespace quicksand
