// Which cells of a block touch which nodes.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/walls/cell_roots.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace quicksand {

/// A node whose velocity along an axis is the sum of weight times that of others.
struct FollowingNode {
    std::size_t node = 0;
    int axis = 0; // 0: x, 1: y
    std::vector<FollowedNode> followed;
};

/// A cell's part in a node: its row in the block, and D.
struct Touch {
    std::size_t row;
    double x, y; // D [m2/m]
};

/// Of all nodes the cells of one block that touch them, tied nodes as one. Who touches a node that follows
/// others touches those.
class NodeTouches {
public:
    /// The arguments must outlive it.
    NodeTouches(const NodeConditions& conditions, const std::vector<FollowingNode>& following)
        : master_(conditions.master),
          touches_(conditions.master.size()), following_{Followers(master_.size(), nullptr),
                                                         Followers(master_.size(), nullptr)}
    {
        for (const FollowingNode& follower : following)
            following_[static_cast<std::size_t>(follower.axis)][follower.node] = &follower.followed;
    }

    void add(std::size_t node, const Touch& touch)
    {
        const std::size_t i = master_[node];
        const auto* of_x = following_[0][i];
        const auto* of_y = following_[1][i];
        if (of_x == nullptr || of_y == nullptr)
            put(i, {touch.row, of_x == nullptr ? touch.x : 0.0, of_y == nullptr ? touch.y : 0.0});
        if (of_x != nullptr)
            for (const FollowedNode& other : *of_x) put(other.node, {touch.row, other.weight * touch.x, 0.0});
        if (of_y != nullptr)
            for (const FollowedNode& other : *of_y) put(other.node, {touch.row, 0.0, other.weight * touch.y});
    }

    /// The touches of a node that follows none.
    const std::vector<Touch>& of(std::size_t node) const { return touches_[node]; }

    /// Call work(node, touches) and forget them.
    template <class Work>
    void for_each(Work&& work) const
    {
        for (const std::size_t node : touched_) work(node, touches_[node]);
    }

    void clear()
    {
        for (const std::size_t node : touched_) touches_[node].clear();
        touched_.clear();
    }

private:
    using Followers = std::vector<const std::vector<FollowedNode>*>; // by node; none for most

    void put(std::size_t node, const Touch& touch)
    {
        if (touches_[node].empty()) touched_.push_back(node);
        touches_[node].push_back(touch);
    }

    const std::vector<std::size_t>& master_;
    std::vector<std::vector<Touch>> touches_;
    std::array<Followers, 2> following_; // by axis
    std::vector<std::size_t> touched_;
};

} // namespace quicksand
