// Runs of particles of one material: laws work through whole arrays.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/problem/problem.hpp"

#include <cstddef>
#include <cstdint>

namespace quicksand {

/// Call visit(material, first, last) for every run of particles of one material in [first, last).
template <class Visit>
void for_each_material_run(const Problem& problem, const Particles& particles, std::size_t first,
                           std::size_t last, Visit&& visit)
{
    while (first < last) {
        const std::int32_t material = particles.material[first];
        std::size_t end = first + 1;
        while (end < last && particles.material[end] == material) ++end;
        visit(problem.materials[static_cast<std::size_t>(material)], first, end);
        first = end;
    }
}

/// The longest memory of the problem's laws [numbers].
std::size_t memory_columns(const Problem& problem);

} // namespace quicksand
