#include "io/reports/crest_check.hpp"

#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/results/result_reader.hpp"
#include "io/results/results_folder.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

std::optional<CrestCheck> check_crest(const std::filesystem::path& results)
{
    const ResultsFolder folder{results};
    if (!std::filesystem::exists(folder.history()) || !std::filesystem::exists(folder.particle_series()))
        return std::nullopt;
    const PictureTable history = read_picture_table(folder.history());
    const std::vector<double>* settlements = history.find("crest_settlement_m");
    const std::vector<FrameEntry> frames = read_series_index(folder.particle_series());
    if (settlements == nullptr || settlements->empty() || frames.empty()) return std::nullopt;
    CrestCheck crest{-INFINITY, settlements->back()};
    for (const auto& domain : read_particle_frame(results / frames.front().file).domains)
        for (const Vector2& corner : domain) crest.before = std::max(crest.before, corner.y());
    return crest;
}

} // namespace quicksand
