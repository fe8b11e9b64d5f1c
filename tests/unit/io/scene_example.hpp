// A sound scene of a saturated column for the tests, its section, and texts made from it.
#pragma once

#include "io/case_assembly.hpp"
#include "io/scene_file.hpp"
#include "solver/base/failure.hpp"
#include "tests/unit/io/temporary_folder.hpp"

#include <fstream>
#include <string>
#include <vector>

namespace quicksand::fixtures {

inline const std::string column_scene = R"(scene_version = 1
title = "column"

[geometry]
file = "column.geo"

[grid]
cell_size = "7.5 mm"

[sampling]
particles_per_cell = [3, 3]

[gravity]
acceleration = "120 g"

[water]
level = 0.3175

[materials.sand]
model = "linear_elastic"
shear_modulus = "60 MPa"
poisson_ratio = 0.3
grain_density = 2670
porosity = 0.405
hydraulic_conductivity = 5.8e-5

[regions.sand]
material = "sand"

[boundaries.base]
soil = "fixed"

[boundaries.left]
soil = "tied"
tied_to = "right"

[boundaries.right]
soil = "tied"
tied_to = "left"

[boundaries.surface]
soil = "free"

[motion]
kind = "sine"
amplitude = "24 g"
frequency = 180

[run]
end_time = 0.2

[probes.crest]
kind = "surface"
at = [0.03, 0.3]
)";

/// The text with its one occurrence of `what` replaced.
inline std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const auto at = text.find(what);
    if (at == std::string::npos || text.find(what, at + 1) != std::string::npos) {
        throw std::invalid_argument("not exactly once in the text: " + what);
    }
    return text.replace(at, what.size(), by);
}

/// A folder with a scene and a drawing; messages name the files without the folder.
class SceneFolder {
public:
    SceneFolder() { write("column.geo", "Point(1) = {0, 0, 0};\n"); }

    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    SceneReading read(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        write("scene.toml", text);
        return read_scene_file(folder_ / "scene.toml", overrides);
    }
    std::string without_folder(std::string text) const
    {
        const std::string prefix = folder_.path().string() + "/";
        for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
            text.erase(at, prefix.size());
        }
        return text;
    }
    /// What is said of the scene: the errors with the warnings, or the warnings alone.
    std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        try {
            const SceneReading reading = read(text, overrides);
            return without_folder(reading.warnings.render(reading.scene.text));
        } catch (const InputError& error) {
            return without_folder(error.what()) + "\n";
        }
    }
    /// As message, of the assembly with a section.
    std::string assembly_message(const std::string& text, const Section& section) const
    {
        try {
            const AssembledCase assembled = assemble_case(read(text), section);
            return without_folder(assembled.warnings.render(assembled.scene.text));
        } catch (const InputError& error) {
            return without_folder(error.what()) + "\n";
        }
    }

private:
    TemporaryFolder folder_;
};

/// A rectangle of one region "sand" from (left, lower) to (right, upper) [m] with its four sides named.
inline Section rectangular_section(double left, double lower, double right, double upper)
{
    const Vector2 a(left, lower), b(right, lower), c(right, upper), d(left, upper);
    Section section;
    section.regions = {{"sand", {{{a, b, c, d}, {}}}}};
    section.curves = {{"base", {{a, b}}}, {"right", {{b, c}}}, {"surface", {{c, d}}}, {"left", {{d, a}}}};
    section.lower = a;
    section.upper = c;
    return section;
}

inline Section column_section()
{
    return rectangular_section(0.0, 0.0, 0.0675, 0.3175);
}

} // namespace quicksand::fixtures
