#include "app/history_error.hpp"

#include "io/picture_table.hpp"

#include <fmt/format.h>

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
    std::string name;
    PictureTable run, reference;
};

std::vector<ProbePair> read_probes(const fs::path& results, const fs::path& reference)
{
    std::vector<ProbePair> probes;
    for (const auto& entry : fs::directory_iterator(reference / "probes")) {
        if (entry.path().extension() != ".csv") continue;
        PictureTable exact = read_picture_table(entry.path());
        if (is_profile(exact)) continue;
        probes.push_back({entry.path().stem().string(),
                          read_picture_table(results / "probes" / entry.path().filename()),
                          std::move(exact)});
    }
    std::sort(probes.begin(), probes.end(),
              [](const ProbePair& a, const ProbePair& b) { return a.name < b.name; });
    return probes;
}

/// Errors of a column at the probes that have it in both runs and where it changes; the largest first.
std::vector<ProbeError> probe_errors(const char* column, const std::vector<ProbePair>& probes)
{
    std::vector<std::pair<std::string, Difference>> all;
    double range = 0.0;
    for (const ProbePair& probe : probes) {
        const std::vector<double>* run = probe.run.find(column);
        const std::vector<double>* exact = probe.reference.find(column);
        if (run == nullptr || exact == nullptr) continue;
        all.emplace_back(probe.name, difference(*run, *exact));
        range = std::max(range, all.back().second.range);
    }
    std::vector<ProbeError> errors;
    for (const auto& [name, one] : all)
        if (one.range > 0.01 * range) errors.push_back({name, one.root_mean_square / one.range});
    std::stable_sort(errors.begin(), errors.end(),
                     [](const ProbeError& a, const ProbeError& b) { return a.error > b.error; });
    return errors;
}

} // namespace

std::string text_of(const HistoryError& error)
{
    std::string text = error.quantity;
    for (const ProbeError& each : error.probes)
        text += fmt::format("{} {:.3g} % at {}", &each == &error.probes.front() ? "" : ",",
                            100.0 * each.error, each.probe);
    return text;
}

std::vector<HistoryError> history_errors(const fs::path& results, const fs::path& reference)
{
    const std::vector<ProbePair> probes = read_probes(results, reference);
    std::vector<HistoryError> errors;
    for (const ComparedColumn& each : compared) {
        HistoryError error{each.quantity, probe_errors(each.column, probes)};
        if (!error.probes.empty()) errors.push_back(std::move(error));
    }
    return errors;
}

} // namespace quicksand
