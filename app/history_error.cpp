#include "app/history_error.hpp"

#include "io/picture_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

struct ComparedColumn {
    const char *column, *quantity;
};

constexpr std::array<ComparedColumn, 3> compared = {{{"excess_pore_pressure_Pa", "excess pore pressure"},
                                                     {"uy_m", "settlement"},
                                                     {"ux_m", "sideways displacement"}}};

struct Difference {
    double range = 0.0, root_mean_square = 0.0;
};

Difference difference(const std::vector<double>& a, const std::vector<double>& reference)
{
    const std::size_t rows = std::min(a.size(), reference.size());
    Difference result;
    double low = INFINITY, high = -INFINITY, sum = 0.0;
    std::size_t count = 0;
    for (std::size_t k = 0; k < rows; ++k) {
        if (std::isnan(a[k]) || std::isnan(reference[k])) continue;
        low = std::min(low, reference[k]);
        high = std::max(high, reference[k]);
        sum += (a[k] - reference[k]) * (a[k] - reference[k]);
        ++count;
    }
    if (count == 0) return result;
    return {high - low, std::sqrt(sum / static_cast<double>(count))};
}

bool is_profile(const PictureTable& table)
{
    const std::vector<double>* time = table.find("time_s");
    return time == nullptr || std::adjacent_find(time->begin(), time->end()) != time->end();
}

/// What both runs have of the column, probe by probe.
std::vector<Difference> differences(const char* column, const fs::path& results, const fs::path& reference)
{
    std::vector<Difference> all;
    for (const auto& entry : fs::directory_iterator(reference / "probes")) {
        if (entry.path().extension() != ".csv") continue;
        const PictureTable exact = read_picture_table(entry.path());
        if (is_profile(exact)) continue;
        const PictureTable table = read_picture_table(results / "probes" / entry.path().filename());
        if (table.find(column) == nullptr || exact.find(column) == nullptr) continue;
        all.push_back(difference(*table.find(column), *exact.find(column)));
    }
    return all;
}

} // namespace

std::vector<HistoryError> history_errors(const fs::path& results, const fs::path& reference)
{
    std::vector<HistoryError> errors;
    for (const ComparedColumn& each : compared) {
        const std::vector<Difference> probes = differences(each.column, results, reference);
        double range = 0.0, largest = 0.0;
        for (const Difference& probe : probes) range = std::max(range, probe.range);
        for (const Difference& probe : probes) {
            if (probe.range > 0.01 * range) largest = std::max(largest, probe.root_mean_square / probe.range);
        }
        if (range > 0.0) errors.push_back({each.quantity, largest});
    }
    return errors;
}

} // namespace quicksand
