#include "solver/wall_corners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

Vector2 across(const Vector2& direction)
{
    return {-direction.y(), direction.x()};
}

/// Walls that turn by less than this are one bent wall, along which soil slides; others make a corner.
bool are_one_wall(const Vector2& a, const Vector2& b)
{
    return std::abs(a.dot(b)) > std::abs(a.dot(across(b))); // 45 degrees
}

/// The directions in which something does not move: none, one, or all.
class HeldDirections {
public:
    void add(const Vector2& direction)
    {
        if (count_ == 0) {
            first_ = direction;
            count_ = 1;
        } else if (!are_one_wall(first_, direction)) {
            count_ = 2;
        } else if (count_ == 1) {
            first_ = (first_ + std::copysign(1.0, first_.dot(direction)) * direction).normalized();
        }
    }
    int count() const { return count_; }
    const Vector2& first() const { return first_; }

private:
    int count_ = 0;
    Vector2 first_ = Vector2::Zero(); // [-]
};

/// What all walls at a node hold.
class Corner {
public:
    void add(const Vector2& normal, std::uint8_t conditions)
    {
        if (conditions & solid_x_fixed) grains_.add(normal);
        if (conditions & solid_y_fixed) grains_.add(across(normal));
        if (conditions & (fluid_x_fixed | film_x)) flow_.add(normal);
        if (conditions & (fluid_y_fixed | film_y)) flow_.add(across(normal));
    }

    /// As one wall; a film where grains are held holds the water as well.
    SlantedNode as_one_wall(std::size_t node) const
    {
        SlantedNode wall{node, Vector2::UnitX(), 0};
        if (grains_.count() == 1) {
            wall.normal = grains_.first();
        } else if (flow_.count() == 1) {
            wall.normal = flow_.first();
        }
        if (grains_.count() > 0) wall.conditions |= solid_x_fixed;
        if (grains_.count() > 1) wall.conditions |= solid_y_fixed;
        const bool along_normal = are_one_wall(flow_.first(), wall.normal);
        if (flow_.count() == 2 || (flow_.count() == 1 && along_normal)) wall.conditions |= film_x;
        if (flow_.count() == 2 || (flow_.count() == 1 && !along_normal)) wall.conditions |= film_y;
        return wall;
    }

private:
    HeldDirections grains_, flow_; // flow of the water relative to the grains
};

} // namespace

std::uint8_t turned(std::uint8_t conditions)
{
    constexpr unsigned all_x = solid_x_fixed | fluid_x_fixed | film_x;
    constexpr unsigned all_y = solid_y_fixed | fluid_y_fixed | film_y;
    return static_cast<std::uint8_t>((conditions & all_x) << 1 | (conditions & all_y) >> 1);
}

void merge_corners(NodeConditions& conditions)
{
    std::vector<SlantedNode> walls = std::exchange(conditions.slanted, {});
    std::stable_sort(walls.begin(), walls.end(),
                     [](const SlantedNode& a, const SlantedNode& b) { return a.node < b.node; });
    constexpr double aligned_with_grid = 1e-9; // sine of the angle [-]
    for (auto first = walls.begin(); first != walls.end();) {
        const auto last = std::find_if(first, walls.end(),
                                       [&](const SlantedNode& wall) { return wall.node != first->node; });
        std::uint8_t& aligned = conditions.of_node[first->node];
        SlantedNode wall = *first;
        if (last - first > 1 || aligned != 0) {
            Corner corner;
            for (auto meeting = first; meeting != last; ++meeting)
                corner.add(meeting->normal, meeting->conditions);
            corner.add(Vector2::UnitX(), aligned);
            wall = corner.as_one_wall(first->node);
        }
        aligned = 0;
        if (std::abs(wall.normal.y()) <= aligned_with_grid) {
            aligned = wall.conditions;
        } else if (std::abs(wall.normal.x()) <= aligned_with_grid) {
            aligned = turned(wall.conditions);
        } else {
            conditions.slanted.push_back(wall);
        }
        first = last;
    }
}

} // namespace quicksand
