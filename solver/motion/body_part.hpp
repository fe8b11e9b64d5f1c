// A part of a body as a body of its own, its particles numbered anew.
#pragma once

#include "solver/interpolation/cut_domains.hpp"
#include "solver/particles/particles.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace quicksand {

/// Copies of the chosen particles, numbered from 0 in their order.
Particles part_of(const Particles& particles, const std::vector<std::size_t>& chosen);

/// Their new numbers by those in the body.
std::map<std::int32_t, std::int32_t> numbers_in_part(const Particles& particles,
                                                     const std::vector<std::size_t>& chosen);

/// Reduce the pieces and slivers to those of the chosen particles, with their new numbers; false where a
/// sliver is carried by a particle that is not chosen. Polygons are left out.
bool take_part(const Particles& particles, const std::vector<std::size_t>& chosen, CutDomains& cut);

} // namespace quicksand
