// Sand of the law PM4Sand in scenes and element tests.
#pragma once

#include "io/laws/soil_law.hpp"

namespace quicksand {

/// The resolved keys get the numbers of the defaults. What is wrong is reported.
SkeletonLaw read_pm4sand(const LawSource& source);
DescribedLaw read_pm4sand_for_element(const LawSource& source);

/// Dr = 55 %, all else by default.
SkeletonLaw example_of_pm4sand();

/// Moduli, strength and cyclic strength.
std::string describe_pm4sand(const Material& material, double k0);

} // namespace quicksand
