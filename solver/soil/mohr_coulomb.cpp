#include "solver/soil/mohr_coulomb.hpp"

#include "solver/soil/linear_elastic.hpp"
#include "solver/soil/mohr_coulomb_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

using Eigen::Vector3d;

LinearElastic elastic_part(const MohrCoulomb& law)
{
    return {law.shear_modulus, law.poisson_ratio};
}

/// The stress of a particle in parts.
StressParts parts_of(const SymmetricTensors& stress, std::size_t p)
{
    return {0.5 * (stress.xx[p] + stress.yy[p]), 0.5 * (stress.xx[p] - stress.yy[p]), stress.xy[p],
            stress.zz[p]};
}

/// Replace the trial stress of a particle, outside the surface, by the stress to which it returns.
void return_particle(const MohrCoulombSurface& surface, std::size_t p, SymmetricTensors& stress)
{
    const double centre = 0.5 * (stress.xx[p] + stress.yy[p]);
    const double half = 0.5 * (stress.xx[p] - stress.yy[p]), shear = stress.xy[p];
    const double radius = std::sqrt(half * half + shear * shear);
    const double upper = centre + radius, lower = centre - radius, out_of_plane = stress.zz[p];
    // place of the out-of-plane stress among the three
    const int place = out_of_plane >= upper ? 0 : out_of_plane >= lower ? 1 : 2;
    const int first = place == 0 ? 1 : 0, second = place == 2 ? 1 : 2;
    Vector3d trial;
    trial[place] = out_of_plane;
    trial[first] = upper;
    trial[second] = lower;
    const Vector3d returned = surface.return_from(trial);
    const double new_centre = 0.5 * (returned[first] + returned[second]);
    const double shrink = radius > 0.0 ? 0.5 * (returned[first] - returned[second]) / radius : 0.0;
    stress.xx[p] = new_centre + shrink * half;
    stress.yy[p] = new_centre - shrink * half;
    stress.xy[p] = shrink * shear;
    stress.zz[p] = returned[place];
}

} // namespace

ParticleModuli particle_moduli(const MohrCoulomb& law, std::size_t, std::size_t, const Particles&)
{
    const double M = constrained_modulus(law) * unrelaxed_stiffness(law);
    return {M, M};
}

void update_stress(const MohrCoulomb& law, double dt, std::size_t first, std::size_t last,
                   Particles& particles)
{
    constexpr std::size_t block = 64; // particles checked at a time [-]
    const std::optional<MaxwellStep> damping = maxwell_step_of(law, dt);
    add_elastic_stress(elastic_part(law), damping, dt, first, last, particles);
    const MohrCoulombSurface surface(law);
    SymmetricTensors& stress = particles.stress;
    std::array<double, block> excess;
    for (; first < last; first += std::min(block, last - first)) {
        const std::size_t count = std::min(block, last - first);
        double largest_excess = -1.0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t p = first + k;
            const double centre = 0.5 * (stress.xx[p] + stress.yy[p]);
            const double half = 0.5 * (stress.xx[p] - stress.yy[p]);
            const double radius = std::sqrt(half * half + stress.xy[p] * stress.xy[p]);
            excess[k] = surface.excess(std::max(centre + radius, stress.zz[p]),
                                       std::min(centre - radius, stress.zz[p]));
            largest_excess = std::max(largest_excess, excess[k]);
        }
        if (largest_excess <= 0.0) continue;
        for (std::size_t k = 0; k < count; ++k) {
            if (excess[k] <= 0.0) continue;
            const StressParts trial = parts_of(stress, first + k);
            return_particle(surface, first + k, stress);
            if (damping)
                share_plastic_change(*damping, parts_of(stress, first + k) - trial, first + k,
                                     particles.memory);
        }
    }
}

std::string objection_to_stress(const MohrCoulomb& law, std::size_t p, const Particles& particles)
{
    const SymmetricTensors& stress = particles.stress;
    const double centre = 0.5 * (stress.xx[p] + stress.yy[p]);
    const double radius = std::hypot(0.5 * (stress.xx[p] - stress.yy[p]), stress.xy[p]);
    const double tension = std::max(centre + radius, stress.zz[p]);
    const double compression = -std::min(centre - radius, stress.zz[p]);
    if (MohrCoulombSurface(law).excess(tension, -compression) <= 1e-9 * std::abs(compression)) return "";
    const double sine = std::sin(law.friction_angle), cosine = std::cos(law.friction_angle);
    const double borne = (2.0 * law.cohesion * cosine - (1.0 + sine) * tension) / (1.0 - sine);
    std::ostringstream what;
    if (tension > std::min(law.tension_strength, surface_tip(law))) {
        what << "its tension of " << tension << " Pa is more than the soil bears";
    } else {
        what << "its largest principal stress is " << compression << " Pa, and beside the least of "
             << -tension << " Pa the soil bears " << borne << " Pa";
    }
    return what.str();
}

std::optional<FailureLine> failure_line_of(const MohrCoulomb& law)
{
    return FailureLine{std::sin(law.friction_angle), law.cohesion * std::cos(law.friction_angle)};
}

} // namespace quicksand
