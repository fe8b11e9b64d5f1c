#include "solver/ubcsand/ubcsand_particles.hpp"

#include "solver/base/failure.hpp"
#include "solver/reconsolidation/cell_reconsolidation.hpp"
#include "solver/reconsolidation/compaction.hpp"
#include "solver/reconsolidation/liquefied_conductivity.hpp"
#include "solver/ubcsand/ubcsand_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

constexpr std::size_t of_cycles = 15;  // numbers that every law of the kind remembers [-]
constexpr std::size_t of_history = 16; // the first of a history's [-]
constexpr std::size_t dilated = 22;    // the first of the two that tell where the sand has dilated [-]
constexpr std::size_t of_start = 24;   // the first of the two of its static shear [-]

constexpr std::array<MemoryNumber, 26> memory = {{
    {"eta_max", "-", "largest stress ratio so far", Component::scalar, true},
    {"branch", "-", "0 just reversed, 0.5 strain too, 1 far from there, 1.5 in a ripple, 2 loading",
     Component::scalar, true},
    {"peak_x", "-", "stress ratio where the stress last turned, (sigma_x - sigma_y)/2 over s", Component::x},
    {"peak_y", "-", "the same, tau_xy over s", Component::y},
    {"origin_x", "-", "stress ratio at the last turn that was no ripple's", Component::x},
    {"origin_y", "-", "the same, tau_xy over s", Component::y},
    {"leg_x", "-", "strain from where it last turned to its farthest point, eps_x - eps_y", Component::x},
    {"leg_y", "-", "the same, gamma_xy", Component::y},
    {"back_x", "-", "strain back from the farthest point, eps_x - eps_y", Component::x},
    {"back_y", "-", "the same, gamma_xy", Component::y},
    {"last_leg", "-", "length of the leg before, squared"},
    {"waiting", "-", "1 a reversal of the strain for loading, -1 loading for a reversal, 0 none"},
    {"half_cycles", "-", "reversals that were followed by loading", Component::scalar, true},
    {"dilation", "-", "plastic shear strain in dilation", Component::scalar, true},
    {"active_dilation", "-", "its value at the last counted half cycle"},
    {"start_factor", "-", "of the plastic modulus, by the stress at the start of shaking"},
    {"start_mean", "Pa", "mean stress in the plane at the start of shaking"},
    {"shear_x", "-", "strain since the start of shaking, eps_x - eps_y", Component::x},
    {"shear_y", "-", "the same, gamma_xy", Component::y},
    {"largest_shear", "-", "largest shear strain since the start of shaking", Component::scalar, true},
    {"liquefied_shear", "-", "the same when the sand last had liquefied; 0: it has not", Component::scalar,
     true},
    {"compaction", "-", "volumetric strain of reconsolidation", Component::scalar, true},
    {"dilated_x", "-",
     "stress ratio where the last half cycle turned that dilated, if dilation_strain is finite",
     Component::x},
    {"dilated_y", "-", "the same, tau_xy over s", Component::y},
    {"static_x", "-", "static shear over the vertical stress at the start of shaking, as it has turned",
     Component::x},
    {"static_y", "-", "the same: tau_xy where nothing has turned", Component::y},
}};

UbcSandState at_one_atmosphere()
{
    UbcSandState state;
    state.sigma_x = state.sigma_y = state.sigma_z = atmospheric_pressure;
    return state;
}

UbcSandArrays arrays_of(const UbcSand& law, Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
    std::array<double*, of_cycles> m{}; // columns
    for (std::size_t k = 0; k < m.size(); ++k) m[k] = particles.memory[k].data();
    const bool has_history = keeps_history(law);
    return {L.xx.data(),
            L.xy.data(),
            L.yx.data(),
            L.yy.data(),
            stress.xx.data(),
            stress.yy.data(),
            stress.zz.data(),
            stress.xy.data(),
            m[0],
            m[1],
            m[2],
            m[3],
            m[4],
            m[5],
            m[6],
            m[7],
            m[8],
            m[9],
            m[10],
            m[11],
            m[12],
            m[13],
            m[14],
            particles.volume.data(),
            particles.mass_solid.data(),
            has_history ? particles.memory[of_cycles].data() : nullptr,
            has_history ? particles.memory[dilated].data() : nullptr,
            has_history ? particles.memory[dilated + 1].data() : nullptr,
            has_history ? particles.memory[of_start].data() : nullptr,
            has_history ? particles.memory[of_start + 1].data() : nullptr};
}

ShakingHistory history_of(Particles& particles)
{
    return history_at(of_history, particles.memory);
}

/// The arrays from point p on.
UbcSandArrays from(std::size_t p, const UbcSandArrays& a)
{
    return {a.L_xx + p,
            a.L_xy + p,
            a.L_yx + p,
            a.L_yy + p,
            a.stress_xx + p,
            a.stress_yy + p,
            a.stress_zz + p,
            a.stress_xy + p,
            a.eta_max + p,
            a.branch + p,
            a.peak_x + p,
            a.peak_y + p,
            a.origin_x + p,
            a.origin_y + p,
            a.leg_x + p,
            a.leg_y + p,
            a.back_x + p,
            a.back_y + p,
            a.last_leg + p,
            a.waiting + p,
            a.half_cycles + p,
            a.dilation + p,
            a.active_dilation + p,
            a.volume + p,
            a.mass_solid + p,
            a.start_factor + p,
            a.dilated_x + p,
            a.dilated_y + p,
            a.static_x + p,
            a.static_y + p};
}

/// One particle, as one point of the laboratory.
void update_alone(const UbcSand& law, double dt, std::size_t p, const UbcSandArrays& points)
{
    UbcSandState state = points.state(p);
    const double volume = points.volume[p], mass = points.mass_solid[p];
    state.least_contraction = volume > law.largest_specific_volume * mass ? 0.0 : -1.0;
    state.most_contraction = volume < law.smallest_specific_volume * mass ? 0.0 : 1.0;
    points.add_to(p, state);
    update(law, {-dt * points.L_xx[p], -dt * points.L_yy[p], -dt * (points.L_xy[p] + points.L_yx[p]), 0.0},
           state);
    points.set(p, state);
    points.set_dilated(p, state);
}

void update_points(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                   const UbcSandArrays& points)
{
    if (last == first + 1) return update_alone(law, dt, first, points); // lanes would be empty
    update(law, dt, first, last, points);
}

/// The strain that compaction leaves, in pieces.
void update_with_history(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                         Particles& particles)
{
    NormalRates rates;
    const UbcSandArrays arrays = arrays_of(law, particles);
    const ShakingHistory history = history_of(particles);
    for (std::size_t p = first; p < last; p += NormalRates::most) {
        const std::size_t end = std::min(last, p + NormalRates::most);
        advance_history(law, dt, p, end, particles, history, rates);
        UbcSandArrays points = from(p, arrays);
        points.L_xx = rates.xx.data(), points.L_yy = rates.yy.data();
        update_points(law, dt, 0, end - p, points);
    }
}

/// Begin with the state of the start of shaking.
void begin_with(const UbcSandState& start, std::size_t p, Particles& particles)
{
    begin_history(0.5 * (start.sigma_x + start.sigma_y), p, history_of(particles));
    particles.memory[of_cycles][p] = start.start_factor;
    particles.memory[of_start][p] = start.static_x;
    particles.memory[of_start + 1][p] = start.static_y;
}

/// Shrink the deviator in the plane to the failure limit and raise the mean stress to the floor; true when
/// that changed the stress.
bool limit_stress(const UbcSand& law, UbcSandState& state)
{
    const double s_before = 0.5 * (state.sigma_x + state.sigma_y);
    const double q_x = 0.5 * (state.sigma_x - state.sigma_y), q_y = state.tau_xy;
    const double s = std::max(s_before, law.s_min), t = std::hypot(q_x, q_y);
    if (s == s_before && t <= failure_shear(law, s)) return false;
    const double ratio = t > 0.0 ? std::min(1.0, failure_shear(law, s) / t) : 1.0;
    state.sigma_x = s + ratio * q_x;
    state.sigma_y = s - ratio * q_x;
    state.tau_xy = ratio * q_y;
    return true;
}

} // namespace

bool keeps_history(const UbcSand& law)
{
    return law.remembers == SandMemory::of_shaking || law.m_v > 0.0 || law.m_h > 0.0 ||
           law.static_shear > 0.0 || law.reconsolidation > 0.0 || law.liquefied_conductivity > 1.0 ||
           law.per_dilation > 0.0;
}

LawMemory memory_of(const UbcSand& law)
{
    return keeps_history(law) ? LawMemory(memory) : LawMemory(memory).first(of_cycles);
}

double conductivity_factor(const UbcSand& law, std::size_t p, const Particles& particles)
{
    return liquefied_conductivity_factor(law, of_history, p, particles);
}

void hold_water(UbcSand& law, double dry_fraction)
{
    law.largest_specific_volume *= dry_fraction;
    law.smallest_specific_volume *= dry_fraction;
}

double constrained_modulus(const UbcSand& law)
{
    return constrained_modulus(law, at_one_atmosphere());
}

double shear_modulus(const UbcSand& law)
{
    return shear_modulus(law, at_one_atmosphere());
}

double shear_modulus_at(const UbcSand& law, std::size_t p, const Particles& particles)
{
    UbcSandState state;
    state.sigma_x = -particles.stress.xx[p];
    state.sigma_y = -particles.stress.yy[p];
    return shear_modulus(law, state);
}

std::string objection_to_stress(const UbcSand& law, std::size_t p, const Particles& particles)
{
    const SymmetricTensors& stress = particles.stress;
    UbcSandState state;
    state.sigma_x = -stress.xx[p], state.sigma_y = -stress.yy[p], state.sigma_z = -stress.zz[p];
    state.tau_xy = -stress.xy[p];
    begin_shaking(law, state);
    if (state.eta_max <= law.eta_f) return "";
    std::ostringstream what;
    what.precision(3);
    what << "its stress ratio t/s = " << state.eta_max
         << " is above the failure limit sin phi_f = " << law.eta_f;
    return what.str();
}

PlaneSkeleton skeleton_at(const UbcSand& law, double s)
{
    const ubcsand::Moduli stiffest = ubcsand::moduli_at(law, s);
    const ubcsand::Moduli loading = ubcsand::moduli_of(law.least_fraction * stiffest.G, stiffest.B);
    return {stiffest.K, loading.K / (3.0 * loading.G)};
}

ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return particle_moduli(law, first, last, particles.stress.xx.data(), particles.stress.yy.data(),
                           particles.volume.data());
}

ParticleModuli expected_moduli(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return expected_moduli(law, dt, first, last, particles.affine_velocity_solid, particles.stress.xx.data(),
                           particles.stress.yy.data(), particles.volume.data());
}

void update_stress(const UbcSand& law, double dt, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory_of(law).size());
    if (keeps_history(law)) return update_with_history(law, dt, first, last, particles);
    update_points(law, dt, first, last, arrays_of(law, particles));
}

void even_out_cell(const UbcSand& law, double dt, std::span<const std::int32_t> points, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory_of(law).size());
    even_reconsolidation(settling_skeleton(law), dt, points, history_of(particles), particles);
}

std::size_t start_memory(const UbcSand& law, std::size_t first, std::size_t last, Particles& particles)
{
    ENSURE(particles.memory.size() >= memory_of(law).size());
    const UbcSandArrays arrays = arrays_of(law, particles);
    std::size_t limited = 0;
    for (std::size_t p = first; p < last; ++p) {
        UbcSandState state = arrays.state(p);
        limited += limit_stress(law, state) ? 1U : 0U;
        begin_shaking(law, state);
        arrays.set(p, state);
        arrays.set_dilated(p, state);
        if (keeps_history(law)) begin_with(state, p, particles);
    }
    return limited;
}

void complete_memory(const UbcSand& law, std::size_t first, std::size_t last, Particles& particles)
{
    if (!keeps_history(law)) return;
    const UbcSandArrays arrays = arrays_of(law, particles);
    const ShakingHistory history = history_of(particles);
    for (std::size_t p = first; p < last; ++p) {
        if (history.start_mean[p] > 0.0) continue;
        UbcSandState state = arrays.state(p);
        begin_shaking(law, state);
        begin_with(state, p, particles);
        history.start_mean[p] = late_start_mean(history.start_mean[p], p, particles);
    }
}

std::size_t count_at_failure(const UbcSand& law, std::size_t first, std::size_t last,
                             const Particles& particles)
{
    constexpr double rounding = 1e-3; // settling ends a little below the limit
    const SymmetricTensors& stress = particles.stress;
    std::size_t count = 0;
    for (std::size_t p = first; p < last; ++p) {
        const double s = -0.5 * (stress.xx[p] + stress.yy[p]);
        const double t = std::hypot(0.5 * (stress.xx[p] - stress.yy[p]), stress.xy[p]);
        count += t >= (1.0 - rounding) * failure_shear(law, s) ? 1U : 0U;
    }
    return count;
}

} // namespace quicksand
