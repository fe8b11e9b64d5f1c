// Sections of one region, drawn as a polygon of named edges at any place, assembled with a scene as a user's
// are.
#pragma once

#include "io/case_assembly.hpp"
#include "io/scene_file.hpp"
#include "solver/run/simulation.hpp"
#include "tests/unit/io/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace quicksand::fixtures {

/// A vertex and the name of the edge that begins there; "" where it has none.
struct NamedCorner {
    Vector2 place; // [m]
    std::string edge;
};

/// The polygon through the corners, counter-clockwise, as the region "soil".
inline Section polygon_section(const std::vector<NamedCorner>& corners)
{
    Section section;
    Ring ring;
    for (const NamedCorner& corner : corners) ring.push_back(corner.place);
    section.regions = {{"soil", {{ring, {}}}}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (corners[k].edge.empty()) continue;
        const Segment segment{corners[k].place, corners[(k + 1) % corners.size()].place};
        if (!section.curves.empty() && section.curves.back().name == corners[k].edge) {
            section.curves.back().segments.push_back(segment);
        } else {
            section.curves.push_back({corners[k].edge, {segment}});
        }
    }
    bound_section(section);
    return section;
}

/// A point turned about the origin by an angle in degrees, counter-clockwise.
inline Vector2 turn(const Vector2& x, double degrees)
{
    const double angle = degrees * std::numbers::pi / 180.0, c = std::cos(angle), s = std::sin(angle);
    return {c * x.x() - s * x.y(), s * x.x() + c * x.y()};
}

/// Turned about the origin by an angle in degrees, then shifted.
inline std::vector<NamedCorner> turned(std::vector<NamedCorner> corners, double degrees, const Vector2& shift)
{
    for (NamedCorner& corner : corners) corner.place = turn(corner.place, degrees) + shift;
    return corners;
}

inline AssembledCase assemble(const std::string& scene, const Section& section)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "drawing.geo") << "Point(1) = {0, 0, 0};\n";
    std::ofstream(folder / "scene.toml") << scene;
    return assemble_case(read_scene_file(folder / "scene.toml", {}), section);
}

/// Soils of the region "soil".
inline const std::string elastic = R"(
[materials.soil]
model = "linear_elastic"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
porosity = 0.4
[regions.soil]
material = "soil"
)";
inline const std::string mohr_coulomb = R"(
[materials.soil]
model = "mohr_coulomb"
shear_modulus = "8 MPa"
poisson_ratio = 0.25
friction_angle = "35 deg"
cohesion = 1000
porosity = 0.4
[regions.soil]
material = "soil"
)";

/// A weightless elastic column under water, its base held, its sides rollers; `conductivity` in m/s.
inline std::string saturated_column(const std::string& scheme, const std::string& strain, double conductivity)
{
    return "[analysis]\nscheme = \"" + scheme + "\"\nstrain = \"" + strain + R"("
[sampling]
particles_per_cell = [2, 2]
[gravity]
acceleration = 0.0
[water]
level = 3.0
bulk_modulus = "0.2 GPa"
[boundaries.base]
soil = "fixed"
[boundaries.left]
soil = "roller"
[boundaries.right]
soil = "roller"
[materials.soil]
hydraulic_conductivity = )" +
           std::to_string(conductivity) + elastic.substr(elastic.find("]") + 1);
}

/// Keys of a scene that all these tests share, to which the tables of soil and walls are added.
inline std::string scene_with(double cell_size, const Vector2& origin, int cells_x, int cells_y,
                              const std::string& tables)
{
    const auto text = [](double value) { return std::to_string(value); };
    return "scene_version = 1\ntitle = \"drawn\"\naccept = [\"gravity.acceleration\"]\n[geometry]\nfile = "
           "\"drawing.geo\"\n[grid]\ncell_size = " +
           text(cell_size) + "\norigin = [" + text(origin.x()) + ", " + text(origin.y()) + "]\ncells = [" +
           std::to_string(cells_x) + ", " + std::to_string(cells_y) + "]\n[run]\nend_time = 1000.0\n" +
           tables;
}

} // namespace quicksand::fixtures
