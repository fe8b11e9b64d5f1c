#include "io/reports/crest_check.hpp"

#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/results/result_reader.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/run_record.hpp"
#include "io/scene/scene_keys.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

bool is_in_small_strain(const ResultsFolder& folder)
{
    if (!std::filesystem::exists(folder.scene_copy()) || !std::filesystem::exists(folder.manifest()))
        return false;
    const std::vector<ResolvedKey> keys =
        read_scene_keys(folder.scene_copy(), read_run_record(folder.manifest()).overrides);
    return std::any_of(keys.begin(), keys.end(), [](const ResolvedKey& key) {
        return key.path == "analysis.strain" && key.value == "small";
    });
}

/// By how much each particle of a frame lies higher than its shape tells: small strain draws all stages from
/// the shape of the drawing [m].
std::vector<double> unseen_rises(const ResultsFolder& folder, const ParticleFrame& frame)
{
    std::vector<double> rises(frame.domains.size(), 0.0);
    const auto total = frame.scalars.find("total_displacement_y");
    if (total == frame.scalars.end() || !is_in_small_strain(folder)) return rises;
    const std::vector<double>& present = frame.scalars.at("displacement_y");
    for (std::size_t p = 0; p < rises.size(); ++p) rises[p] = total->second[p] - present[p];
    return rises;
}

} // namespace

std::optional<CrestCheck> check_crest(const std::filesystem::path& results)
{
    const ResultsFolder folder{results};
    if (!std::filesystem::exists(folder.history()) || !std::filesystem::exists(folder.particle_series()))
        return std::nullopt;
    const PictureTable history = read_picture_table(folder.history());
    const std::vector<double>* settlements = history.find("crest_settlement_m");
    const std::vector<FrameEntry> frames = read_series_index(folder.particle_series());
    if (settlements == nullptr || settlements->empty() || frames.empty()) return std::nullopt;
    // displacements may have been kept since a stage before, whose shape the first frame has
    CrestCheck crest{-INFINITY, settlements->back() - settlements->front(), false};
    const ParticleFrame first = read_particle_frame(results / frames.front().file);
    const std::vector<double> rises = unseen_rises(folder, first);
    for (std::size_t p = 0; p < first.domains.size(); ++p) {
        for (const Vector2& corner : first.domains[p])
            crest.before = std::max(crest.before, corner.y() + rises[p]);
        crest.is_unseen = crest.is_unseen || rises[p] != 0.0;
    }
    return crest;
}

} // namespace quicksand
