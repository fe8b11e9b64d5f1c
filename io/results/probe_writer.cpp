#include "io/results/probe_writer.hpp"

#include "io/assembly/probe_places.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"
#include "solver/measure/monitors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace quicksand {

namespace {

/// What the probe looks at, in words.
std::string description(const SceneProbe& probe, std::int32_t identifier)
{
    const Vector2 at = *probe.at;
    switch (probe.kind) {
    case ProbeKind::material:
        return fmt::format("{}, material: rides with particle {}, nearest to ({}, {}) m when drawn",
                           probe.name, identifier, at.x(), at.y());
    case ProbeKind::fixed:
        return fmt::format(
            "{}, fixed: the point ({}, {}) m, interpolated in the nodal averages; empty where there is "
            "no soil",
            probe.name, at.x(), at.y());
    case ProbeKind::surface:
        return fmt::format(
            "{}, surface: the highest soil at x = {} m; displacement and velocity of the surface, "
            "all else of the particle that is there",
            probe.name, at.x());
    case ProbeKind::profile:
        return fmt::format(
            "{}, profile: {} fixed points from ({}, {}) to ({}, {}) m, interpolated in the nodal "
            "averages; empty where there is no soil",
            probe.name, probe.points, at.x(), at.y(), probe.to->x(), probe.to->y());
    }
    return probe.name;
}

std::vector<PointSample> interpolate(const std::vector<PointSample>& from, const std::vector<PointSample>& to,
                                     double weight)
{
    std::vector<PointSample> between;
    for (std::size_t k = 0; k < from.size(); ++k) between.push_back(interpolate(from[k], to[k], weight));
    return between;
}

/// What is written of a sample. A dry scene has no columns of the water, one without stages none of their
/// sum.
std::vector<const Quantity*> written_quantities(const Particles& particles)
{
    std::vector<const Quantity*> quantities = quantities_of(at_probes);
    std::erase_if(quantities, [&](const Quantity* each) { return !have(particles, *each); });
    return quantities;
}

std::vector<std::string> probe_comments(const SceneProbe& probe, std::int32_t identifier,
                                        const RunLabel& label, const Problem& problem,
                                        const std::vector<const Quantity*>& quantities)
{
    std::vector<std::string> comments = run_comments(label);
    comments.push_back("probe: " + description(probe, identifier));
    for (const Quantity* quantity : quantities) {
        const bool scalar = quantity->form == QuantityForm::scalar;
        const std::string_view name = scalar ? quantity->name : quantity->symbol;
        if (!name.empty()) comments.push_back(fmt::format("{}: {}", name, quantity->meaning));
    }
    const bool of_particle = probe.kind == ProbeKind::material || probe.kind == ProbeKind::surface;
    if (of_particle)
        comments.emplace_back("stresses: of a plane through the particles of its soil within a cell around");
    if (problem.water) {
        comments.push_back(
            of_particle
                ? fmt::format(
                      "ru is empty where the vertical effective stress at the start is below {:.4g} Pa",
                      ru_stress_threshold(problem))
                : fmt::format("for ru the vertical effective stress at the start is {:.4g} Pa at least",
                              ru_stress_threshold(problem)));
    }
    comments.push_back("an empty cell: no soil or no value");
    return comments;
}

std::vector<std::string> probe_columns(const SceneProbe& probe,
                                       const std::vector<const Quantity*>& quantities)
{
    std::vector<std::string> columns{"time_s"};
    if (probe.kind == ProbeKind::profile) columns.emplace_back("distance_m");
    for (const Quantity* quantity : quantities)
        for (std::size_t c = 0; c < component_count(quantity->form); ++c)
            columns.push_back(probe_column(*quantity, c));
    return columns;
}

void require_place(const SceneProbe& probe)
{
    if (!probe.at) throw InputError("probe '" + probe.name + "' has no place: give it `at`");
    if (probe.kind == ProbeKind::profile && !probe.to)
        throw InputError("probe '" + probe.name + "' is a profile and has no end: give it `to`");
}

/// The particle a material probe rides with; a point more than two cells from any soil is a mistake.
std::int32_t find_rider(const SceneProbe& probe, const Problem& problem, const Particles& particles)
{
    if (probe.rider) return *probe.rider;
    if (const auto wrong = outside_soil(problem, particles, *probe.at))
        throw InputError("probe '" + probe.name + "' " + *wrong);
    return particles.identifier[nearest_particle(particles, *probe.at)];
}

std::size_t index_of(const Particles& particles, std::int32_t identifier)
{
    const auto found = std::find(particles.identifier.begin(), particles.identifier.end(), identifier);
    ENSURE(found != particles.identifier.end());
    return static_cast<std::size_t>(found - particles.identifier.begin());
}

} // namespace

ProbeWriter::ProbeWriter(const Scene& scene, const Problem& problem, const State& state,
                         const RunLabel& label, const std::filesystem::path& results, bool resume)
    : quantities_(written_quantities(state.particles)), clock_(scene.output.probe_interval, scene.end_time)
{
    // A kill may have come between two files: go on after the shortest one; write() leaves the others alone.
    double last_time = std::numeric_limits<double>::infinity();
    for (const SceneProbe& scene_probe : scene.probes) {
        probes_.push_back(open_probe(scene_probe, problem, state, label, results, resume));
        if (scene_probe.kind == ProbeKind::fixed || scene_probe.kind == ProbeKind::profile) {
            const std::vector<Vector2> points = points_of(scene_probe);
            fixed_points_.insert(fixed_points_.end(), points.begin(), points.end());
        }
        last_time = std::min(last_time, probes_.back().file.last_time().value_or(-1.0));
    }
    if (!probes_.empty()) clock_.go_on(state.time, last_time);
}

ProbeWriter::Probe ProbeWriter::open_probe(const SceneProbe& scene_probe, const Problem& problem,
                                           const State& state, const RunLabel& label,
                                           const std::filesystem::path& results, bool resume) const
{
    require_place(scene_probe);
    std::int32_t identifier = -1;
    if (scene_probe.kind == ProbeKind::material)
        identifier = find_rider(scene_probe, problem, state.particles);
    const auto path = ResultsFolder{results}.probe(scene_probe.name);
    const auto comments = probe_comments(scene_probe, identifier, label, problem, quantities_);
    const auto columns = probe_columns(scene_probe, quantities_);
    Probe probe{scene_probe,
                identifier,
                resume ? CsvFile::resume(path, comments, columns, state.time)
                       : CsvFile::begin(path, comments, columns),
                PointSample::none,
                {}};
    // The numbers in the file read back exactly, so accelerations go on as if there had been no stop.
    if (const auto last = probe.file.last_time()) probe.previous_time = *last;
    const Quantity& velocity = quantity_named("velocity_solid");
    for (const CsvRow& row : probe.file.last_rows())
        probe.previous_velocities.emplace_back(probe.file.value(row, probe_column(velocity, 0)),
                                               probe.file.value(row, probe_column(velocity, 1)));
    return probe;
}

void ProbeWriter::before_step(const Problem& problem, const State& state, double)
{
    start_time_ = state.time;
    starts_ = end_time_ == state.time ? ends_ : sample(problem, state);
}

void ProbeWriter::observe(const Problem& problem, const State& state, const StepReport&)
{
    ends_ = sample(problem, state);
    end_time_ = state.time;
    clock_.strike(start_time_, state.time, [&](double time, double weight) {
        for (std::size_t k = 0; k < probes_.size(); ++k)
            write(probes_[k], time, weight < 1.0 ? interpolate(starts_[k], ends_[k], weight) : ends_[k]);
    });
}

std::vector<std::vector<PointSample>> ProbeWriter::sample(const Problem& problem, const State& state) const
{
    const NodalFields fields =
        fixed_points_.empty() ? NodalFields{} : nodal_fields_at(problem, state.particles, fixed_points_);
    std::vector<std::vector<PointSample>> samples;
    for (const Probe& probe : probes_) samples.push_back(sample(probe, problem, state, fields));
    return samples;
}

std::vector<PointSample> ProbeWriter::sample(const Probe& probe, const Problem& problem, const State& state,
                                             const NodalFields& fields) const
{
    const Particles& particles = state.particles;
    switch (probe.scene.kind) {
    case ProbeKind::material:
        return {sample_particle(problem, particles, index_of(particles, probe.identifier))};
    case ProbeKind::fixed:
        return {sample_point(problem, fields, *probe.scene.at)};
    case ProbeKind::surface: {
        const double x = probe.scene.at->x();
        const SurfacePoint surface = surface_point(problem, particles, x);
        if (!surface.found) return {PointSample()};
        PointSample sample =
            sample_surface(problem, particles, surface.particle, {x + surface.shift, surface.height});
        sample["position"] = {x, surface.height};
        return {sample};
    }
    case ProbeKind::profile:
        break;
    }
    std::vector<PointSample> samples;
    for (const Vector2& point : points_of(probe.scene))
        samples.push_back(sample_point(problem, fields, point));
    return samples;
}

void ProbeWriter::write(Probe& probe, double time, std::vector<PointSample> samples) const
{
    if (probe.previous_time >= time) return;
    if (probe.previous_velocities.size() == samples.size()) {
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const Vector2 change = samples[k].vector("velocity_solid") - probe.previous_velocities[k];
            const Vector2 acceleration = change / (time - probe.previous_time);
            samples[k]["acceleration"] = {acceleration.x(), acceleration.y()};
        }
    }
    probe.previous_time = time;
    probe.previous_velocities.clear();
    for (const PointSample& sample : samples) {
        probe.previous_velocities.push_back(sample.vector("velocity_solid"));
        std::vector<double> row{time};
        if (probe.scene.kind == ProbeKind::profile)
            row.push_back((sample.vector("position") - *probe.scene.at).norm());
        for (const Quantity* quantity : quantities_) {
            const QuantityValues& values = sample[quantity->name];
            row.insert(row.end(), values.begin(),
                       values.begin() + static_cast<std::ptrdiff_t>(component_count(quantity->form)));
        }
        probe.file.add_numbers(row);
    }
    probe.file.flush();
}

} // namespace quicksand
