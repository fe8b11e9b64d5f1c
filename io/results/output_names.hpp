// The files and folders of a run's results.
#pragma once

#include "io/tables/scene.hpp"

#include <string>
#include <vector>

namespace quicksand {

/// What the output observers write, relative to the results folder, for the manifest.
std::vector<std::string> output_names(const Scene& scene);

} // namespace quicksand
