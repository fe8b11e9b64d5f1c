#include "io/results/run_label.hpp"

#include "io/results/run_manifest.hpp"

#include <fmt/format.h>

namespace quicksand {

std::vector<std::string> run_comments(const RunLabel& label)
{
    return {"Quicksand " + program_version(),
            fmt::format("scene: {}, hash {}", label.scene_file.filename().string(), label.scene_hash)};
}

} // namespace quicksand
