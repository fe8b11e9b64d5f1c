#include "solver/boundaries/solid_seals.hpp"

#include "solver/base/threads.hpp"
#include "solver/problem/solid_mixture.hpp"

namespace quicksand {

void seal_by_solids(const std::vector<std::uint8_t>& drawn, std::vector<TwoPhaseSums>& sums,
                    NodeConditions& conditions)
{
    constexpr unsigned water_held = fluid_x_fixed | fluid_y_fixed, seals = seal_x | seal_y;
    for_each_index(sums.size(), [&](std::size_t i) {
        const bool sealed = sums[i].drag > sealing_drag * sums[i].volume;
        conditions.of_node[i] =
            sealed ? static_cast<std::uint8_t>((drawn[i] & ~water_held) | seals) : drawn[i];
        if (sealed) sums[i].drag = 0.0;
    });
}

} // namespace quicksand
