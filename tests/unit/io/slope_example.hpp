// A slope in water for the tests: its scene without [water], and its section.
#pragma once

#include "tests/unit/io/scene_example.hpp"

namespace quicksand::fixtures {

/// 12 m wide, ground at 2 m on the right, slope of 1:2 from x = 8 up to x = 4, crest at 4 m.
inline Section slope_section(const Vector2& move = Vector2::Zero())
{
    Ring ring;
    for (const Vector2& point :
         {Vector2(0, 0), Vector2(12, 0), Vector2(12, 2), Vector2(8, 2), Vector2(4, 4), Vector2(0, 4)})
        ring.push_back(point + move);
    Section section;
    section.regions = {{"sand", {{ring, {}}}}};
    section.curves = {{"base", {{ring[0], ring[1]}}},
                      {"right", {{ring[1], ring[2]}}},
                      {"ground", {{ring[2], ring[3]}, {ring[3], ring[4]}, {ring[4], ring[5]}}},
                      {"left", {{ring[5], ring[0]}}}};
    bound_section(section);
    return section;
}

inline const std::string slope_rest = R"(
[materials.sand]
model = "linear_elastic"
shear_modulus = "20 MPa"
poisson_ratio = 0.3
porosity = 0.4
hydraulic_conductivity = 1e-4

[regions.sand]
material = "sand"

[boundaries.base]
soil = "fixed"

[boundaries.left]
soil = "roller"

[boundaries.right]
soil = "roller"

[run]
end_time = 1
)";

/// The scene with these lines in [water], and these in [boundaries.ground].
inline std::string slope_scene(const std::string& water, const std::string& ground = "soil = \"free\"")
{
    return "scene_version = 1\n[geometry]\nfile = \"column.geo\"\n[grid]\ncell_size = 0.5\n[water]\n" +
           water + "\n[boundaries.ground]\n" + ground + slope_rest;
}

} // namespace quicksand::fixtures
