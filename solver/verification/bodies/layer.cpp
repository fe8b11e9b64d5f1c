#include "solver/verification/bodies/layer.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace quicksand {

namespace {

/// Whether a piece of the boundary is horizontal at height y.
bool lies_at(const Problem& problem, const Boundary& boundary, double y)
{
    const double near = 1e-6 * problem.grid.cell_size;
    return std::any_of(boundary.segments.begin(), boundary.segments.end(), [&](const Segment& segment) {
        return std::abs(segment.start.y() - y) < near && std::abs(segment.end.y() - y) < near;
    });
}

} // namespace

SaturatedSoil read_soil(const Material& material, const Water& water)
{
    const LinearElastic* law = std::get_if<LinearElastic>(&material.law);
    if (!law) {
        throw InputError("the verification needs the model linear_elastic, which the material \"" +
                         material.name + "\" does not have");
    }
    SaturatedSoil soil;
    soil.constrained_modulus = constrained_modulus(*law);
    soil.shear_modulus = law->shear_modulus;
    soil.porosity = material.porosity;
    soil.grain_density = material.grain_density;
    soil.water_density = water.density;
    soil.water_bulk_modulus = water.bulk_modulus;
    soil.hydraulic_conductivity = material.hydraulic_conductivity;
    soil.conductivity_gravity = material.conductivity_gravity;
    return soil;
}

Layer read_layer(const Problem& problem, const State& state)
{
    if (!problem.water) throw InputError("the verification needs a saturated scene, one with [water]");
    const Particles& particles = state.particles;
    const auto differs = [&](std::int32_t m) { return m != particles.material.front(); };
    if (std::any_of(particles.material.begin(), particles.material.end(), differs)) {
        throw InputError("the verification needs a layer of one material");
    }
    Layer layer;
    layer.soil =
        read_soil(problem.materials[static_cast<std::size_t>(particles.material.front())], *problem.water);
    layer.base = std::numeric_limits<double>::infinity();
    layer.top = -layer.base;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double half = std::abs(particles.half_edge_1.y[p]) + std::abs(particles.half_edge_2.y[p]);
        layer.base = std::min(layer.base, y - half);
        layer.top = std::max(layer.top, y + half);
    }
    return layer;
}

bool is_closed(const Problem& problem, double y)
{
    return std::any_of(problem.boundaries.begin(), problem.boundaries.end(), [&](const Boundary& boundary) {
        const bool closed =
            is_standing_wall(boundary.soil) && std::holds_alternative<Impervious>(boundary.water);
        return closed && lies_at(problem, boundary, y);
    });
}

const SurfaceLoad* surface_load(const Problem& problem, double y)
{
    for (const Boundary& boundary : problem.boundaries) {
        const SurfaceLoad* load = load_of(boundary.soil);
        if (load != nullptr && lies_at(problem, boundary, y)) return load;
    }
    return nullptr;
}

double load_on(const Problem& problem, double y, double time)
{
    const SurfaceLoad* load = surface_load(problem, y);
    return load ? (load->pressure - load->traction.y()) * history_value(load->history, time) : 0.0;
}

double steady_load(const SurfaceLoad& load, const Vector2& outward)
{
    if (!std::holds_alternative<ConstantHistory>(load.history.shape) || load.history.ramp_time > 0.0)
        throw InputError("the verification needs a load that stands from the start\n"
                         "hint: take out its ramp_time and its history");
    return (load.pressure - load.traction.dot(outward)) * history_value(load.history, 0.0);
}

double steady_load_on(const Problem& problem, double y)
{
    const SurfaceLoad* load = surface_load(problem, y);
    return load ? steady_load(*load, Vector2::UnitY()) : 0.0;
}

double root_mean_square(const Particles& particles, const std::function<double(std::size_t)>& difference)
{
    double squares = 0.0, volume = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double apart = difference(p);
        squares += particles.volume[p] * apart * apart;
        volume += particles.volume[p];
    }
    return std::sqrt(squares / volume);
}

std::size_t highest_particle(const Particles& particles)
{
    const Scalars& y = particles.reference_position.y;
    return static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin());
}

} // namespace quicksand
