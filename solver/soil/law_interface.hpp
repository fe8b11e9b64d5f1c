// What a soil law is: a plain struct of parameters and the functions below, found by its type.
//
// Every law has
//   update_stress(law, dt, first, last, particles)     stress of the particles [first, last) after a strain
//   particle_moduli(law, first, last, particles)       their moduli, for waves
//   constrained_modulus(law), shear_modulus(law)       without particles [Pa]
// and those here, which are the defaults for laws without such a function. A new law is a file pair
// with these functions and a place in SkeletonLaw (skeleton_law.hpp); scenes know it by its name and its
// keys.
#pragma once

#include "solver/particles/particle_moduli.hpp"
#include "solver/particles/particles.hpp"
#include "solver/soil/law_key.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace quicksand {

/// How a number turns with its particle.
enum class Component : std::uint8_t {
    scalar, // not at all
    x,      // with the next number a vector as of turn_vector() in rotation.hpp
    y
};

/// A number that a law remembers of every particle.
struct MemoryNumber {
    std::string_view name; // "half_cycles"
    std::string_view unit; // "-" without one
    std::string_view meaning;
    Component component = Component::scalar;
    bool shown = false; // in results; others serve the law alone
};
using LawMemory = std::span<const MemoryNumber>; // in the order of the columns of Particles::memory

/// The column of a number by its name; memory.size() where there is none of that name.
inline std::size_t column_of(LawMemory memory, std::string_view name)
{
    std::size_t column = 0;
    while (column < memory.size() && memory[column].name != name) ++column;
    return column;
}

/// The word for the law in scenes; "" for one that users do not choose.
template <class Law>
std::string_view name_of(const Law&)
{
    return "";
}

/// The parameters that users give; none where a reader of its own makes the law.
template <class Law>
std::span<const LawKey<Law>> keys_of(const Law&)
{
    return {};
}

/// The moduli of the particles [first, last) after a step of dt, as far as they can be told before it.
template <class Law>
ParticleModuli expected_moduli(const Law& law, double, std::size_t first, std::size_t last,
                               const Particles& particles)
{
    return particle_moduli(law, first, last, particles);
}

/// Whether the soil flows at constant volume: its strain is then best averaged over the cell, which keeps it
/// free of locking.
template <class Law>
bool flows_at_constant_volume(const Law&)
{
    return false;
}

/// Whether particles that are in one cell settle as one, and what that changes of them after the stress of a
/// step of dt: `points` are those of one material in one cell.
template <class Law>
bool settles_by_cells(const Law&)
{
    return false;
}
template <class Law>
void even_out_cell(const Law&, double, std::span<const std::int32_t>, Particles&)
{
}

/// What the law remembers while the soil is shaken.
template <class Law>
LawMemory memory_of(const Law&)
{
    return {};
}

/// Start of shaking: bring a stress that the soil cannot carry to its limits, and let the memory of the
/// particles [first, last) begin. Returns how many stresses were changed.
template <class Law>
std::size_t start_memory(const Law&, std::size_t, std::size_t, Particles&)
{
    return 0;
}

/// Whether the law remembers more than its cycles, for what it does after they have ended, and let it do so
/// because the law of a later stage does.
template <class Law>
bool keeps_history(const Law&)
{
    return false;
}
template <class Law>
void keep_history(Law&)
{
}

/// Let the history of the particles [first, last) begin where the law that they had before kept none.
template <class Law>
void complete_memory(const Law&, std::size_t, std::size_t, Particles&)
{
}

/// How many of the particles [first, last) carry the largest shear stress that they can.
template <class Law>
std::size_t count_at_failure(const Law&, std::size_t, std::size_t, const Particles&)
{
    return 0;
}

/// The law while the soil settles under gravity; `cell_weight` is that of a cell of the soil, per area [Pa].
template <class Law>
Law settling_form(const Law& law, double)
{
    return law;
}

/// The law without what hangs on the weight of its grains: soils that are equal so differ by weight alone.
template <class Law>
Law without_weight(const Law& law)
{
    return law;
}

/// Damping of vibrations that users ask for, and the frequencies between which it holds.
struct VibrationDamping {
    double ratio = 0.0;                 // [-]
    double lowest = 0.0, highest = 0.0; // [Hz]
    double relaxed = 1.0;               // stiffness under lasting loads over that of the law [-]
};
template <class Law>
std::optional<VibrationDamping> vibration_damping_of(const Law&)
{
    return std::nullopt;
}

/// The law without what damps vibrations, for stages that shake nothing.
template <class Law>
Law undamped(const Law& law)
{
    return law;
}

/// Whether the soil flows at a strength: its stress then hangs on the path, not on the shape.
template <class Law>
bool yields(const Law&)
{
    return true;
}

/// Whether strains to and fro below failure lose energy, as those of sand do: the soil then forgets the
/// vibrations of its body within a few cycles.
template <class Law>
bool damps_vibrations(const Law&)
{
    return false;
}

/// Whether the soil can have a stress in the shape as drawn; else its stress follows from the deformation
/// alone and is zero after a new reference.
template <class Law>
bool bears_stress_as_drawn(const Law&)
{
    return true;
}

/// Whether strength reduction has something to reduce, and the law with its strength divided by a factor.
template <class Law>
bool has_strength(const Law&)
{
    return false;
}
template <class Law>
Law reduced(const Law& law, double)
{
    return law;
}

/// Shear stress that the soil bears without mean stress [Pa].
template <class Law>
double cohesion_of(const Law&)
{
    return 0.0;
}

/// G of unloading at the particle's present stress [Pa].
template <class Law>
double shear_modulus_at(const Law& law, std::size_t, const Particles&)
{
    return shear_modulus(law);
}

/// The least mean stress in the plane that a law knows, and the key that sets it.
struct StressFloor {
    double stress = 0.0; // compression positive [Pa]
    std::string_view key = "";
};
template <class Law>
StressFloor stress_floor_of(const Law&)
{
    return {};
}

/// Hydraulic conductivity of the particle's present state over that of the soil at rest [-].
template <class Law>
double conductivity_factor(const Law&, std::size_t, const Particles&)
{
    return 1.0;
}

/// The largest that it can become.
template <class Law>
double largest_conductivity_factor(const Law&)
{
    return 1.0;
}

/// What is wrong with the particle's stress that the law cannot start from it, as the end of a sentence: "its
/// stress ratio is above the failure limit"; empty where nothing is.
template <class Law>
std::string objection_to_stress(const Law&, std::size_t, const Particles&)
{
    return "";
}

/// Failure in the plane, compression positive: the radius of Mohr's circle is at most at_zero + slope s, s
/// its centre.
struct FailureLine {
    double slope = 0.0;   // [-]
    double at_zero = 0.0; // [Pa]
};
template <class Law>
std::optional<FailureLine> failure_line_of(const Law&)
{
    return std::nullopt;
}

/// Let the grains carry held water as their own mass, of which they are the fraction `dry_fraction` [-].
template <class Law>
void hold_water(Law&, double)
{
}

} // namespace quicksand
