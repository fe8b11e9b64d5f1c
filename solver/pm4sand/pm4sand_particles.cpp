#include "solver/pm4sand/pm4sand_particles.hpp"

#include "solver/base/failure.hpp"
#include "solver/pm4sand/pm4sand_arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

constexpr bool shown = true;

constexpr std::array<MemoryNumber, 24> memory = {{
    {"alpha_x", "-", "back-stress ratio, (a_xx - a_yy)/2", Component::x, shown},
    {"alpha_y", "-", "the same, a_xy", Component::y, shown},
    {"alpha_in_x", "-", "back-stress ratio where loading began, apparent, (a_xx - a_yy)/2", Component::x,
     shown},
    {"alpha_in_y", "-", "the same, a_xy", Component::y, shown},
    {"alpha_turn_x", "-", "back-stress ratio where loading began in truth, (a_xx - a_yy)/2", Component::x},
    {"alpha_turn_y", "-", "the same, a_xy", Component::y},
    {"alpha_before_x", "-", "alpha_in of the loading before, (a_xx - a_yy)/2", Component::x},
    {"alpha_before_y", "-", "the same, a_xy", Component::y},
    {"alpha_least_x", "-", "least back-stress ratio of the positive reversals, (a_xx - a_yy)/2",
     Component::x},
    {"alpha_least_y", "-", "the same, a_xy", Component::y},
    {"alpha_most_x", "-", "largest back-stress ratio of the negative reversals, (a_xx - a_yy)/2",
     Component::x},
    {"alpha_most_y", "-", "the same, a_xy", Component::y},
    {"fabric_x", "-", "fabric-dilatancy tensor z, (z_xx - z_yy)/2", Component::x, shown},
    {"fabric_y", "-", "the same, z_xy", Component::y, shown},
    {"fabric_in_x", "-", "z at the last reversal, (z_xx - z_yy)/2", Component::x},
    {"fabric_in_y", "-", "the same, z_xy", Component::y},
    {"fabric_path", "-", "z_cum, length of the path of the fabric", Component::scalar, shown},
    {"fabric_peak", "-", "z_peak, largest size of the fabric so far", Component::scalar, shown},
    {"peak_stress", "Pa", "p_zp, mean stress at the reversal with the largest product of p and fabric",
     Component::scalar, shown},
    {"peak_product", "Pa", "that product"},
    {"void_ratio", "-", "void ratio of the sand", Component::scalar, shown},
    {"fabric_limit", "-", "z_max at consolidation"},
    {"dilatancy_factor", "-", "A_d0 at consolidation"},
    {"least_stress", "Pa", "p_min at consolidation"},
}};

/// G at a mean stress p, without fabric and shear [Pa].
double largest_shear_modulus(const Pm4Sand& law, double p)
{
    return law.shear_coefficient * std::sqrt(atmospheric_pressure * p);
}

double constrained_over_shear(const Pm4Sand& law)
{
    return law.bulk_over_shear + 4.0 / 3.0;
}

double mean_stress(const SymmetricTensors& stress, std::size_t p)
{
    return std::max(-0.5 * (stress.xx[p] + stress.yy[p]), atmospheric_pressure / 200.0);
}

/// q/p of a particle.
double stress_ratio(const SymmetricTensors& stress, std::size_t p)
{
    const double q = 2.0 * std::hypot(0.5 * (stress.xx[p] - stress.yy[p]), stress.xy[p]);
    return q / std::max(-0.5 * (stress.xx[p] + stress.yy[p]), 1e-9);
}

} // namespace

LawMemory memory_of(const Pm4Sand&)
{
    return memory;
}

double shear_modulus(const Pm4Sand& law)
{
    return largest_shear_modulus(law, atmospheric_pressure);
}

double constrained_modulus(const Pm4Sand& law)
{
    return shear_modulus(law) * constrained_over_shear(law);
}

double shear_modulus_at(const Pm4Sand& law, std::size_t p, const Particles& particles)
{
    const bool has_begun = particles.memory.size() >= memory.size(); // before that sand has no fabric
    return has_begun ? shear_modulus(law, state_of(p, particles))
                     : largest_shear_modulus(law, mean_stress(particles.stress, p));
}

ParticleModuli particle_moduli(const Pm4Sand& law, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return collect_moduli(first, last, particles.volume.data(), [&](std::size_t p) {
        return largest_shear_modulus(law, mean_stress(particles.stress, p)) * constrained_over_shear(law);
    });
}

ParticleModuli expected_moduli(const Pm4Sand& law, double dt, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    const Gradients& L = particles.affine_velocity_solid;
    constexpr double dilation = 0.3; // of a shear strain at most, of the densest sand [-]
    const double K_over_G = law.bulk_over_shear + 1.0 / 3.0;
    return collect_moduli(first, last, particles.volume.data(), [&](std::size_t p) {
        const double s = mean_stress(particles.stress, p), G = largest_shear_modulus(law, s);
        const double x = L.xx[p] - L.yy[p], xy = L.xy[p] + L.yx[p];
        const double strain =
            std::max(0.0, -dt * (L.xx[p] + L.yy[p])) + dt * dilation * std::sqrt(x * x + xy * xy);
        return constrained_over_shear(law) * G * (1.0 + 0.5 * K_over_G * G / s * strain);
    });
}

void update_stress(const Pm4Sand& law, double dt, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory.size());
    update(law, dt, first, last, particles);
}

std::size_t start_memory(const Pm4Sand& law, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory.size());
    std::size_t changed = 0;
    for (std::size_t p = first; p < last; ++p) {
        Pm4SandState state = state_of(p, particles);
        changed += begin_shaking(law, state) ? 1U : 0U;
        set_state(p, state, particles);
    }
    return changed;
}

std::size_t count_at_failure(const Pm4Sand& law, std::size_t first, std::size_t last,
                             const Particles& particles)
{
    constexpr double rounding = 1e-3; // settling ends a little below the limit
    std::size_t count = 0;
    for (std::size_t p = first; p < last; ++p) {
        const double most = largest_ratio(law, mean_stress(particles.stress, p), initial_void_ratio(law));
        count += stress_ratio(particles.stress, p) >= (1.0 - rounding) * most ? 1U : 0U;
    }
    return count;
}

std::string objection_to_stress(const Pm4Sand& law, std::size_t p, const Particles& particles)
{
    const double ratio = stress_ratio(particles.stress, p);
    const double most = largest_ratio(law, mean_stress(particles.stress, p), initial_void_ratio(law));
    if (ratio <= most) return "";
    std::ostringstream what;
    what.precision(3);
    what << "its stress ratio q/p = " << ratio << " is outside the bounding surface M^b = " << most;
    return what.str();
}

SettlingSand settling_form(const Pm4Sand& law, double cell_weight)
{
    UbcSand sand{};
    sand.G_atm = shear_modulus(law);
    sand.ne = 0.5;
    sand.eta_f = 0.5 * largest_ratio(law, atmospheric_pressure, initial_void_ratio(law));
    sand.s_min = atmospheric_pressure / 1000.0; // the floor of the law
    sand.static_poisson = law.static_poisson_ratio;
    return {sand, cell_weight};
}

} // namespace quicksand
