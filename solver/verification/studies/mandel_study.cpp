#include "solver/verification/studies/mandel_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/layer.hpp"
#include "solver/verification/solutions/mandel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace quicksand {

namespace {

constexpr double last_time_factor = 1.0;

/// The quarter of the slab that the scene holds.
struct Quarter {
    MandelSlab slab;
    double middle = 0.0; // x of the middle plane [m]
    double base = 0.0;   // y of the other one [m]
    double height = 0.0; // from there to the plate [m]

    double duration(double time_factor) const // t of a time factor [s]
    {
        return time_factor * slab.half_width * slab.half_width / slab.soil.consolidation_coefficient();
    }
};

Quarter read_quarter(const Problem& problem, const State& state)
{
    const Particles& particles = state.particles;
    const Layer layer = read_layer(problem, state);
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double half = std::abs(particles.half_edge_1.x[p]) + std::abs(particles.half_edge_2.x[p]);
        left = std::min(left, particles.position.x[p] - half);
        right = std::max(right, particles.position.x[p] + half);
    }
    const double pressure = particles.pore_pressure.front();
    if (!(pressure > 0.0)) throw InputError("the verification needs initial.excess_pore_pressure");
    Quarter quarter;
    quarter.slab.soil = layer.soil;
    quarter.slab.half_width = right - left;
    quarter.slab.force = pressure / quarter.slab.initial_pressure(); // per force of 1 N/m
    quarter.middle = left;
    quarter.base = layer.base;
    quarter.height = layer.height();
    return quarter;
}

/// The plate's way since the load was put on, positive onto the soil [m].
double plate_displacement(const Quarter& quarter, double T)
{
    const MandelSlab& slab = quarter.slab;
    const double at_once = slab.force * (1.0 - slab.undrained_poisson_ratio()) * quarter.height /
                           (2.0 * slab.soil.shear_modulus * slab.half_width);
    return T > 0.0 ? -MandelState(slab, T).displacement_y(quarter.height) - at_once : 0.0;
}

/// Times grow as squares: the plate starts as the square root of time.
History plate_history(const Quarter& quarter)
{
    constexpr int samples = 1000;
    SampledHistory history;
    for (int k = 0; k <= samples; ++k) {
        const double T = last_time_factor * k * k / (static_cast<double>(samples) * samples);
        history.times.push_back(quarter.duration(T));
        history.values.push_back(plate_displacement(quarter, T));
    }
    return {history};
}

void move_plate(const Quarter& quarter, Problem& problem)
{
    for (Boundary& boundary : problem.boundaries) {
        auto* plate = std::get_if<MovingWall>(&boundary.soil);
        if (plate == nullptr || plate->motion.quantity != MotionQuantity::displacement ||
            plate->motion.grip != WallGrip::smooth)
            continue;
        plate->motion.inward = 1.0;
        plate->motion.history = plate_history(quarter);
        return;
    }
    throw InputError("the verification needs a plate on top: soil = \"moving\" with a normal_displacement");
}

/// The stresses of the slab just after the load, when no water has left yet.
void load_undrained(const Quarter& quarter, Particles& particles)
{
    const double nu = quarter.slab.poisson_ratio();
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double pressure = particles.pore_pressure[p];
        particles.stress.xx[p] = pressure;
        particles.stress.yy[p] = pressure - quarter.slab.force / quarter.slab.half_width;
        particles.stress.zz[p] = nu * (particles.stress.xx[p] + particles.stress.yy[p]);
    }
}

/// Mean total stress over the slab times its width: what the plate carries [N/m].
double force_on_plate(const Quarter& quarter, const Particles& particles)
{
    double force = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p)
        force += particles.volume[p] * (particles.pore_pressure[p] - particles.stress.yy[p]);
    return force / quarter.height;
}

/// Error of the pressure along the slab, over the initial one [-].
double profile_error(const Quarter& quarter, double T, const Particles& particles)
{
    const MandelState exact(quarter.slab, T);
    return root_mean_square(particles,
                            [&](std::size_t p) {
                                const double x = particles.reference_position.x[p] - quarter.middle;
                                return particles.pore_pressure[p] - exact.pore_pressure(x);
                            }) /
           quarter.slab.initial_pressure();
}

/// The pressure beside the middle plane, and the exact one there [Pa].
struct Middle {
    double measured = 0.0, exact = 0.0;
};

Middle pressure_in_the_middle(const Quarter& quarter, double T, const Particles& particles)
{
    const Scalars& x = particles.reference_position.x;
    const auto p = static_cast<std::size_t>(std::min_element(x.begin(), x.end()) - x.begin());
    return {particles.pore_pressure[p], MandelState(quarter.slab, T).pore_pressure(x[p] - quarter.middle)};
}

} // namespace

std::vector<StudyError> mandel_study(const Problem& given, State state)
{
    const Quarter quarter = read_quarter(given, state);
    Problem problem = given;
    move_plate(quarter, problem);
    load_undrained(quarter, state.particles);

    constexpr std::array<std::pair<double, const char*>, 3> profiles = {
        {{0.05, "0.05"}, {0.1, "0.1"}, {0.5, "0.5"}}};
    constexpr double interval = 0.01; // of T
    std::vector<StudyError> errors;
    Middle peak;
    double apart = 0.0, force_error = 0.0;
    for (int k = 2; k * interval <= last_time_factor * (1.0 + 1e-9); ++k) {
        const double T = k * interval;
        run(problem, quarter.duration(T), {}, state);
        const Middle middle = pressure_in_the_middle(quarter, T, state.particles);
        peak.measured = std::max(peak.measured, middle.measured);
        peak.exact = std::max(peak.exact, middle.exact);
        apart = std::max(apart, std::abs(middle.measured - middle.exact));
        force_error = std::max(force_error,
                               std::abs(force_on_plate(quarter, state.particles) / quarter.slab.force - 1.0));
        for (const auto& [time_factor, text] : profiles) {
            if (std::abs(T - time_factor) > 1e-9) continue;
            errors.push_back({std::string("pressure at T = ") + text, "L2 / initial",
                              profile_error(quarter, T, state.particles)});
        }
    }
    errors.insert(errors.begin(),
                  {{"peak in the middle", "relative", std::abs(peak.measured / peak.exact - 1.0)},
                   {"pressure in the middle", "largest / peak", apart / peak.exact}});
    errors.push_back({"force on the plate", "largest, relative", force_error});
    return errors;
}

} // namespace quicksand
