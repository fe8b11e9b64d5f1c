// Files and sections that the geometry tests share.
#pragma once

#include "geometry/gmsh_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace quicksand {

/// A folder of its own for each test, removed afterwards.
class ScratchFolder {
public:
    ScratchFolder()
    {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string("quicksand-") + test->test_suite_name() + "-" + test->name();
        for (char& c : name) {
            if (c == '/') c = '-';
        }
        path_ = std::filesystem::temp_directory_path() / (name + std::to_string(getpid()));
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// Read the text as a .geo file.
inline Section read_geo(const std::string& text, GmshRequest request = {})
{
    const ScratchFolder folder;
    request.file = folder.write("section.geo", text + "\n");
    return read_gmsh_file(request);
}

inline std::filesystem::path fixture(const std::string& name)
{
    return std::filesystem::path(QUICKSAND_SOURCE_DIR) / "tests/unit/geometry/fixtures" / name;
}

inline Polygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

inline Section make_section(std::vector<Region> regions)
{
    Section section;
    section.regions = std::move(regions);
    bound_section(section);
    return section;
}

inline BackgroundGrid make_grid(double x, double y, double cell_size, int cells_x, int cells_y)
{
    BackgroundGrid grid;
    grid.origin = Vector2(x, y);
    grid.cell_size = cell_size;
    grid.cells_x = cells_x;
    grid.cells_y = cells_y;
    return grid;
}

} // namespace quicksand
