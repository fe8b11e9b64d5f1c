#include "app/history_error.hpp"

#include "io/picture_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> compared = {"excess_pore_pressure_Pa", "ux_m", "uy_m"};

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

} // namespace

double history_error(const fs::path& results, const fs::path& reference)
{
    std::map<std::string, std::vector<Difference>> by_quantity;
    for (const auto& entry : fs::directory_iterator(reference / "probes")) {
        if (entry.path().extension() != ".csv") continue;
        const PictureTable exact = read_picture_table(entry.path());
        if (is_profile(exact)) continue;
        const PictureTable table = read_picture_table(results / "probes" / entry.path().filename());
        for (const char* column : compared) {
            if (table.find(column) == nullptr || exact.find(column) == nullptr) continue;
            by_quantity[column].push_back(difference(*table.find(column), *exact.find(column)));
        }
    }
    double largest = 0.0;
    for (const auto& [column, differences] : by_quantity) {
        double range = 0.0;
        for (const Difference& each : differences) range = std::max(range, each.range);
        for (const Difference& each : differences) {
            if (each.range > 0.01 * range) largest = std::max(largest, each.root_mean_square / each.range);
        }
    }
    return largest;
}

} // namespace quicksand
