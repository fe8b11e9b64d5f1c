// Layers of soil that the cells of the grid are too large for.
#pragma once

#include "geometry/section/section.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/tables/scene.hpp"

namespace quicksand {

/// Warn of layers at an angle to the grid of less than three cells, which are too strong
/// (solver/cell_strain/soil_layers.hpp). Not of regions that touch one of the same soil, nor of those whose
/// slopes are free faces, nor of solids, nor where no soil is yet.
void check_layers(const Scene& scene, const Section& section, double cell_size, Diagnostics& findings);

} // namespace quicksand
