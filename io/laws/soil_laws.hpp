// The soil laws as scenes name them, one row each. A law is a file pair here and one below solver/soil.
#pragma once

#include "io/laws/soil_law.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace quicksand {

std::span<const SoilLaw> soil_laws();

/// The rows of all laws in scenes, each with its condition; a key that several laws have is one row.
std::vector<SceneKey> soil_law_keys();

/// The same in element tests.
std::vector<SceneKey> element_law_keys();

/// The law of materials.*.model = `word`; the first one for an unknown word, which has been reported.
const SoilLaw& soil_law(std::string_view word);

/// Read the law of a material. Reports, beside what the law does, a soil that cannot settle where it is to.
SkeletonLaw read_soil_law(const LawSource& source);

/// Read the law of a material of element tests.
DescribedLaw read_element_law(const LawSource& source);

/// A usual soil of the law.
SkeletonLaw example_of(const SoilLaw& law);

/// The words of the laws with a strength that can be reduced, quoted: "a" or "b".
std::string laws_with_strength();

/// Whether sand settles after liquefaction by a fraction of what laboratories measure, for want of a
/// reconsolidation_slope.
bool lacks_reconsolidation(const SkeletonLaw& law);

/// Whether sand is softened so that it settles after shaking.
bool has_post_shaking_option(const SkeletonLaw& law);

/// The law of that form.
const SoilLaw& soil_law(const SkeletonLaw& form);

} // namespace quicksand
