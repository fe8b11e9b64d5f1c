#include "app/run/example_folder.hpp"

#include "io/files/file_error.hpp"

#include <algorithm>
#include <array>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

/// Where the examples may lie: installed beside the program, or in the source tree.
std::array<fs::path, 2> example_roots()
{
    const fs::path program = fs::read_symlink("/proc/self/exe");
    return {program.parent_path().parent_path() / "share" / "quicksand" / "examples",
            fs::path(QUICKSAND_EXAMPLES)};
}

} // namespace

const std::vector<ExampleKind>& example_kinds()
{
    static const std::vector<ExampleKind> kinds = {
        {"column", "column", "column.geo", {}},
        {"dike", "dike", "dike.geo", {}},
        {"river_dike", "layered_dike", "layered_dike.geo", {"apeel2_loma_prieta_1989_133.AT2"}},
        {"sea_dike", "sea_dike", "sea_dike.geo", {"shaking_20g.toml"}},
        {"level_site", "level_ground_motion", "level_ground.geo", {"apeel2_loma_prieta_1989_133.AT2"}},
        {"slope", "lateral_spread", "lateral_spread.geo", {}},
    };
    return kinds;
}

std::vector<std::string> example_names()
{
    std::vector<std::string> names;
    for (const ExampleKind& kind : example_kinds()) names.push_back(kind.word);
    return names;
}

fs::path example_folder(const std::string& name)
{
    for (const fs::path& root : example_roots()) {
        if (fs::exists(root / name / "scene.toml")) return root / name;
    }
    throw FileError(example_roots().front() / name, "cannot find the example",
                    "the installation is not complete", "");
}

std::vector<std::string> verification_names()
{
    for (const fs::path& root : example_roots()) {
        if (!fs::is_directory(root / "verification")) continue;
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(root / "verification")) {
            if (fs::exists(entry.path() / "scene.toml")) names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }
    throw FileError(example_roots().front() / "verification", "cannot find the problems",
                    "the installation is not complete", "");
}

} // namespace quicksand
