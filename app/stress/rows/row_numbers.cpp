#include "app/stress/rows/row_numbers.hpp"

#include "io/pictures/picture_table.hpp"
#include "io/results/result_reader.hpp"
#include "io/results/results_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// There is no pore pressure ratio where the stress at the start is too small, and soils of other laws have
/// nothing of what sand remembers; an infinite number is wrong there, too.
bool all_good(const std::string& name, const std::vector<double>& values)
{
    constexpr std::array may_be_empty = {"ru", "half_cycles", "eta_max", "branch", "dilation"};
    const bool empty = std::find(may_be_empty.begin(), may_be_empty.end(), name) != may_be_empty.end();
    return std::all_of(values.begin(), values.end(),
                       [&](double value) { return std::isfinite(value) || (empty && std::isnan(value)); });
}

std::string bad_column(const fs::path& file)
{
    if (!fs::exists(file)) return "";
    const PictureTable table = read_picture_table(file);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (all_good(table.columns[c], table.values[c])) continue;
        return file.filename().string() + ", " + table.columns[c];
    }
    return "";
}

std::string bad_field(const fs::path& file)
{
    const ParticleFrame frame = read_particle_frame(file);
    for (const auto& corners : frame.domains)
        for (const Vector2& corner : corners)
            if (!corner.allFinite()) return file.filename().string() + ", domains";
    for (const auto& [name, values] : frame.scalars)
        if (!all_good(name, values)) return file.filename().string() + ", " + name;
    return "";
}

} // namespace

std::string find_bad_numbers(const fs::path& results)
{
    const ResultsFolder folder{results};
    for (const fs::path& file : {folder.history(), folder.probe("rider")})
        if (std::string bad = bad_column(file); !bad.empty()) return bad;
    if (!fs::exists(folder.particle_series())) return "";
    for (const FrameEntry& frame : read_series_index(folder.particle_series()))
        if (std::string bad = bad_field(results / frame.file); !bad.empty()) return bad;
    return "";
}

} // namespace quicksand
