#include "solver/particles/particles.hpp"

#include "solver/base/failure.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <string>

namespace quicksand {

namespace {

/// Whether such a flow needs the arrays of a group.
bool needs(std::optional<WaterFlow> flow, ArrayGroup group)
{
    switch (group) {
    case ArrayGroup::always:
        return true;
    case ArrayGroup::pores:
        return flow.has_value();
    case ArrayGroup::pressure:
        return flow == WaterFlow::coupled || flow == WaterFlow::undrained;
    case ArrayGroup::fluid_motion:
        return flow == WaterFlow::coupled;
    case ArrayGroup::kept_water:
        return flow == WaterFlow::undrained;
    case ArrayGroup::cavities:
    case ArrayGroup::water_table:
    case ArrayGroup::pressure_rate:
    case ArrayGroup::twist:
    case ArrayGroup::stages:
    case ArrayGroup::memory:
        return false;
    }
    ENSURE(false);
}

template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::int32_t>& order, std::vector<Value>& buffer)
{
    if (values.empty()) return;
    ENSURE(values.size() == order.size());
    buffer.resize(values.size());
    for (std::size_t k = 0; k < order.size(); ++k) buffer[k] = values[static_cast<std::size_t>(order[k])];
    values.swap(buffer);
}

} // namespace

const char* memory_name(std::size_t column)
{
    constexpr std::size_t most = 100;
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (std::size_t k = 0; k < most; ++k)
            all.push_back((k < 10 ? "memory_0" : "memory_") + std::to_string(k));
        return all;
    }();
    return names.at(column).c_str();
}

ArrayGroup group_of(std::string_view name)
{
    if (name.starts_with("velocity_fluid") || name.starts_with("affine_velocity_fluid"))
        return ArrayGroup::fluid_motion;
    if (name == "porosity") return ArrayGroup::pores;
    if (name == "pore_pressure") return ArrayGroup::pressure;
    if (name == "pore_pressure_rate") return ArrayGroup::pressure_rate;
    if (name == "water_volume") return ArrayGroup::kept_water;
    if (name == "tension_deficit") return ArrayGroup::cavities;
    if (name == "water_table") return ArrayGroup::water_table;
    if (name.starts_with("twist")) return ArrayGroup::twist;
    if (name.starts_with("former_displacement")) return ArrayGroup::stages;
    return name.starts_with("memory_") ? ArrayGroup::memory : ArrayGroup::always;
}

void resize(Particles& particles, std::size_t count, std::optional<WaterFlow> flow)
{
    particles.memory.clear();
    for_each_index_array(particles,
                         [&](const char*, std::vector<std::int32_t>& values) { values.assign(count, 0); });
    for_each_array(particles, [&](const char* name, Scalars& values) {
        values.assign(needs(flow, group_of(name)) ? count : 0, 0.0);
    });
}

void add_memory(Particles& particles, std::size_t columns)
{
    particles.memory.assign(columns, Scalars(particles.size(), 0.0));
}

std::optional<WaterFlow> carried_flow(const Particles& particles)
{
    if (!particles.velocity_fluid.x.empty()) return WaterFlow::coupled;
    if (!particles.water_volume.empty()) return WaterFlow::undrained;
    if (!particles.porosity.empty()) return WaterFlow::drained;
    return std::nullopt;
}

void reorder(Particles& particles, const std::vector<std::int32_t>& order)
{
    std::vector<std::int32_t> index_buffer;
    for_each_index_array(particles, [&](const char*, std::vector<std::int32_t>& values) {
        permute(values, order, index_buffer);
    });
    Scalars buffer;
    for_each_array(particles, [&](const char*, Scalars& values) { permute(values, order, buffer); });
}

void add_former_displacement(Particles& particles)
{
    particles.former_displacement = {Scalars(particles.size(), 0.0), Scalars(particles.size(), 0.0)};
}

void keep_displacement(Particles& particles)
{
    Vectors& former = particles.former_displacement;
    for (std::size_t p = 0; p < former.x.size(); ++p)
        former.set(p, former[p] + particles.position[p] - particles.reference_position[p]);
}

void reset_reference(Particles& particles)
{
    particles.reference_position = particles.position;
    particles.reference_edge_1 = particles.half_edge_1;
    particles.reference_edge_2 = particles.half_edge_2;
}

void return_to_reference(Particles& particles)
{
    particles.position = particles.reference_position;
    particles.half_edge_1 = particles.reference_edge_1;
    particles.half_edge_2 = particles.reference_edge_2;
}

void set_at_rest(Particles& particles)
{
    for_each_array(particles, [](const char* name, Scalars& values) {
        if (std::string_view(name).find("velocity") != std::string_view::npos)
            std::fill(values.begin(), values.end(), 0.0);
    });
}

Eigen::Matrix2d deformation_gradient(const Particles& particles, std::size_t p)
{
    // r_a = F r_a0 for both edges: F = [r_1 r_2] [r_10 r_20]^-1
    Eigen::Matrix2d now, reference;
    now << particles.half_edge_1[p], particles.half_edge_2[p];
    reference << particles.reference_edge_1[p], particles.reference_edge_2[p];
    return now * reference.inverse();
}

std::size_t memory_bytes(const Particles& particles)
{
    std::size_t bytes = 0;
    const auto count = [&](const char*, const auto& values) {
        bytes += values.capacity() * sizeof(values[0]);
    };
    for_each_index_array(particles, count);
    for_each_array(particles, count);
    return bytes;
}

} // namespace quicksand
