// A folder of its own for a test, a small body to write, and a disk that is full.
#pragma once

#include "io/scene.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <stdlib.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace quicksand::fixtures {

/// Removed with all it holds at the end of the test.
class TemporaryFolder {
public:
    TemporaryFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "quicksand_XXXXXX").string();
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// While it lives, no file can grow beyond `bytes`: the writer sees what it sees on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes)
    {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &former_);
        const rlimit limit{bytes, former_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit former_{};
    void (*handler_)(int) = SIG_DFL;
};

inline std::string text_of(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline bool any_temporary_file(const std::filesystem::path& folder)
{
    for (const auto& item : std::filesystem::recursive_directory_iterator(folder))
        if (item.path().extension() == ".tmp") return true;
    return false;
}

/// 4 x 3 cells of 0.5 m, 2 x 2 particles in each: a block 2 m wide and 1.5 m high.
inline Problem small_problem(bool saturated)
{
    Problem problem;
    problem.grid = {{0.0, 0.0}, 0.5, 4, 3};
    problem.materials = {stiff_sand()};
    problem.region_names = {"ground"};
    if (saturated) problem.water = water_to(1.5);
    problem.boundaries =
        rectangle(0.0, 0.0, 2.0, 1.5, SoilCondition::fixed, SoilCondition::roller, SoilCondition::free);
    problem.base_motion = SineMotion{1.0, 10.0, 1e9, 0.0};
    return problem;
}

inline State small_state(const Problem& problem)
{
    State state = fill(problem, 2, [](const Vector2&) { return true; });
    set_level_ground_stress(problem, 1.5, 0.5, state);
    return state;
}

/// A scene of the small problem with one probe of each kind.
inline Scene small_scene()
{
    Scene scene;
    scene.file = "block.toml";
    scene.text = "title = \"block\"\n";
    scene.end_time = 0.02;
    scene.output = {0.01, 0.002, 0.005, 0.0};
    scene.probes = {{"rider", ProbeKind::material, Vector2(0.9, 0.9), {}, 0, {}},
                    {"point", ProbeKind::fixed, Vector2(1.1, 0.7), {}, 0, {}},
                    {"crest", ProbeKind::surface, Vector2(1.1, 0.0), {}, 0, {}},
                    {"line", ProbeKind::profile, Vector2(1.0, 0.0), Vector2(1.0, 1.5), 4, {}}};
    return scene;
}

} // namespace quicksand::fixtures
