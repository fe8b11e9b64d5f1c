// PM4Sand as a law of particles: its stress is theirs, its memory columns of theirs.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/pm4sand/pm4sand.hpp"
#include "solver/reconsolidation/compaction.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/ubcsand/settling_sand.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace quicksand {

inline std::string_view name_of(const Pm4Sand&)
{
    return "pm4sand";
}

/// M and G at a mean stress of one atmosphere, without fabric and shear [Pa].
double constrained_modulus(const Pm4Sand& law);
double shear_modulus(const Pm4Sand& law);

/// G at the particle's present state [Pa].
double shear_modulus_at(const Pm4Sand& law, std::size_t p, const Particles& particles);

/// Of the particles [first, last) at their present mean stress, without fabric and shear, which only soften.
ParticleModuli particle_moduli(const Pm4Sand& law, std::size_t first, std::size_t last,
                               const Particles& particles);

/// The same at the largest stress that their present motion can lead to over dt, by contraction and by
/// dilation.
ParticleModuli expected_moduli(const Pm4Sand& law, double dt, std::size_t first, std::size_t last,
                               const Particles& particles);

/// Add the stress of the strain L dt to the particles [first, last) and advance their memory, rotated stress
/// and memory given. Pre: start_memory.
void update_stress(const Pm4Sand& law, double dt, std::size_t first, std::size_t last, Particles& particles);

/// What reconsolidation/compaction.hpp asks.
inline double reconsolidation_slope(const Pm4Sand& law)
{
    return law.reconsolidation_slope;
}
inline double least_mean_stress(const Pm4Sand&) // 3 p_min: cycles of shear end at 2 p_min
{
    return 3.0 * atmospheric_pressure / 200.0;
}
PlaneSkeleton skeleton_at(const Pm4Sand& law, double s);

/// Liquefied sand of a cell settles as one, see cell_reconsolidation.hpp.
inline bool settles_by_cells(const Pm4Sand& law)
{
    return law.reconsolidation_slope > 0.0;
}
void even_out_cell(const Pm4Sand& law, double dt, std::span<const std::int32_t> points, Particles& particles);

/// k of the particle's place in its liquefaction over that of sand at rest [-].
double conductivity_factor(const Pm4Sand& law, std::size_t p, const Particles& particles);

inline double largest_conductivity_factor(const Pm4Sand& law)
{
    return law.liquefied_conductivity;
}

/// Whether the law asks for a history, or a later stage does.
bool keeps_history(const Pm4Sand& law);

inline void keep_history(Pm4Sand& law)
{
    law.remembers = SandMemory::of_shaking;
}

/// A history begins at the present stress, but for s_0: that of the start of shaking at K_0 = 1/2. Sand that
/// has liquefied before does not know it.
void complete_memory(const Pm4Sand& law, std::size_t first, std::size_t last, Particles& particles);

/// What a particle remembers; meaning and signs as in Pm4SandState.
LawMemory memory_of(const Pm4Sand& law);

/// Start of shaking: the particles' stress is their consolidation stress. Returns the number of particles
/// whose stress was changed. Pre: add_memory.
std::size_t start_memory(const Pm4Sand& law, std::size_t first, std::size_t last, Particles& particles);

inline bool damps_vibrations(const Pm4Sand&)
{
    return true;
}

/// How many of the particles [first, last) are on their bounding surface or outside.
std::size_t count_at_failure(const Pm4Sand& law, std::size_t first, std::size_t last,
                             const Particles& particles);

/// A stress ratio outside the bounding and the dilatancy surface.
std::string objection_to_stress(const Pm4Sand& law, std::size_t p, const Particles& particles);

/// The sand while it settles under gravity: elastic with G and static_poisson_ratio, plastic at the peak
/// friction that M^b gives at one atmosphere. Strength reduction reduces this friction.
SettlingSand settling_form(const Pm4Sand& law, double cell_weight);

inline bool has_strength(const Pm4Sand&)
{
    return true;
}

} // namespace quicksand
