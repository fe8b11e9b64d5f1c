#include "solver/measure/runaway.hpp"

#include <algorithm>
#include <cstddef>

namespace quicksand {

void Runaway::note(double displacement, double unbalanced)
{
    displacements_.push_back(displacement);
    unbalanced_.push_back(unbalanced);
}

bool Runaway::is_beyond(std::size_t fewest) const
{
    return displacements_.size() >= fewest && least_displacement_ > 0.0 &&
           displacements_.back() >= least_displacement_;
}

bool Runaway::moves_faster() const
{
    constexpr double growth = 1.8;     // of the speed over the second half of the steps; 2 in free motion
    constexpr std::size_t fewest = 16; // looks, two in every window [-]
    if (!is_beyond(fewest)) return false;
    const std::size_t last = displacements_.size(), window = last / 8;
    const auto way = [&](std::size_t end) {
        return displacements_[end - 1] - displacements_[end - 1 - window];
    };
    double before = 0.0; // fastest in the first half
    for (std::size_t end = window + 1; end <= last / 2; ++end) before = std::max(before, way(end));
    const double now = way(last);
    return now > 0.0 && now >= growth * before;
}

bool Runaway::creeps() const
{
    constexpr double least_growth = 1.2; // of the displacement over the second half of the steps [-]
    constexpr double far = 2.0;          // times the least displacement: a body that has slid [-]
    if (displacements_.empty()) return false;
    const bool is_far = displacements_.back() >= far * least_displacement_;
    const double least_left = is_far ? 0.5 : 0.8; // of the force, which falls by orders in a body that stands
    if (!is_beyond(is_far ? 8 : 32)) return false;
    const auto half = static_cast<std::ptrdiff_t>(displacements_.size() / 2);
    if (displacements_.back() < least_growth * displacements_[static_cast<std::size_t>(half)]) return false;
    const double before = *std::min_element(unbalanced_.begin(), unbalanced_.begin() + half);
    return *std::min_element(unbalanced_.begin() + half, unbalanced_.end()) >= least_left * before;
}

} // namespace quicksand
