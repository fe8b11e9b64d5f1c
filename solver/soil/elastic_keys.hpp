// The parameters of isotropic elasticity, which several laws have.
#pragma once

#include "solver/soil/law_key.hpp"

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

} // namespace quicksand
