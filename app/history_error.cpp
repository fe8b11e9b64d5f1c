#include "app/history_error.hpp"

#include "io/picture_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

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

/// What two runs have of one probe.
struct ProbePair {
    PictureTable run, reference;
};

std::vector<ProbePair> read_probes(const fs::path& results, const fs::path& reference)
{
    std::vector<ProbePair> probes;
    for (const auto& entry : fs::directory_iterator(reference / "probes")) {
        if (entry.path().extension() != ".csv") continue;
        PictureTable exact = read_picture_table(entry.path());
        if (is_profile(exact)) continue;
        probes.push_back(
            {read_picture_table(results / "probes" / entry.path().filename()), std::move(exact)});
    }
    return probes;
}

/// Of the probes that have the column in both runs.
std::vector<Difference> differences(const char* column, const std::vector<ProbePair>& probes)
{
    std::vector<Difference> all;
    for (const ProbePair& probe : probes) {
        const std::vector<double>* run = probe.run.find(column);
        const std::vector<double>* exact = probe.reference.find(column);
        if (run != nullptr && exact != nullptr) all.push_back(difference(*run, *exact));
    }
    return all;
}

} // namespace

std::vector<HistoryError> history_errors(const fs::path& results, const fs::path& reference)
{
    const std::vector<ProbePair> probes = read_probes(results, reference);
    std::vector<HistoryError> errors;
    for (const ComparedColumn& each : compared) {
        const std::vector<Difference> all = differences(each.column, probes);
        double range = 0.0, largest = 0.0;
        for (const Difference& one : all) range = std::max(range, one.range);
        for (const Difference& one : all) {
            if (one.range > 0.01 * range) largest = std::max(largest, one.root_mean_square / one.range);
        }
        if (range > 0.0) errors.push_back({each.quantity, largest});
    }
    return errors;
}

} // namespace quicksand
