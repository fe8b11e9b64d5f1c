#include "app/stress/scenes/random_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using Heights = std::vector<double>;

/// The section as rows of corners: lines[l][j] is the j-th corner of the l-th line from below.
struct Corners {
    std::vector<std::vector<Vector2>> lines;
};

/// x from 0 to the width, at least 15 % of it apart.
std::vector<double> draw_stations(double width, RandomNumbers& random)
{
    const int spans = random.whole(1, 4);
    std::vector<double> lengths;
    double sum = 0.0;
    for (int k = 0; k < spans; ++k) sum += lengths.emplace_back(random.between(1.0, 2.5));
    std::vector<double> stations = {0.0};
    for (const double length : lengths) stations.push_back(stations.back() + length * width / sum);
    stations.back() = width;
    return stations;
}

/// Flat, on a grid line or off it, inclined, or with kinks.
Heights draw_base(const std::vector<double>& stations, double h, RandomNumbers& random)
{
    const double level = random.chance(0.5) ? 0.0 : h * random.fraction();
    const double slope = random.chance(0.3) ? random.between(-0.15, 0.15) : 0.0;
    const double kinks = random.chance(0.25) ? h : 0.0;
    Heights heights;
    for (const double x : stations)
        heights.push_back(level + slope * (x - 0.5 * stations.back()) + kinks * random.fraction());
    return heights;
}

/// Level, or slopes and benches down to 40 % of the height.
Heights draw_surface(const Heights& base, double height, RandomNumbers& random)
{
    const bool level = random.chance(0.35);
    const double top = *std::max_element(base.begin(), base.end()) + height;
    Heights heights(base.size(), top);
    if (level) return heights;
    for (std::size_t j = 0; j < base.size(); ++j)
        if (!random.chance(0.4)) heights[j] = base[j] + (top - base[j]) * random.between(0.4, 1.0);
    return heights;
}

/// How far a side leans outward for a rise of one; inward so little that nothing crosses.
double draw_lean(double span, double height, RandomNumbers& random)
{
    if (!random.chance(0.3)) return 0.0;
    return random.chance(0.5) ? random.between(0.0, 0.8) : -0.6 * random.fraction() * span / height;
}

Corners draw_corners(const std::vector<double>& stations, const Heights& base, const Heights& surface,
                     RandomNumbers& random)
{
    const int layers = random.one_of({1, 1, 2, 3});
    const double height = *std::max_element(surface.begin(), surface.end()) - base.front();
    const std::size_t last = stations.size() - 1;
    const double lean_left = draw_lean(stations[1], height, random);
    const double lean_right = draw_lean(stations[last] - stations[last - 1], height, random);
    const double jitter = random.chance(0.5) ? 0.0 : 0.3 / layers;
    Corners corners;
    for (int l = 0; l <= layers; ++l) {
        std::vector<Vector2> line;
        const double usual = static_cast<double>(l) / layers;
        const bool inner = l > 0 && l < layers;
        for (std::size_t j = 0; j < stations.size(); ++j) {
            const double part = inner ? usual + jitter * random.between(-1.0, 1.0) : usual;
            const double y = base[j] + part * (surface[j] - base[j]);
            double x = stations[j];
            if (j == 0) x -= lean_left * (y - base[j]);
            if (j == last) x += lean_right * (y - base[j]);
            line.emplace_back(x, y);
        }
        corners.lines.push_back(std::move(line));
    }
    return corners;
}

/// The curve of a span of the base or the surface: its second half may have a name of its own.
std::string curve_of(const std::string& name, bool split, std::size_t span, std::size_t spans)
{
    return split && 2 * span >= spans ? name + "_2" : name;
}

} // namespace

RandomSection draw_random_section(double cell_size, RandomNumbers& random)
{
    RandomSection section;
    section.cell_size = cell_size;
    const double cells_across = random.whole(6, 14) + (random.chance(0.3) ? random.fraction() : 0.0);
    section.width = cell_size * cells_across;
    section.height = cell_size * (random.whole(4, 9) + (random.chance(0.5) ? random.fraction() : 0.0));
    const std::vector<double> stations = draw_stations(section.width, random);
    const Heights base = draw_base(stations, cell_size, random);
    const Heights surface = draw_surface(base, section.height, random);
    const Corners corners = draw_corners(stations, base, surface, random);
    const std::size_t spans = stations.size() - 1, layers = corners.lines.size() - 1;
    const bool split_base = spans > 1 && random.chance(0.25), split_surface = spans > 1 && random.chance(0.3);
    for (std::size_t l = 0; l < layers; ++l) {
        const std::vector<Vector2>&below = corners.lines[l], &above = corners.lines[l + 1];
        std::vector<DraftCorner> loop;
        for (std::size_t j = 0; j < spans; ++j)
            loop.push_back({below[j], l == 0 ? curve_of("base", split_base, j, spans) : ""});
        loop.push_back({below[spans], "right"});
        for (std::size_t j = spans; j > 0; --j)
            loop.push_back(
                {above[j], l + 1 == layers ? curve_of("surface", split_surface, j - 1, spans) : ""});
        loop.push_back({above[0], "left"});
        section.regions.push_back(fmt::format("layer_{}", l + 1));
        section.draft.add_region(section.regions.back(), loop);
    }
    section.bases =
        split_base ? std::vector<std::string>{"base", "base_2"} : std::vector<std::string>{"base"};
    section.surfaces = split_surface ? std::vector<std::string>{"surface", "surface_2"}
                                     : std::vector<std::string>{"surface"};
    section.lowest = *std::min_element(base.begin(), base.end());
    section.highest = *std::max_element(surface.begin(), surface.end());
    const std::vector<Vector2>&first = corners.lines.front(), &last = corners.lines.back();
    const bool whole = cells_across == std::round(cells_across); // sides that are tied lie on grid lines
    section.can_be_tied = whole && first.front().x() == last.front().x() &&
                          first.back().x() == last.back().x() && first.front().y() == first.back().y() &&
                          last.front().y() == last.back().y();
    return section;
}

} // namespace quicksand
