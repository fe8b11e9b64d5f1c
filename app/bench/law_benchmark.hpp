// What a particle's stress costs by each soil law.
#pragma once

#include <string>

namespace quicksand {

/// A table of nanoseconds a particle and step, a row for each law of scenes, for elastic steps and for
/// loading, on one thread.
std::string describe_law_cost();

} // namespace quicksand
