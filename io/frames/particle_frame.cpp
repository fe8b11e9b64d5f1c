#include "io/frames/particle_frame.hpp"

#include "io/frames/frame_array.hpp"
#include "solver/interpolation/cut_domains.hpp"

#include <limits>
#include <string>
#include <utility>

namespace quicksand {

namespace {

/// Cell array of a quantity, in single precision; vectors have z = 0.
FrameArray array_of(const Quantity& quantity, const Problem& problem, const Particles& particles)
{
    const std::size_t known = component_count(quantity.form);
    FrameArray array = frame_array(quantity);
    std::vector<float> values(array.component_count() * particles.size(), 0.0F);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const QuantityValues of_particle = quantity.value(problem, particles, p);
        for (std::size_t c = 0; c < known; ++c)
            values[array.component_count() * p + c] = static_cast<float>(of_particle[c]);
    }
    array.values = std::move(values);
    return array;
}

/// Cell array of what soil laws remember; NaN where the particle's law has no such number.
FrameArray array_of(const RememberedQuantity& quantity, const Particles& particles)
{
    std::vector<float> values(particles.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const std::int32_t column = quantity.column[static_cast<std::size_t>(particles.material[p])];
        if (column >= 0)
            values[p] = static_cast<float>(particles.memory[static_cast<std::size_t>(column)][p]);
    }
    return {std::string(quantity.name), std::string(quantity.unit), {}, std::move(values)};
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
    for (const Quantity* quantity : quantities_of(on_particles))
        if (have(particles, *quantity)) frame.cell_data.push_back(array_of(*quantity, problem, particles));
    if (!particles.memory.empty())
        for (const RememberedQuantity& quantity : remembered_quantities(problem))
            frame.cell_data.push_back(array_of(quantity, particles));
    frame.cell_data.push_back({"material", "-", {}, particles.material});
    frame.cell_data.push_back({"region", "-", {}, particles.region});
    frame.cell_data.push_back({"particle_id", "-", {}, particles.identifier});
    frame.texts = {material_names(problem), {"region_names", problem.region_names}};
    return frame;
}

} // namespace quicksand
