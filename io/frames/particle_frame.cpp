#include "io/frames/particle_frame.hpp"

#include "io/frames/particle_quantities.hpp"
#include "solver/interpolation/cut_domains.hpp"

#include <Eigen/LU>
#include <utility>

namespace quicksand {

namespace {

/// Cell array of one value a particle; `value(p)` gives it.
template <class Value>
FrameArray scalar(std::string name, std::string unit, std::size_t count, Value&& value)
{
    std::vector<float> values(count);
    for (std::size_t p = 0; p < count; ++p) values[p] = static_cast<float>(value(p));
    return {std::move(name), std::move(unit), {}, std::move(values)};
}

/// Cell array of vectors with z = 0; `value(p)` gives a Vector2.
template <class Value>
FrameArray vector(std::string name, std::string unit, std::size_t count, Value&& value)
{
    std::vector<float> values(3 * count, 0.0F);
    for (std::size_t p = 0; p < count; ++p) {
        const Vector2 v = value(p);
        values[3 * p] = static_cast<float>(v.x());
        values[3 * p + 1] = static_cast<float>(v.y());
    }
    return {std::move(name), std::move(unit), {"X", "Y", "Z"}, std::move(values)};
}

FrameArray stress_array(const SymmetricTensors& stress)
{
    const std::size_t count = stress.xx.size();
    std::vector<float> values(4 * count);
    for (std::size_t p = 0; p < count; ++p) {
        values[4 * p] = static_cast<float>(stress.xx[p]);
        values[4 * p + 1] = static_cast<float>(stress.yy[p]);
        values[4 * p + 2] = static_cast<float>(stress.zz[p]);
        values[4 * p + 3] = static_cast<float>(stress.xy[p]);
    }
    return {"stress", "Pa", {"XX", "YY", "ZZ", "XY"}, std::move(values)};
}

void add_fluid(const Problem& problem, const Particles& particles, std::vector<FrameArray>& arrays)
{
    const std::size_t count = particles.size();
    if (!particles.velocity_fluid.x.empty())
        arrays.push_back(vector("velocity_fluid", "m/s", count,
                                [&](std::size_t p) { return particles.velocity_fluid[p]; }));
    arrays.push_back(scalar("pore_pressure", "Pa", count,
                            [&](std::size_t p) { return total_pore_pressure(problem, particles, p); }));
    arrays.push_back(scalar("excess_pore_pressure", "Pa", count,
                            [&](std::size_t p) { return risen_pore_pressure(problem, particles, p); }));
    arrays.push_back(scalar("ru", "-", count,
                            [&](std::size_t p) { return excess_pressure_ratio(problem, particles, p); }));
    arrays.push_back(scalar("porosity", "-", count, [&](std::size_t p) { return particles.porosity[p]; }));
}

void add_solid(const Particles& particles, std::vector<FrameArray>& arrays)
{
    const std::size_t count = particles.size();
    const SymmetricTensors& stress = particles.stress;
    arrays.push_back(
        vector("displacement", "m", count, [&](std::size_t p) { return displacement(particles, p); }));
    arrays.push_back(
        vector("velocity_solid", "m/s", count, [&](std::size_t p) { return particles.velocity_solid[p]; }));
    arrays.push_back(scalar("mean_effective_stress", "Pa", count,
                            [&](std::size_t p) { return mean_effective_stress(stress, p); }));
    arrays.push_back(
        scalar("vertical_effective_stress", "Pa", count, [&](std::size_t p) { return -stress.yy[p]; }));
    arrays.push_back(scalar("deviatoric_stress", "Pa", count,
                            [&](std::size_t p) { return deviatoric_stress(stress, p); }));
    arrays.push_back(stress_array(stress));
    arrays.push_back(scalar("shear_strain", "-", count, [&](std::size_t p) {
        return greatest_shear_strain(deformation_gradient(particles, p));
    }));
    arrays.push_back(scalar("volumetric_strain", "-", count, [&](std::size_t p) {
        return deformation_gradient(particles, p).determinant() - 1.0;
    }));
}

FrameText material_names(const Problem& problem)
{
    FrameText text{"material_names", {}};
    for (const Material& material : problem.materials) text.lines.push_back(material.name);
    return text;
}

} // namespace

Frame particle_frame(const Problem& problem, const State& state)
{
    const Particles& particles = state.particles;
    Frame frame;
    frame.time = state.time;
    frame.points.reserve(4 * particles.size());
    frame.cells.corners.reserve(4 * particles.size());
    frame.cells.starts.reserve(particles.size() + 1);
    std::vector<std::int64_t> numbers;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        numbers.clear();
        for (const Vector2& corner : domain_polygon(problem.cut_domains, particles, p)) {
            numbers.push_back(static_cast<std::int64_t>(frame.points.size()));
            frame.points.push_back(corner);
        }
        frame.cells.add(numbers);
    }
    add_solid(particles, frame.cell_data);
    if (particles.has_fluid()) add_fluid(problem, particles, frame.cell_data);
    frame.cell_data.push_back({"material", "-", {}, particles.material});
    frame.cell_data.push_back({"region", "-", {}, particles.region});
    frame.cell_data.push_back({"particle_id", "-", {}, particles.identifier});
    frame.texts = {material_names(problem), {"region_names", problem.region_names}};
    return frame;
}

} // namespace quicksand
