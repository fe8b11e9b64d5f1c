#include "solver/problem/skeleton_law.hpp"

namespace quicksand {

LawMemory memory_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return memory_of(any); }, law);
}

std::size_t start_memory(const SkeletonLaw& law, std::size_t first, std::size_t last, Particles& particles)
{
    return std::visit([&](const auto& any) { return start_memory(any, first, last, particles); }, law);
}

std::size_t count_at_failure(const SkeletonLaw& law, std::size_t first, std::size_t last,
                             const Particles& particles)
{
    return std::visit([&](const auto& any) { return count_at_failure(any, first, last, particles); }, law);
}

SkeletonLaw settling_form(const SkeletonLaw& law, double cell_weight)
{
    return std::visit([&](const auto& any) -> SkeletonLaw { return settling_form(any, cell_weight); }, law);
}

bool yields(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return yields(any); }, law);
}

bool has_strength(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return has_strength(any); }, law);
}

SkeletonLaw reduced(const SkeletonLaw& law, double factor)
{
    return std::visit([&](const auto& any) -> SkeletonLaw { return reduced(any, factor); }, law);
}

void hold_water(SkeletonLaw& law, double dry_share)
{
    std::visit([&](auto& any) { hold_water(any, dry_share); }, law);
}

} // namespace quicksand
