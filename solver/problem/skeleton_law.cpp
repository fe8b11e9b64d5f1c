#include "solver/problem/skeleton_law.hpp"

#include "solver/base/failure.hpp"

#include <utility>

namespace quicksand {

namespace {

template <std::size_t... Index>
std::vector<SkeletonLaw> named_laws(std::index_sequence<Index...>)
{
    std::vector<SkeletonLaw> laws;
    const auto add = [&](const auto& law) {
        if (!name_of(law).empty()) laws.emplace_back(law);
    };
    (add(std::variant_alternative_t<Index, SkeletonLaw>()), ...);
    return laws;
}

} // namespace

std::vector<SkeletonLaw> laws_of_scenes()
{
    return named_laws(std::make_index_sequence<std::variant_size_v<SkeletonLaw>>());
}

void set_value(SkeletonLaw& law, std::size_t key, double value)
{
    std::visit(
        [&](auto& any) {
            const auto keys = keys_of(std::as_const(any));
            ENSURE(key < keys.size());
            any.*keys[key].member = keys[key].factor * value;
        },
        law);
}

double value_of(const SkeletonLaw& law, std::size_t key)
{
    return std::visit(
        [&](const auto& any) {
            const auto keys = keys_of(any);
            ENSURE(key < keys.size());
            return any.*keys[key].member / keys[key].factor;
        },
        law);
}

std::string_view name_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return name_of(any); }, law);
}

std::vector<LawKeyText> keys_of(const SkeletonLaw& law)
{
    std::vector<LawKeyText> texts;
    std::visit(
        [&](const auto& any) {
            for (const auto& key : keys_of(any)) texts.push_back(key.text);
        },
        law);
    return texts;
}

bool flows_at_constant_volume(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return flows_at_constant_volume(any); }, law);
}

LawMemory memory_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return memory_of(any); }, law);
}

std::size_t start_memory(const SkeletonLaw& law, std::size_t first, std::size_t last, Particles& particles)
{
    return std::visit([&](const auto& any) { return start_memory(any, first, last, particles); }, law);
}

bool keeps_history(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return keeps_history(any); }, law);
}

void keep_history(SkeletonLaw& law)
{
    std::visit([](auto& any) { keep_history(any); }, law);
}

void complete_memory(const SkeletonLaw& law, std::size_t first, std::size_t last, Particles& particles)
{
    std::visit([&](const auto& any) { complete_memory(any, first, last, particles); }, law);
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

SkeletonLaw without_weight(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) -> SkeletonLaw { return without_weight(any); }, law);
}

std::optional<VibrationDamping> vibration_damping_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return vibration_damping_of(any); }, law);
}

SkeletonLaw undamped(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) -> SkeletonLaw { return undamped(any); }, law);
}

bool yields(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return yields(any); }, law);
}

bool damps_vibrations(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return damps_vibrations(any); }, law);
}

bool bears_stress_as_drawn(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return bears_stress_as_drawn(any); }, law);
}

bool has_strength(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return has_strength(any); }, law);
}

SkeletonLaw reduced(const SkeletonLaw& law, double factor)
{
    return std::visit([&](const auto& any) -> SkeletonLaw { return reduced(any, factor); }, law);
}

void hold_water(SkeletonLaw& law, double dry_fraction)
{
    std::visit([&](auto& any) { hold_water(any, dry_fraction); }, law);
}

double shear_modulus_at(const SkeletonLaw& law, std::size_t p, const Particles& particles)
{
    return std::visit([&](const auto& any) { return shear_modulus_at(any, p, particles); }, law);
}

double conductivity_factor(const SkeletonLaw& law, std::size_t p, const Particles& particles)
{
    return std::visit([&](const auto& any) { return conductivity_factor(any, p, particles); }, law);
}

StressFloor stress_floor_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return stress_floor_of(any); }, law);
}

std::string objection_to_stress(const SkeletonLaw& law, std::size_t p, const Particles& particles)
{
    return std::visit([&](const auto& any) { return objection_to_stress(any, p, particles); }, law);
}

std::optional<FailureLine> failure_line_of(const SkeletonLaw& law)
{
    return std::visit([](const auto& any) { return failure_line_of(any); }, law);
}

} // namespace quicksand
