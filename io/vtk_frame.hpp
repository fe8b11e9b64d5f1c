// One .vtu file as plain data: points, quadrilaterals and named arrays. VTK itself stays in vtk_frame.cpp.
#pragma once

#include "solver/conventions.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace quicksand {

/// A named array of points or cells.
struct FrameArray {
    std::string name;                    // snake_case
    std::string unit;                    // "Pa", "m/s"; "-" when dimensionless
    std::vector<std::string> components; // names of the components; empty: a scalar
    std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>> values; // tuple by tuple

    std::size_t component_count() const { return components.empty() ? 1 : components.size(); }
};

/// A list of texts kept with the frame, e.g. the names behind the numbers of `material`.
struct FrameText {
    std::string name;
    std::vector<std::string> lines;
};

struct Frame {
    double time = 0.0;                              // kept as TimeValue [s]
    std::vector<Vector2> points;                    // [m]
    std::vector<std::array<std::int64_t, 4>> quads; // point numbers, counter-clockwise
    std::vector<FrameArray> point_data;
    std::vector<FrameArray> cell_data;
    std::vector<FrameText> texts;
};

/// Write an XML .vtu file (arrays in place, zlib level 1) by way of a temporary file, on the disk itself when
/// it returns. Points are Float64: a Float32 of a 100 m section resolves only 8e-6 m. The units go to the
/// text `units`, a line "name: unit" for every array. Throws FileError.
void write_frame(const std::filesystem::path& path, const Frame& frame);

/// Read such a file. Throws FileError.
Frame read_frame(const std::filesystem::path& path);

} // namespace quicksand
