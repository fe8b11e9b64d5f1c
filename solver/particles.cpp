#include "solver/particles.hpp"

#include "solver/failure.hpp"

#include <Eigen/LU>
#include <string_view>

namespace quicksand {

namespace {

bool belongs_to_fluid(std::string_view name)
{
    return name.starts_with("velocity_fluid") || name.starts_with("velocity_gradient_fluid") ||
           name == "porosity" || name == "pore_pressure";
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

void resize(Particles& particles, std::size_t count, bool saturated)
{
    for_each_index_array(particles,
                         [&](const char*, std::vector<std::int32_t>& values) { values.assign(count, 0); });
    for_each_array(particles, [&](const char* name, Scalars& values) {
        values.assign(saturated || !belongs_to_fluid(name) ? count : 0, 0.0);
    });
    particles.twist = {};
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
