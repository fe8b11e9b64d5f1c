#include "io/reports/summary_reading.hpp"

#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture_field.hpp"
#include "io/reports/run_comparison.hpp"
#include "io/results/results_folder.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

bool is_extreme(const ComparedValue& value)
{
    return std::find(summarized_extremes.begin(), summarized_extremes.end(), value.column) !=
           summarized_extremes.end();
}

bool has_histories(const ResultsFolder& folder)
{
    return fs::exists(folder.history()) || fs::is_directory(folder.directory / "probes");
}

Vector2 centre_of(const std::vector<Vector2>& corners)
{
    Vector2 sum = Vector2::Zero();
    for (const Vector2& corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
}

void add_places(const ParticleFrame& frame, RunSummary& summary)
{
    summary.frame_time = frame.time;
    for (const char* name : {"displacement", "excess_pore_pressure", "ru", "shear_strain"}) {
        const auto field = drawn_field(frame, name);
        if (!field) continue;
        std::size_t largest = field->values.size();
        for (std::size_t p = 0; p < field->values.size(); ++p) {
            if (!std::isfinite(field->values[p])) continue;
            if (largest == field->values.size() ||
                std::abs(field->values[p]) > std::abs(field->values[largest]))
                largest = p;
        }
        if (largest == field->values.size()) continue;
        const Vector2 centre = centre_of(frame.domains[largest]);
        const std::string unit = field->unit == "%" ? "" : field->unit;
        summary.places.push_back({name, unit, field->values[largest], centre.x(), centre.y()});
    }
}

} // namespace

RunSummary summarize_run(const fs::path& results)
{
    RunSummary summary;
    const ResultsFolder folder{results};
    if (has_histories(folder))
        for (const ComparedValue& value : compare_runs(read_compared_runs({results})))
            if (is_drawn(value) || is_extreme(value))
                summary.values.push_back(
                    {value.table, value.column, value.peak, value.peak_time, value.final_value});
    if (!fs::exists(folder.particle_series())) return summary;
    const std::vector<FrameEntry> frames = read_series_index(folder.particle_series());
    if (!frames.empty()) add_places(read_particle_frame(folder.directory / frames.back().file), summary);
    return summary;
}

} // namespace quicksand
