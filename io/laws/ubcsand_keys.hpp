// The keys of a material with model = "ubcsand" in scenes and element tests.
#pragma once

#include "io/keys/scene_check.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// The row of the word that chooses between a published law and a calibrated one.
SceneKey law_choice_key();

/// The rows of the key table below [materials.NAME]: the parameters of the law, with the substeps of element
/// tests.
std::vector<SceneKey> ubcsand_keys();

/// The same with the substeps of runs, and what runs need besides.
std::vector<SceneKey> ubcsand_scene_keys();

/// The parameters of a material. One of n1_60, relative_density and preset gives the generic set, in which
/// the keys given replace their value; what the set derives from K_G^e and phi_cv follows those given. The
/// resolved keys of `values` get the numbers. What is wrong is added to `findings`.
UbcSandParameters resolve_ubcsand(const NamedTable& material, SceneValues& values, Diagnostics& findings);

/// Put a number that a default gives into the resolved key of this path.
void show(const std::string& path, double value, SceneValues& values);

} // namespace quicksand
