#include "solver/verification/studies/terzaghi_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/inertial_consolidation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/terzaghi.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace quicksand {

namespace {

/// The loaded surface that drains the layer, and how deep the layer is below it, in any direction.
struct DrainedFace {
    Vector2 place = Vector2::Zero();   // a point of it [m]
    Vector2 outward = Vector2::Zero(); // [-]
    double load = 0.0;                 // normal to it [Pa]

    double depth(const Vector2& point) const { return (place - point).dot(outward); } // [m]
};

/// The straight curve that is free and drained; of several the one with a load.
DrainedFace read_face(const Problem& problem)
{
    const Boundary* top = nullptr;
    for (const Boundary& boundary : problem.boundaries) {
        const bool open = std::holds_alternative<FreeFace>(boundary.soil) &&
                          std::holds_alternative<Drained>(boundary.water);
        if (open && !boundary.segments.empty() && (top == nullptr || load_of(boundary.soil) != nullptr))
            top = &boundary;
    }
    if (top == nullptr) throw InputError("the verification needs a column with a free and drained top");
    DrainedFace face{top->segments.front().start, outward_normal(top->segments.front()), 0.0};
    if (const SurfaceLoad* load = load_of(top->soil)) face.load = steady_load(*load, face.outward);
    return face;
}

/// The layer and the load that consolidate it.
struct Consolidation {
    SaturatedSoil soil;
    DrainedFace face;
    double height = 0.0;           // H, across the layer [m]
    double initial_pressure = 0.0; // p_0 [Pa]

    double duration(double time_factor) const // t of a time factor [s]
    {
        return time_factor * height * height / soil.consolidation_coefficient();
    }
    double depth_ratio(const Vector2& point) const { return face.depth(point) / height; }
    double final_settlement() const { return initial_pressure * height / soil.constrained_modulus; } // [m]
};

Consolidation read_consolidation(const Problem& problem, const State& state)
{
    Consolidation consolidation;
    consolidation.soil = read_layer(problem, state).soil;
    consolidation.face = read_face(problem);
    for (const Boundary& boundary : problem.boundaries) {
        for (const Segment& segment : boundary.segments)
            consolidation.height = std::max(consolidation.height, consolidation.face.depth(segment.start));
    }
    consolidation.initial_pressure = state.particles.pore_pressure.front();
    if (!(consolidation.initial_pressure > 0.0)) {
        throw InputError("the verification needs initial.excess_pore_pressure");
    }
    return consolidation;
}

std::vector<StudyError> measure_errors(const Problem& problem, const Consolidation& consolidation,
                                       State state)
{
    constexpr std::array<std::pair<double, const char*>, 4> time_factors = {
        {{0.02, "0.02"}, {0.1, "0.1"}, {0.5, "0.5"}, {1.0, "1"}}};
    const double p0 = consolidation.initial_pressure;
    const Particles& particles = state.particles;
    const auto depth = [&](std::size_t p) {
        return consolidation.depth_ratio(particles.reference_position[p]);
    };
    std::size_t top = 0; // the particle nearest to the drained face
    for (std::size_t p = 1; p < particles.size(); ++p)
        if (depth(p) < depth(top)) top = p;
    std::vector<StudyError> pressures, with_inertia, settlements;
    for (const auto& [T, text] : time_factors) {
        run(problem, consolidation.duration(T), {}, state);
        const InertialConsolidation inertial(consolidation.soil, consolidation.height, state.time);
        const double pressure = root_mean_square(particles, [&, T = T](std::size_t p) {
            return particles.pore_pressure[p] / p0 - terzaghi_pressure_ratio(depth(p), T);
        });
        const double inertial_pressure = root_mean_square(particles, [&](std::size_t p) {
            return particles.pore_pressure[p] / p0 - inertial.pressure_ratio(depth(p));
        });
        const double sunk = consolidation.face.depth(particles.position[top]) -
                            consolidation.face.depth(particles.reference_position[top]);
        const double exact = terzaghi_settlement_degree(depth(top), T);
        const std::string at = std::string(" at T = ") + text;
        pressures.push_back({"pressure" + at, "L2 / load", pressure});
        with_inertia.push_back({"pressure with inertia" + at, "L2 / load", inertial_pressure});
        settlements.push_back({"settlement" + at, "surface / final",
                               std::abs(sunk / consolidation.final_settlement() - exact)});
    }
    pressures.insert(pressures.end(), with_inertia.begin(), with_inertia.end());
    pressures.insert(pressures.end(), settlements.begin(), settlements.end());
    return pressures;
}

} // namespace

std::vector<StudyError> terzaghi_study(const Problem& problem, State state)
{
    const Consolidation consolidation = read_consolidation(problem, state);
    // the grains bear along the column what the load has beyond the pressure
    const double borne = consolidation.initial_pressure - consolidation.face.load;
    const Vector2& n = consolidation.face.outward;
    SymmetricTensors& stress = state.particles.stress;
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
        stress.xx[p] = borne * n.x() * n.x();
        stress.yy[p] = borne * n.y() * n.y();
        stress.xy[p] = borne * n.x() * n.y();
    }
    return measure_errors(problem, consolidation, std::move(state));
}

} // namespace quicksand
