#include "solver/pm4sand/pm4sand_particles.hpp"

#include "solver/base/failure.hpp"
#include "solver/pm4sand/pm4sand_arrays.hpp"
#include "solver/reconsolidation/cell_reconsolidation.hpp"
#include "solver/reconsolidation/liquefied_conductivity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace quicksand {

namespace {

constexpr bool shown = true;
constexpr std::size_t void_ratio = 20; // its column [-]

constexpr std::array<MemoryNumber, numbers_of_cycles + history_numbers> memory = {{
    {"alpha_x", "-", "back-stress ratio, (a_xx - a_yy)/2", Component::x, shown},
    {"alpha_y", "-", "the same, a_xy", Component::y, shown},
    {"alpha_in_x", "-", "back-stress ratio where loading began, apparent, (a_xx - a_yy)/2", Component::x,
     shown},
    {"alpha_in_y", "-", "the same, a_xy", Component::y, shown},
    {"alpha_turn_x", "-", "back-stress ratio where loading began in truth, (a_xx - a_yy)/2", Component::x},
    {"alpha_turn_y", "-", "the same, a_xy", Component::y},
    {"alpha_before_x", "-", "alpha_in of the loading before, (a_xx - a_yy)/2", Component::x},
    {"alpha_before_y", "-", "the same, a_xy", Component::y},
    {"alpha_middle_x", "-",
     "between the least back-stress ratio of the positive reversals and the largest of the negative ones, "
     "(a_xx - a_yy)/2",
     Component::x},
    {"alpha_middle_y", "-", "the same, a_xy", Component::y},
    {"alpha_beyond_x", "-", "the largest of the negative ones less the middle, (a_xx - a_yy)/2"},
    {"alpha_beyond_y", "-", "the same, a_xy"},
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
    {"start_mean", "Pa", "mean stress in the plane at the start of shaking"},
    {"shear_x", "-", "strain since the start of shaking, eps_x - eps_y", Component::x},
    {"shear_y", "-", "the same, gamma_xy", Component::y},
    {"largest_shear", "-", "largest shear strain since the start of shaking", Component::scalar, shown},
    {"liquefied_shear", "-", "the same when the sand last had liquefied; 0: it has not", Component::scalar,
     shown},
    {"compaction", "-", "volumetric strain of reconsolidation", Component::scalar, shown},
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

ShakingHistory history_of(Particles& particles)
{
    return history_at(numbers_of_cycles, particles.memory);
}

/// The strain that compaction leaves, in pieces; the voids lose what compaction takes.
void update_with_history(const Pm4Sand& law, double dt, std::size_t first, std::size_t last,
                         Particles& particles)
{
    NormalRates rates;
    const Gradients& L = particles.velocity_gradient_solid;
    const ShakingHistory history = history_of(particles);
    for (std::size_t p = first; p < last; p += NormalRates::most) {
        const std::size_t end = std::min(last, p + NormalRates::most);
        advance_history(law, dt, p, end, particles, history, rates);
        update(law, dt, p, end, rates.xx.data(), rates.yy.data(), particles);
        for (std::size_t q = p; q < end; ++q) {
            const double lost = dt * (rates.xx[q - p] + rates.yy[q - p] - L.xx[q] - L.yy[q]);
            particles.memory[void_ratio][q] -= (1.0 + particles.memory[void_ratio][q]) * lost;
        }
    }
}

/// The stress ratio of a particle, compression positive.
Vector2 ratio_of(std::size_t p, const Particles& particles)
{
    const SymmetricTensors& stress = particles.stress;
    return Vector2(0.5 * (stress.yy[p] - stress.xx[p]), -stress.xy[p]) / mean_stress(stress, p);
}

/// Move the yield surface, and where its loadings began, with a stress that something else than strain has
/// changed.
void carry_back_stress(const Vector2& change, std::size_t p, Particles& particles)
{
    constexpr std::size_t first = 0, last = 8; // columns of vectors, x and y in turn
    for (std::size_t k = first; k <= last; k += 2) {
        particles.memory[k][p] += change.x();
        particles.memory[k + 1][p] += change.y();
    }
}

} // namespace

bool keeps_history(const Pm4Sand& law)
{
    return law.remembers == SandMemory::of_shaking || law.reconsolidation_slope > 0.0 ||
           law.liquefied_conductivity > 1.0;
}

LawMemory memory_of(const Pm4Sand& law)
{
    return keeps_history(law) ? LawMemory(memory) : LawMemory(memory).first(numbers_of_cycles);
}

double conductivity_factor(const Pm4Sand& law, std::size_t p, const Particles& particles)
{
    return liquefied_conductivity_factor(law, numbers_of_cycles, p, particles);
}

PlaneSkeleton skeleton_at(const Pm4Sand& law, double s)
{
    return {law.bulk_over_shear * largest_shear_modulus(law, s), 1.0}; // its flow leads to K_0
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
    const bool has_begun = particles.memory.size() >= numbers_of_cycles; // before that sand has no fabric
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
    ENSURE(particles.memory.size() >= memory_of(law).size());
    if (keeps_history(law)) return update_with_history(law, dt, first, last, particles);
    const Gradients& L = particles.velocity_gradient_solid;
    update(law, dt, first, last, L.xx.data() + first, L.yy.data() + first, particles);
}

void even_out_cell(const Pm4Sand& law, double dt, std::span<const std::int32_t> points, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory_of(law).size());
    const ShakingHistory history = history_of(particles);
    if (std::none_of(points.begin(), points.end(),
                     [&](std::int32_t p) { return history.liquefied_shear[p] > 0.0; }))
        return;
    std::vector<Vector2> ratios;
    for (const std::int32_t p : points) ratios.push_back(ratio_of(static_cast<std::size_t>(p), particles));
    even_reconsolidation(settling_skeleton(law), dt, points, history, particles);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto p = static_cast<std::size_t>(points[k]);
        carry_back_stress(ratio_of(p, particles) - ratios[k], p, particles);
    }
}

std::size_t start_memory(const Pm4Sand& law, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory_of(law).size());
    std::size_t changed = 0;
    for (std::size_t p = first; p < last; ++p) {
        Pm4SandState state = state_of(p, particles);
        changed += begin_shaking(law, state) ? 1U : 0U;
        set_state(p, state, particles);
        if (keeps_history(law)) begin_history(mean_stress(particles.stress, p), p, history_of(particles));
    }
    return changed;
}

void complete_memory(const Pm4Sand& law, std::size_t first, std::size_t last, Particles& particles)
{
    if (!keeps_history(law)) return;
    const ShakingHistory history = history_of(particles);
    for (std::size_t p = first; p < last; ++p) {
        if (history.start_mean[p] > 0.0) continue;
        begin_history(late_start_mean(mean_stress(particles.stress, p), p, particles), p, history);
    }
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
