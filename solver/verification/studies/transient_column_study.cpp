#include "solver/verification/studies/transient_column_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/transient_column.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {

namespace {

constexpr int compared_times = 20; // times at which the motion is compared

/// The load's history as a polygon that starts from zero at t = 0. Throws InputError for another one.
LoadPolygon read_polygon(const SurfaceLoad& load)
{
    const double q = load.pressure - load.traction.y();
    LoadPolygon polygon;
    if (const auto* table = std::get_if<SampledHistory>(&load.history.shape)) {
        for (std::size_t k = 0; k < table->times.size(); ++k) {
            polygon.times.push_back(table->times[k]);
            polygon.values.push_back(q * table->values[k]);
        }
    } else if (std::holds_alternative<ConstantHistory>(load.history.shape) && load.history.ramp_time > 0.0) {
        polygon.times = {0.0, load.history.ramp_time};
        polygon.values = {0.0, q};
    }
    if (polygon.times.size() < 2 || polygon.times.front() != 0.0 || polygon.values.front() != 0.0) {
        throw InputError("the verification needs a load on the top that starts from zero at t = 0: with "
                         "ramp_time, or with a history");
    }
    return polygon;
}

/// Squares of errors and the largest exact value.
struct Deviation {
    double squares = 0.0, weight = 0.0, largest = 0.0;

    void add(double measured, double exact, double fraction = 1.0)
    {
        squares += fraction * (measured - exact) * (measured - exact);
        weight += fraction;
        largest = std::max(largest, std::abs(exact));
    }
    double relative() const { return std::sqrt(squares / weight) / largest; }
};

double rise(const Particles& particles, std::size_t p)
{
    return particles.position.y[p] - particles.reference_position.y[p];
}

std::size_t lowest_particle(const Particles& particles)
{
    const Scalars& y = particles.reference_position.y;
    return static_cast<std::size_t>(std::min_element(y.begin(), y.end()) - y.begin());
}

/// Displacement and pressure of every particle at the present time against the closed form.
void compare_profile(const Layer& layer, const LoadPolygon& load, const State& state,
                     std::vector<StudyError>& errors)
{
    const Particles& particles = state.particles;
    std::map<double, ColumnMotion> exact; // by height
    Deviation displacement, pressure;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double x = particles.reference_position.y[p] - layer.base;
        if (!exact.contains(x)) {
            exact[x] = column_motion(layer.soil, layer.height(), load, x, {state.time}).front();
        }
        displacement.add(rise(particles, p), exact[x].displacement_solid, particles.volume[p]);
        pressure.add(particles.pore_pressure[p], exact[x].pore_pressure, particles.volume[p]);
    }
    errors.push_back({"displacement, profile", "L2 / largest", displacement.relative()});
    errors.push_back({"pressure, profile", "L2 / largest", pressure.relative()});
}

} // namespace

std::vector<StudyError> transient_column_study(const Problem& problem, State state)
{
    const Layer layer = read_layer(problem, state);
    const SurfaceLoad* load = surface_load(problem, layer.top);
    if (!load || load->pressure == load->traction.y()) {
        throw InputError("the verification needs a load on the top of the column");
    }
    const LoadPolygon polygon = read_polygon(*load);
    const double end = 2.0 * layer.height() / undragged_speeds(layer.soil).slow;
    std::vector<double> times;
    for (int k = 1; k <= compared_times; ++k) times.push_back(end * k / compared_times);

    const auto height_of = [&](std::size_t p) {
        return state.particles.reference_position.y[p] - layer.base;
    };
    const double top = height_of(highest_particle(state.particles));
    const double bottom = height_of(lowest_particle(state.particles));
    const auto exact_top = column_motion(layer.soil, layer.height(), polygon, top, times);
    const auto exact_bottom = column_motion(layer.soil, layer.height(), polygon, bottom, times);
    Deviation settlement, base_pressure;
    for (std::size_t k = 0; k < times.size(); ++k) {
        run(problem, times[k], {}, state);
        const Particles& particles = state.particles;
        settlement.add(rise(particles, highest_particle(particles)), exact_top[k].displacement_solid);
        base_pressure.add(particles.pore_pressure[lowest_particle(particles)], exact_bottom[k].pore_pressure);
    }
    std::vector<StudyError> errors = {{"settlement, history", "L2 / largest", settlement.relative()},
                                      {"base pressure, history", "L2 / largest", base_pressure.relative()}};
    compare_profile(layer, polygon, state, errors);
    return errors;
}

} // namespace quicksand
