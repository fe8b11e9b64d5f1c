// The soil laws as alternatives, one row each. A law is visited once per run of particles, never per
// particle; what it has to offer: law_interface.hpp.
#pragma once

#include "solver/pm4sand/pm4sand_particles.hpp"
#include "solver/soil/law_interface.hpp"
#include "solver/soil/linear_elastic.hpp"
#include "solver/soil/mohr_coulomb.hpp"
#include "solver/soil/neo_hookean.hpp"
#include "solver/ubcsand/settling_sand.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace quicksand {

using SkeletonLaw = std::variant<LinearElastic, MohrCoulomb, UbcSand, NeoHookean, SettlingSand, Pm4Sand>;

/// One of every law that users can choose.
std::vector<SkeletonLaw> laws_of_scenes();

/// The number of the law's key `key` in its unit.
double value_of(const SkeletonLaw& law, std::size_t key);

/// Put a number, in the unit of the law's key `key`, into the law.
void set_value(SkeletonLaw& law, std::size_t key, double value);

// The functions of law_interface.hpp for whichever law it is.
std::string_view name_of(const SkeletonLaw& law);
std::vector<LawKeyText> keys_of(const SkeletonLaw& law);
bool flows_at_constant_volume(const SkeletonLaw& law);
LawMemory memory_of(const SkeletonLaw& law);
std::size_t start_memory(const SkeletonLaw& law, std::size_t first, std::size_t last, Particles& particles);
bool keeps_history(const SkeletonLaw& law);
void keep_history(SkeletonLaw& law);
void complete_memory(const SkeletonLaw& law, std::size_t first, std::size_t last, Particles& particles);
std::size_t count_at_failure(const SkeletonLaw& law, std::size_t first, std::size_t last,
                             const Particles& particles);
SkeletonLaw settling_form(const SkeletonLaw& law, double cell_weight);
SkeletonLaw without_weight(const SkeletonLaw& law);
std::optional<VibrationDamping> vibration_damping_of(const SkeletonLaw& law);
SkeletonLaw undamped(const SkeletonLaw& law);
bool yields(const SkeletonLaw& law);
bool damps_vibrations(const SkeletonLaw& law);
bool bears_stress_as_drawn(const SkeletonLaw& law);
bool has_strength(const SkeletonLaw& law);
SkeletonLaw reduced(const SkeletonLaw& law, double factor);
void hold_water(SkeletonLaw& law, double dry_fraction);
double shear_modulus_at(const SkeletonLaw& law, std::size_t p, const Particles& particles);
double conductivity_factor(const SkeletonLaw& law, std::size_t p, const Particles& particles);
StressFloor stress_floor_of(const SkeletonLaw& law);
std::string objection_to_stress(const SkeletonLaw& law, std::size_t p, const Particles& particles);
std::optional<FailureLine> failure_line_of(const SkeletonLaw& law);

} // namespace quicksand
