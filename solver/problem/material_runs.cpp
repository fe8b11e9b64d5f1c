#include "solver/problem/material_runs.hpp"

#include <algorithm>

namespace quicksand {

std::size_t memory_columns(const Problem& problem)
{
    std::size_t columns = 0;
    for (const Material& material : problem.materials)
        columns = std::max(columns, memory_of(material.law).size());
    return columns;
}

} // namespace quicksand
