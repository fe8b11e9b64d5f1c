// What UBCSAND costs a particle, one by one and in vectors.
#pragma once

#include <string>

namespace quicksand {

/// A table of nanoseconds a particle and step for elastic and for plastic steps, on one thread.
std::string describe_law_cost();

} // namespace quicksand
