#include "solver/walls/wall_parts.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// A curve at a node.
struct Curve {
    double length;  // under the node's function [m]
    Vector2 normal; // [-]
};

bool are_parallel(const std::vector<Curve>& curves)
{
    constexpr double one_direction = 1e-3; // sine [-]
    const Vector2& first = curves.front().normal;
    return std::all_of(curves.begin(), curves.end(), [&](const Curve& curve) {
        return std::abs(first.x() * curve.normal.y() - first.y() * curve.normal.x()) < one_direction &&
               first.dot(curve.normal) > 0.0;
    });
}

/// What each curve's length is multiplied with so that the curves' normals add up to `normal`, as near as
/// curves that are almost parallel tell.
void correct_lengths(const Vector2& normal, std::vector<Curve>& curves)
{
    double total = 0.0;
    for (const Curve& curve : curves) total += curve.length;
    if (are_parallel(curves)) {
        const double factor = std::max(0.0, normal.dot(curves.front().normal)) / total;
        for (Curve& curve : curves) curve.length *= factor;
        return;
    }
    Eigen::Matrix2d metric = Eigen::Matrix2d::Zero();
    Vector2 missing = normal;
    for (const Curve& curve : curves) {
        metric += curve.length * curve.normal * curve.normal.transpose();
        missing -= curve.length * curve.normal;
    }
    // curves that are almost parallel tell little across themselves: there their lengths stay nearly as they
    // are
    constexpr double telling = 1e-3, weak = 1e-5;
    const bool tells = metric.determinant() > telling * total * total;
    if (!tells) metric += weak * total * Eigen::Matrix2d::Identity();
    const Vector2 change = metric.inverse() * missing;
    double sum = 0.0;
    for (Curve& curve : curves) {
        curve.length *= std::max(0.0, 1.0 + curve.normal.dot(change));
        sum += curve.length;
    }
    // a node that almost no soil touches has almost no part, however long the curves beside it
    constexpr double most = 20.0; // of the normal's length, in a tip of some three degrees
    if (!tells && sum > most * normal.norm())
        for (Curve& curve : curves) curve.length *= most * normal.norm() / sum;
}

/// How long the wall is for the node. Beyond its end, where it goes on straight, it counts only where soil
/// has come to it: part of the node's normal, `missing`, is none of the curves drawn there. Otherwise the
/// wall would hold the face that lies beside its end.
double reached_length(const WallContact& contact, double cell_size, const Vector2& missing)
{
    constexpr double little = 0.05; // [cells]
    return missing.dot(contact.normal) > little * cell_size ? contact.length : contact.drawn;
}

/// Direction of a bent wall at a node that no other curve touches.
Vector2 bent_direction(const WallContact& contact, const Vector2& normal)
{
    constexpr double least_cosine = 0.7;
    const double length = normal.norm();
    return normal.dot(contact.normal) > least_cosine * length && length > 0.0 ? Vector2(normal / length)
                                                                              : contact.normal;
}

} // namespace

std::vector<WallPart> divide_normals(double cell_size, const SoilEdges& edges, const WallContacts& contacts,
                                     const std::vector<std::uint8_t>& active, const Vectors& normal)
{
    std::vector<WallPart> parts;
    std::vector<Curve> curves, no_walls;
    std::vector<const WallContact*> reached;
    auto other = contacts.others.begin();
    for (auto first = contacts.walls.begin(); first != contacts.walls.end();) {
        const std::size_t node = first->node;
        const auto last = std::find_if(first, contacts.walls.end(),
                                       [&](const WallContact& contact) { return contact.node != node; });
        other = std::find_if(other, contacts.others.end(),
                             [&](const EdgeContact& contact) { return contact.node >= node; });
        if (active[node] == 0) {
            first = last;
            continue;
        }
        Vector2 missing = normal[node];
        for (auto contact = first; contact != last; ++contact) missing -= contact->drawn * contact->normal;
        no_walls.clear();
        for (auto edge = other; edge != contacts.others.end() && edge->node == node; ++edge) {
            no_walls.push_back({edge->length, edge->normal});
            missing -= edge->length * edge->normal;
        }
        curves.clear();
        reached.clear();
        for (; first != last; ++first) {
            const double length = reached_length(*first, cell_size, missing);
            if (length <= 0.0) continue;
            reached.push_back(&*first);
            curves.push_back({length, first->normal});
        }
        if (reached.empty()) continue;
        curves.insert(curves.end(), no_walls.begin(), no_walls.end());
        if (curves.size() == 1 && !edges.chains[reached.front()->chain].straight)
            curves.front().normal = bent_direction(*reached.front(), normal[node]);
        correct_lengths(normal[node], curves);
        for (std::size_t k = 0; k < reached.size(); ++k)
            if (curves[k].length > 0.0) parts.push_back({reached[k], curves[k].length, curves[k].normal});
    }
    return parts;
}

} // namespace quicksand
