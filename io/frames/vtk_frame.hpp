// One .vtu file as plain data: points, polygons and named arrays. VTK itself stays in vtk_frame.cpp.
#pragma once

#include "solver/base/conventions.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
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

/// Polygons by the numbers of their points, each counter-clockwise.
struct FrameCells {
    std::vector<std::int64_t> corners;      // cell by cell
    std::vector<std::int64_t> starts = {0}; // where a cell's corners begin; one more than cells

    bool operator==(const FrameCells&) const = default;
    std::size_t size() const { return starts.size() - 1; }
    std::span<const std::int64_t> operator[](std::size_t cell) const
    {
        return {corners.data() + starts[cell], corners.data() + starts[cell + 1]};
    }
    void add(std::span<const std::int64_t> points)
    {
        corners.insert(corners.end(), points.begin(), points.end());
        starts.push_back(static_cast<std::int64_t>(corners.size()));
    }
};

struct Frame {
    double time = 0.0;           // kept as TimeValue [s]
    std::vector<Vector2> points; // [m]
    FrameCells cells;            // quadrilaterals where they have four corners, polygons otherwise
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
