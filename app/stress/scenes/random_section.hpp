// A random cross-section: layers over a base, with a surface and sides of any shape that hangs together.
#pragma once

#include "app/stress/scenes/random_numbers.hpp"
#include "app/stress/scenes/section_draft.hpp"

#include <string>
#include <vector>

namespace quicksand {

struct RandomSection {
    SectionDraft draft;
    double cell_size = 0.0;                   // h [m]
    double width = 0.0, height = 0.0;         // least box around it, less leaning sides [m]
    double lowest = 0.0, highest = 0.0;       // y of base and surface [m]
    std::vector<std::string> regions;         // from below
    std::vector<std::string> bases, surfaces; // names of the curves below and above
    bool can_be_tied = false;                 // sides are upright and of equal height, 0 and `width` [m]
};

/// About 6 x 4 to 14 x 9 cells.
RandomSection draw_random_section(double cell_size, RandomNumbers& random);

} // namespace quicksand
