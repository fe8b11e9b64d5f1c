#include "solver/soil/mohr_coulomb_surface.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using Eigen::Vector3d;

Vector3d shear_plane(double sine, int i, int j)
{
    return (1.0 + sine) * Vector3d::Unit(i) - (1.0 - sine) * Vector3d::Unit(j);
}

} // namespace

MohrCoulombSurface::MohrCoulombSurface(const MohrCoulomb& law)
    : sin_phi_(std::sin(law.friction_angle)), shear_limit_(2.0 * law.cohesion * std::cos(law.friction_angle)),
      tension_limit_(std::min(law.tension_strength, surface_tip(law))), lambda_(lame_modulus(law)),
      shear_modulus_(law.shear_modulus)
{
    const double sin_psi = std::sin(law.dilation_angle);
    flow_ratio_ = (1.0 + sin_psi) / (1.0 - sin_psi);
    const auto flows = [&](double sine) {
        return std::array<Vector3d, plane_count>{shear_plane(sine, 0, 2), shear_plane(sine, 0, 1),
                                                 shear_plane(sine, 1, 2), Vector3d::UnitX(),
                                                 Vector3d::UnitY(),       Vector3d::UnitZ()};
    };
    normal_ = flows(sin_phi_);
    stiff_flow_ = flows(sin_psi);
    for (Vector3d& flow : stiff_flow_)
        flow = (Vector3d::Constant(lambda_ * flow.sum()) + 2.0 * shear_modulus_ * flow).eval();
}

double MohrCoulombSurface::value(Plane plane, const Vector3d& stress) const
{
    return normal_[plane].dot(stress) - (plane < tension_1 ? shear_limit_ : tension_limit_);
}

double MohrCoulombSurface::violation(const Vector3d& stress) const
{
    double largest = value(shear_13, stress);
    for (int plane = shear_12; plane < plane_count; ++plane)
        largest = std::max(largest, value(static_cast<Plane>(plane), stress));
    return largest;
}

/// Put a stress that is on the planes but for rounding of the trial onto them to its own rounding.
void MohrCoulombSurface::snap(std::span<const Plane> planes, Vector3d& stress) const
{
    const auto holds = [&](Plane plane) {
        return std::find(planes.begin(), planes.end(), plane) != planes.end();
    };
    if (holds(shear_12)) stress[1] = stress[2];
    if (holds(tension_1)) stress[0] = tension_limit_;
    if (holds(tension_2)) stress[1] = tension_limit_;
    if (holds(shear_13) && holds(tension_1)) {
        stress[2] = ((1.0 + sin_phi_) * stress[0] - shear_limit_) / (1.0 - sin_phi_);
    } else if (holds(shear_13)) {
        stress[0] = ((1.0 - sin_phi_) * stress[2] + shear_limit_) / (1.0 + sin_phi_);
    }
    if (holds(shear_23)) stress[1] = stress[0];
}

MohrCoulombSurface::Candidate MohrCoulombSurface::onto(Plane plane, const Vector3d& trial) const
{
    const double multiplier = value(plane, trial) / normal_[plane].dot(stiff_flow_[plane]);
    Candidate candidate{trial - multiplier * stiff_flow_[plane], 0.0};
    snap(std::array{plane}, candidate.stress);
    candidate.failure = std::max(-shear_modulus_ * multiplier, violation(candidate.stress));
    return candidate;
}

MohrCoulombSurface::Candidate MohrCoulombSurface::onto(Plane one, Plane other, const Vector3d& trial) const
{
    const double a = normal_[one].dot(stiff_flow_[one]), b = normal_[one].dot(stiff_flow_[other]);
    const double c = normal_[other].dot(stiff_flow_[one]), d = normal_[other].dot(stiff_flow_[other]);
    const double f = value(one, trial), g = value(other, trial), determinant = a * d - b * c;
    const double first = (d * f - b * g) / determinant, second = (a * g - c * f) / determinant;
    Candidate candidate{trial - first * stiff_flow_[one] - second * stiff_flow_[other], 0.0};
    snap(std::array{one, other}, candidate.stress);
    candidate.failure = std::max(-shear_modulus_ * std::min(first, second), violation(candidate.stress));
    return candidate;
}

/// The corner with `tensions` principal stresses at the tension limit and the others on the shear planes. It
/// is the answer when the plastic strain p = D^-1 (trial - corner) is a sum of its planes' directions.
MohrCoulombSurface::Candidate MohrCoulombSurface::onto_vertex(int tensions, const Vector3d& trial) const
{
    const double sheared = ((1.0 + sin_phi_) * tension_limit_ - shear_limit_) / (1.0 - sin_phi_);
    Vector3d corner = Vector3d::Constant(tension_limit_);
    for (int i = tensions; i < 3; ++i) corner[i] = sheared;
    const Vector3d apart = trial - corner;
    const double mean_part = lambda_ * apart.sum() / (3.0 * lambda_ + 2.0 * shear_modulus_);
    const Vector3d p = 0.5 * (apart - Vector3d::Constant(mean_part)); // times G
    double failure = 0.0, shortening = 0.0, extension = 0.0;
    for (int i = 0; i < 3; ++i) {
        failure = std::max(failure, i < tensions ? -p[i] : p[i]);
        (i < tensions ? extension : shortening) += p[i];
    }
    return {corner, std::max(failure, -flow_ratio_ * shortening - extension)};
}

Vector3d MohrCoulombSurface::return_from(const Vector3d& trial) const
{
    Candidate best = onto(shear_13, trial);
    const auto consider = [&](const Candidate& candidate) {
        if (candidate.failure < best.failure) best = candidate;
    };
    // rounding may leave every candidate with a failure of its size: then the least is taken
    if (best.failure > 0.0) consider(onto(shear_13, shear_12, trial));
    if (best.failure > 0.0) consider(onto(shear_13, shear_23, trial));
    if (best.failure <= 0.0 || std::isinf(tension_limit_)) return best.stress;
    consider(onto(tension_1, trial));
    if (best.failure > 0.0) consider(onto(shear_13, tension_1, trial));
    if (best.failure > 0.0) consider(onto(tension_1, tension_2, trial));
    for (int tensions = 1; tensions <= 3 && best.failure > 0.0; ++tensions)
        consider(onto_vertex(tensions, trial));
    return best.stress;
}

} // namespace quicksand
