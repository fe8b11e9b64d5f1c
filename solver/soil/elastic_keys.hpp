// The parameters of isotropic elasticity, which several laws have.
#pragma once

#include "solver/soil/law_key.hpp"
#include "solver/soil/maxwell_elements.hpp"

namespace quicksand {

inline constexpr LawKeyText shear_modulus_key = {.name = "shear_modulus",
                                                 .unit = "Pa",
                                                 .meaning = "Shear modulus G of the skeleton.",
                                                 .allowed = {.lower = 0.0, .lower_open = true},
                                                 .usual = {1e5, 1e11}};
inline constexpr LawKeyText poisson_ratio_key = {.name = "poisson_ratio",
                                                 .unit = "-",
                                                 .meaning = "Drained Poisson's ratio of the skeleton.",
                                                 .allowed = {.lower = 0.0, .upper = 0.5, .upper_open = true},
                                                 .usual = {0.0, 0.49}};

inline constexpr LawKeyText damping_ratio_key = {
    .name = "damping_ratio",
    .unit = "-",
    .meaning =
        "Damping ratio of vibrations, in shear and compression alike, within 5 % of itself over a band of "
        "frequencies of 1 : 40 (15 % where it is 0.2); in stages that shake; element tests know no time.",
    .allowed = {.lower = 0.0, .upper = 0.2},
    .usual = {0.0, 0.1},
    .standard = 0.0,
    .hangs_on_time = true};
inline constexpr LawKeyText damping_frequency_key = {
    .name = "damping_frequency",
    .unit = "Hz",
    .meaning = "Middle of the band of damping_ratio, which goes from a sixth of it to six times; the moduli "
               "hold there.",
    .allowed = {.lower = 0.0, .lower_open = true},
    .usual = {0.5, 200.0},
    .standard = usual_damping_frequency,
    .hangs_on_time = true};

} // namespace quicksand
