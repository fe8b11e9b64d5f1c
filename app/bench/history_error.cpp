#include "app/bench/history_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

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

/// Errors of a column at the probes that have it in both runs and where it changes; the largest first.
std::vector<ProbeError> probe_errors(const char* column, const std::vector<ProbeHistory>& run,
                                     const std::vector<ProbeHistory>& reference)
{
    std::vector<std::pair<std::string, Difference>> all;
    double range = 0.0;
    for (const ProbeHistory& exact : reference) {
        const PictureTable* same = find_probe(run, exact.probe);
        if (same == nullptr) continue;
        const std::vector<double>*a = same->find(column), *b = exact.table.find(column);
        if (a == nullptr || b == nullptr) continue;
        all.emplace_back(exact.probe, difference(*a, *b));
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

std::vector<ProbeHistory> read_probe_histories(const fs::path& results)
{
    std::vector<ProbeHistory> probes;
    for (const auto& entry : fs::directory_iterator(results / "probes")) {
        if (entry.path().extension() != ".csv") continue;
        PictureTable table = read_picture_table(entry.path());
        if (!is_profile(table)) probes.push_back({entry.path().stem().string(), std::move(table)});
    }
    std::sort(probes.begin(), probes.end(),
              [](const ProbeHistory& a, const ProbeHistory& b) { return a.probe < b.probe; });
    return probes;
}

const PictureTable* find_probe(const std::vector<ProbeHistory>& histories, const std::string& probe)
{
    const auto same = std::find_if(histories.begin(), histories.end(),
                                   [&](const ProbeHistory& each) { return each.probe == probe; });
    return same == histories.end() ? nullptr : &same->table;
}

std::string text_of(const HistoryError& error)
{
    std::string text = error.quantity;
    for (const ProbeError& each : error.probes)
        text += fmt::format("{} {:.3g} % at {}", &each == &error.probes.front() ? "" : ",",
                            100.0 * each.error, each.probe);
    return text;
}

std::vector<HistoryError> history_errors(const std::vector<ProbeHistory>& run,
                                         const std::vector<ProbeHistory>& reference)
{
    std::vector<HistoryError> errors;
    for (const ComparedQuantity& each : compared_quantities) {
        HistoryError error{each.name, probe_errors(each.column, run, reference)};
        if (!error.probes.empty()) errors.push_back(std::move(error));
    }
    return errors;
}

} // namespace quicksand
