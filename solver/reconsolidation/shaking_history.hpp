// What a point of sand remembers of the whole shaking: its start, its shear strain, whether it liquefied, and
// how far it has settled since.
#pragma once

#include "solver/particles/particles.hpp"

#include <cstddef>
#include <cstdint>

namespace quicksand {

/// Whether sand remembers strains and stresses of the whole shaking where its own law has no use for them. As
/// wide as a number, for laws that compare by their bits.
enum class SandMemory : std::uint64_t { of_cycles, of_shaking };

/// The columns of the particles, one number each.
struct ShakingHistory {
    double* start_mean;        // s_0, mean stress in the plane at the start [Pa]
    double *shear_x, *shear_y; // strain since the start, eps_x - eps_y and gamma_xy, tension positive [-]
    double* largest_shear;     // its largest size [-]
    double* liquefied_shear;   // the same when the sand last had liquefied; 0: it has not [-]
    double* compaction;        // volumetric strain of reconsolidation so far [-]
};

inline constexpr std::size_t history_numbers = 6; // of a point [-]

/// The columns of the memory from `first` on, in the order of ShakingHistory.
ShakingHistory history_at(std::size_t first, SoilMemory& memory);

/// Begin with a mean stress [Pa] of the start.
void begin_history(double start_mean, std::size_t p, const ShakingHistory& history);

/// s_0 [Pa] of a history that begins after the shaking has: the present mean stress [Pa], or that of the
/// start at K_0 = 1/2 where this is larger.
double late_start_mean(double present, std::size_t p, const Particles& particles);

/// Add a shear strain of (x, y) = (eps_x - eps_y, gamma_xy). Sand has liquefied at a tenth of s_0 and at the
/// floor of its law; `mean_stress` is at least that floor [Pa].
void note_shear(double x, double y, double mean_stress, double floor, std::size_t p,
                const ShakingHistory& history);

/// The volumetric strain [-] of reconsolidation on the whole way to s_0: slope min(gamma_max, 8 %) [YWS06:
/// Yoshimine, Nishizaki, Amano and Hosono (2006), after Ishihara and Yoshimine (1992)].
double whole_compaction(double slope, std::size_t p, const ShakingHistory& history);

} // namespace quicksand
