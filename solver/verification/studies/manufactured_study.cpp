#include "solver/verification/studies/manufactured_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/verification/bodies/manufactured_run.hpp"
#include "solver/verification/bodies/solid_body.hpp"

#include <cmath>
#include <limits>

namespace quicksand {

namespace {

struct Member {
    const char* name;
    Interpolation interpolation;
};

constexpr Member family[] = {{"linear MPM", Interpolation::linear},
                             {"GIMP", Interpolation::gimp},
                             {"cpGIMP", Interpolation::cpgimp},
                             {"CPDI", Interpolation::cpdi},
                             {"CPDI2", Interpolation::cpdi2}};

ManufacturedBody body_of(const Problem& problem, const State& state)
{
    const SolidBody solid = read_neo_hookean_body(problem, state);
    ManufacturedBody body;
    body.youngs_modulus = 2.0 * solid.law.shear_modulus * (1.0 + solid.law.poisson_ratio);
    body.poisson_ratio = solid.law.poisson_ratio;
    body.density = solid.density;
    return body;
}

double period(const ManufacturedBody& body)
{
    return 2.0 / body.wave_speed(); // of sin(c pi t), lengths in metres
}

VortexMotion vortex(double amplitude, const SolidBody& solid)
{
    const Vector2 size = solid.upper - solid.lower;
    if (size.minCoeff() < 2.5) {
        throw InputError("the vortex needs a body of at least 2.5 m by 2.5 m");
    }
    return {amplitude, 0.5 * (solid.lower + solid.upper)};
}

/// Infinite where the run fails: that of one interpolation is no failure of the others.
double error_of(const ManufacturedMotion& motion, Interpolation interpolation, double end_time,
                const Problem& problem, const State& state)
{
    ManufacturedRun run{motion, interpolation};
    run.end_time = end_time;
    try {
        return run_manufactured(run, body_of(problem, state), problem, state).displacement_error;
    } catch (const NumericalError&) {
        return std::numeric_limits<double>::infinity();
    }
}

std::vector<StudyError> errors_of_family(const ManufacturedMotion& motion, const Problem& problem,
                                         const State& state)
{
    const double end_time = period(body_of(problem, state));
    std::vector<StudyError> errors;
    for (const Member& member : family) {
        errors.push_back({std::string(member.name) + ", displacement", "L2, max in time / amplitude",
                          error_of(motion, member.interpolation, end_time, problem, state)});
    }
    return errors;
}

} // namespace

std::vector<StudyError> axis_aligned_study(const Problem& problem, State state,
                                           const StudyParameters& parameters)
{
    const SolidBody solid = read_neo_hookean_body(problem, state);
    if (solid.lower.norm() > 1e-6 || (solid.upper - Vector2::Ones()).norm() > 1e-6) {
        throw InputError(
            "the axis-aligned motion needs a square of 1 m whose lower left corner is the origin");
    }
    return errors_of_family(AxisAlignedMotion{parameters.amplitude.value_or(0.05)}, problem, state);
}

std::vector<StudyError> vortex_study(const Problem& problem, State state, const StudyParameters& parameters)
{
    return errors_of_family(vortex(parameters.amplitude.value_or(0.1), read_neo_hookean_body(problem, state)),
                            problem, state);
}

std::vector<StudyError> largest_vortex_study(const Problem& problem, State state,
                                             const StudyParameters& parameters)
{
    const VortexMotion motion =
        vortex(parameters.amplitude.value_or(1.0), read_neo_hookean_body(problem, state));
    const double whole = period(body_of(problem, state));
    const auto error = [&](const char* quantity, Interpolation interpolation, double end_time) {
        return StudyError{quantity, "L2, max in time / amplitude",
                          error_of(motion, interpolation, end_time, problem, state)};
    };
    return {error("CPDI, to the largest shear", Interpolation::cpdi, 0.25 * whole),
            error("CPDI, over a period", Interpolation::cpdi, whole),
            error("CPDI2, to the largest shear", Interpolation::cpdi2, 0.25 * whole)};
}

} // namespace quicksand
