// A small dry dike whose slope and crest cut particles.
#pragma once

#include "tests/unit/io/scene_example.hpp"

namespace quicksand::fixtures {

inline const std::string cut_dike_scene = R"(scene_version = 1

[geometry]
file = "column.geo"

[grid]
cell_size = 0.2
origin = [0.0, 0.0]
cells = [10, 6]

[sampling]
particles_per_cell = [2, 2]

[materials.sand]
model = "linear_elastic"
shear_modulus = 1e6
poisson_ratio = 0.3
grain_density = 2650
porosity = 0.4

[regions.sand]
material = "sand"

[boundaries.base]
soil = "fixed"

[boundaries.slope]
soil = "free"

[run]
end_time = 0.01
)";

/// From (0, 0) to (2, 0), with a slope from (1.47, 0.35) up to (0.6, 0.75): the toe is a reflex corner.
inline Section cut_dike_section()
{
    const std::vector<Vector2> outline = {{0, 0}, {2, 0}, {2, 0.35}, {1.47, 0.35}, {0.6, 0.75}, {0, 0.75}};
    Section section;
    section.regions = {{"sand", {{outline, {}}}}};
    const char* names[] = {"base", "right", "berm", "slope", "crest", "left"};
    for (std::size_t k = 0; k < outline.size(); ++k)
        section.curves.push_back({names[k], {{outline[k], outline[(k + 1) % outline.size()]}}});
    bound_section(section);
    return section;
}

inline AssembledCase assemble_cut_dike()
{
    return assemble_case(SceneFolder().read(cut_dike_scene), cut_dike_section());
}

} // namespace quicksand::fixtures
