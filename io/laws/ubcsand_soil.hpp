// Sand of the law UBCSAND in a scene.
#pragma once

#include "io/laws/soil_law.hpp"
#include "io/laws/ubcsand_keys.hpp"

namespace quicksand {

/// The resolved keys get the numbers of the generic set. What is wrong is reported, also an initial stress
/// beyond the failure limit.
SkeletonLaw read_ubcsand(const LawSource& source);

/// The law of element tests, with substeps as fine as they need.
DescribedLaw read_ubcsand_for_element(const LawSource& source);

/// Nevada sand with the substeps of runs.
SkeletonLaw example_of_ubcsand();

/// Moduli, the stresses it bears and its cyclic strength.
std::string describe_ubcsand(const Material& material, double k0);

} // namespace quicksand
