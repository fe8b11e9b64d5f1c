// UBCSAND as a law of particles: its stress is theirs, its memory columns of theirs, without copies.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/reconsolidation/compaction.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/ubcsand/ubcsand.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace quicksand {

/// M and G of unloading at a mean stress of one atmosphere [Pa].
double constrained_modulus(const UbcSand& law);
double shear_modulus(const UbcSand& law);

/// G of unloading at the particle's present stress [Pa].
double shear_modulus_at(const UbcSand& law, std::size_t p, const Particles& particles);

/// Of the particles [first, last) at their present stress.
ParticleModuli particle_moduli(const UbcSand& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// The same at the largest stress that their present motion can lead to over dt.
ParticleModuli expected_moduli(const UbcSand& law, double dt, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Add the stress of the strain L dt to the particles [first, last) and advance their memory, rotated stress
/// and memory given. Pre: start_memory.
void update_stress(const UbcSand& law, double dt, std::size_t first, std::size_t last, Particles& particles);

/// What reconsolidation/compaction.hpp asks.
inline double reconsolidation_slope(const UbcSand& law)
{
    return law.reconsolidation;
}
inline double least_mean_stress(const UbcSand& law)
{
    return law.s_min;
}
PlaneSkeleton skeleton_at(const UbcSand& law, double s);

/// Liquefied sand of a cell settles as one, see cell_reconsolidation.hpp.
inline bool settles_by_cells(const UbcSand& law)
{
    return law.reconsolidation > 0.0;
}
void even_out_cell(const UbcSand& law, double dt, std::span<const std::int32_t> points, Particles& particles);

/// What a particle remembers of its cycles; meaning and signs as in UbcSandState.
LawMemory memory_of(const UbcSand& law);

/// k of the particle's place in its liquefaction over that of sand at rest [-].
double conductivity_factor(const UbcSand& law, std::size_t p, const Particles& particles);

inline double largest_conductivity_factor(const UbcSand& law)
{
    return law.liquefied_conductivity;
}

/// Start of shaking: bring a stress that the sand cannot carry to its failure limit and its floor, and let
/// the memory begin with the stress. Returns the number of particles whose stress was changed. Pre:
/// add_memory.
std::size_t start_memory(const UbcSand& law, std::size_t first, std::size_t last, Particles& particles);

/// Whether the law asks for a history, or a later stage does.
bool keeps_history(const UbcSand& law);

inline void keep_history(UbcSand& law)
{
    law.remembers = SandMemory::of_shaking;
}

/// A history begins at the present stress, but for s_0: that of the start of shaking at K_0 = 1/2. Sand that
/// has liquefied before does not know it.
void complete_memory(const UbcSand& law, std::size_t first, std::size_t last, Particles& particles);

inline bool damps_vibrations(const UbcSand&)
{
    return true;
}

/// How many of the particles [first, last) are at the failure limit.
std::size_t count_at_failure(const UbcSand& law, std::size_t first, std::size_t last,
                             const Particles& particles);

/// Bounds of the volume count the grains alone, which are the fraction `dry_fraction` of the particles' mass
/// [-].
void hold_water(UbcSand& law, double dry_fraction);

/// The floor of the mean stress; a stress ratio above the failure limit; that limit.
inline StressFloor stress_floor_of(const UbcSand& law)
{
    return {law.s_min, "stress_floor"};
}
std::string objection_to_stress(const UbcSand& law, std::size_t p, const Particles& particles);
inline std::optional<FailureLine> failure_line_of(const UbcSand& law)
{
    return FailureLine{law.eta_f, law.eta_f * law.a};
}

/// The largest t within the failure limit at a mean stress s: (s + a) sin phi_f [Pa].
inline double failure_shear(const UbcSand& law, double s)
{
    return law.eta_f * (s + law.a);
}

} // namespace quicksand
