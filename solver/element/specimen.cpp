#include "solver/element/specimen.hpp"

#include "solver/base/failure.hpp"

#include <Eigen/LU>
#include <cmath>
#include <sstream>
#include <variant>

namespace quicksand {

namespace {

using Eigen::Vector3d;

/// A square of unit area without stress.
Specimen make_specimen(const SkeletonLaw& law, double vertical_stress)
{
    Specimen specimen;
    specimen.law = undamped(law); // strains follow each other without time
    specimen.initial_vertical_stress = vertical_stress;
    Particles& point = specimen.point;
    point.identifier = {0};
    point.velocity_gradient_solid = {{0.0}, {0.0}, {0.0}, {0.0}};
    point.half_edge_1 = point.reference_edge_1 = {{0.5}, {0.0}};
    point.half_edge_2 = point.reference_edge_2 = {{0.0}, {0.5}};
    point.stress = {{0.0}, {0.0}, {0.0}, {0.0}};
    point.volume = point.mass_solid = {1.0};
    add_memory(point, memory_of(specimen.law).size());
    return specimen;
}

/// r <- r + L r for the edges, as a particle's domain deforms in a step.
void deform(Particles& point)
{
    const Gradients& L = point.velocity_gradient_solid;
    Eigen::Matrix2d step;
    step << 1.0 + L.xx[0], L.xy[0], L.yx[0], 1.0 + L.yy[0];
    point.half_edge_1.set(0, step * point.half_edge_1[0]);
    point.half_edge_2.set(0, step * point.half_edge_2[0]);
    point.volume[0] *= step.determinant();
}

Vector3d stress_in_plane(const Specimen& specimen)
{
    return {specimen.sigma_x(), specimen.sigma_y(), specimen.tau()};
}

/// Newton's method with differences to the stress in the plane; false where it does not get there.
bool strain_to(const Vector3d& wanted, double tolerance, Specimen& specimen)
{
    constexpr double difference = 1e-7; // of strain [-]
    for (int iteration = 0; iteration < 30; ++iteration) {
        const Vector3d stress = stress_in_plane(specimen);
        if (!stress.allFinite()) return false;
        if ((stress - wanted).norm() < tolerance) return true;
        Eigen::Matrix3d tangent;
        for (int k = 0; k < 3; ++k) {
            Specimen other = specimen;
            const Vector3d step = difference * Vector3d::Unit(k);
            strain(step.x(), step.y(), step.z(), other);
            tangent.col(k) = (stress_in_plane(other) - stress) / difference;
        }
        const Vector3d step = tangent.inverse() * (wanted - stress);
        strain(step.x(), step.y(), step.z(), specimen);
    }
    return false;
}

/// From the shape as drawn, which is free of stress.
void strain_from_drawn_shape(const Vector3d& wanted, Specimen& specimen)
{
    constexpr int parts = 20; // of the stress, so that Newton's method begins near its end [-]
    for (int part = 1; part <= parts; ++part) {
        if (strain_to(wanted * part / parts, 1e-10 * wanted.norm(), specimen)) continue;
        throw InputError("the specimen is too soft for these stresses: no strain leads to them");
    }
    specimen.gamma = specimen.strain_x = specimen.strain_y = 0.0;
}

/// At the stresses of the start, whether it bears them or not.
Specimen place_specimen(const SkeletonLaw& law, const Consolidation& start)
{
    const double horizontal = start.k0 * start.vertical_stress;
    Specimen specimen = make_specimen(law, start.vertical_stress);
    if (bears_stress_as_drawn(law)) {
        specimen.point.stress = {
            {-horizontal}, {-start.vertical_stress}, {-horizontal}, {-start.static_shear}};
    } else {
        strain_from_drawn_shape({horizontal, start.vertical_stress, start.static_shear}, specimen);
    }
    return specimen;
}

double mean_consolidation_stress(const Consolidation& start)
{
    return 0.5 * (1.0 + start.k0) * start.vertical_stress;
}

} // namespace

void require_above_floor(const SkeletonLaw& law, double mean_stress)
{
    const StressFloor floor = stress_floor_of(law);
    if (mean_stress >= floor.stress) return;
    std::ostringstream what;
    what << "a mean stress of " << mean_stress << " Pa is below the least of the model, " << floor.stress
         << " Pa (" << floor.key << ")";
    throw InputError(what.str());
}

Specimen consolidate(const SkeletonLaw& law, const Consolidation& start)
{
    if (!(start.vertical_stress > 0.0) || !(start.k0 > 0.0))
        throw InputError("element test: vertical_stress and k0 must be positive");
    require_above_floor(law, mean_consolidation_stress(start));
    Specimen specimen = place_specimen(law, start);
    const std::string objection = objection_to_stress(law, 0, specimen.point);
    if (!objection.empty()) throw InputError("the specimen fails in consolidation: " + objection);
    start_memory(law, 0, 1, specimen.point);
    return specimen;
}

bool can_consolidate(const SkeletonLaw& law, const Consolidation& start)
{
    try {
        consolidate(law, start);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

void strain(double strain_x, double strain_y, double shear, Specimen& specimen)
{
    Gradients& L = specimen.point.velocity_gradient_solid; // over a time of 1
    L.xx[0] = -strain_x, L.yy[0] = -strain_y, L.xy[0] = -shear;
    deform(specimen.point);
    std::visit([&](const auto& law) { update_stress(law, 1.0, 0, 1, specimen.point); }, specimen.law);
    specimen.strain_x += strain_x;
    specimen.strain_y += strain_y;
    specimen.gamma += shear;
}

double constrained_modulus(const Specimen& specimen)
{
    return std::visit([&](const auto& law) { return particle_moduli(law, 0, 1, specimen.point); },
                      specimen.law)
        .stiffest;
}

double shear_modulus(const Specimen& specimen)
{
    return shear_modulus_at(specimen.law, 0, specimen.point);
}

} // namespace quicksand
