#include "geometry/drawing/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace quicksand {

namespace {

/// Edit distance in which a swap of neighbours counts once.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        next[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            next[j] = std::min({change, row[j] + 1, next[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
        }
        before.swap(row);
        row.swap(next);
    }
    return row[b.size()];
}

} // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& names)
{
    std::size_t limit = std::min<std::size_t>(3, std::max<std::size_t>(1, name.size() / 3));
    std::string nearest;
    for (const std::string& candidate : names) {
        const std::size_t length_gap =
            candidate.size() > name.size() ? candidate.size() - name.size() : name.size() - candidate.size();
        if (candidate.empty() || length_gap > limit) continue;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance > limit || (distance == limit && !nearest.empty())) continue;
        limit = distance;
        nearest = candidate;
    }
    return nearest;
}

} // namespace quicksand
