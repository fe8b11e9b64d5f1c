#include "solver/verification/studies/griffiths_lane_study.hpp"

#include "solver/base/failure.hpp"
#include "solver/run/strength_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace quicksand {

namespace {

/// The one straight free face that is neither level nor upright.
Segment find_face(const Problem& problem)
{
    const double least = 1e-6 * problem.grid.cell_size;
    std::optional<Segment> face;
    for (const Boundary& boundary : problem.boundaries) {
        if (!std::holds_alternative<FreeFace>(boundary.soil)) continue;
        for (const Segment& segment : boundary.segments) {
            const Vector2 along = segment.end - segment.start;
            if (std::abs(along.x()) < least || std::abs(along.y()) < least) continue;
            if (face) throw InputError("the slope has more than one inclined free face");
            face = segment;
        }
    }
    if (!face) throw InputError("the slope has no inclined free face among the named boundaries");
    return *face;
}

double find_base(const Problem& problem)
{
    for (const Boundary& boundary : problem.boundaries) {
        if (std::holds_alternative<FixedWall>(boundary.soil) && !boundary.segments.empty())
            return std::min(boundary.segments.front().start.y(), boundary.segments.front().end.y());
    }
    throw InputError("the slope has no fixed base among the named boundaries");
}

} // namespace

HomogeneousSlope slope_of(const Problem& problem)
{
    const Material& material = problem.materials.front();
    const auto* law = std::get_if<MohrCoulomb>(&material.law);
    if (law == nullptr || problem.materials.size() > 1 || problem.water)
        throw InputError("the slope is not one dry soil with model = \"mohr_coulomb\"");
    const Segment face = find_face(problem);
    const Vector2 along = (face.end - face.start).cwiseAbs();
    const double toe = std::min(face.start.y(), face.end.y());
    HomogeneousSlope slope;
    slope.height = along.y();
    slope.run = along.x() / along.y();
    slope.friction_angle = law->friction_angle;
    slope.cohesion = law->cohesion;
    slope.unit_weight = (1.0 - material.porosity) * material.grain_density * problem.gravity;
    slope.depth_factor = (toe + slope.height - find_base(problem)) / slope.height;
    return slope;
}

std::vector<StudyError> griffiths_lane_study(const Problem& problem, State state)
{
    const double reference = critical_circle(slope_of(problem)).factor_of_safety;
    const SafetyFactor safety = safety_factor(problem, {}, state);
    return {{"factor of safety", "difference / Bishop's", std::abs(safety.factor / reference - 1.0)}};
}

} // namespace quicksand
