#include "solver/columns/equal_columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

namespace quicksand {

namespace {

constexpr double same_place = 1e-9;  // places that are the same [cells]
constexpr double same_value = 1e-10; // of the largest of an array

/// A coordinate in millionths of a cell: rounding does not tell two columns apart.
std::int64_t millionths(double x, double cell)
{
    return std::llround(x * 1e6 / cell);
}

/// A place within its column, by height and from its left.
using Place = std::pair<std::int64_t, std::int64_t>;

Place place_in_column(const EqualColumns& columns, const Vector2& x, int column)
{
    return {millionths(x.y(), columns.width),
            millionths(x.x() - columns.left - column * columns.width, columns.width)};
}

/// Whether every column has particles at the places of the first one; fills in what repeats where.
bool match_particles(const Particles& particles, EqualColumns& columns)
{
    const std::size_t count = particles.size();
    columns.column.resize(count);
    columns.source.resize(count);
    columns.shift.resize(count);
    std::map<Place, std::size_t> first_column;
    for (std::size_t p = 0; p < count; ++p) {
        const double cells = (particles.position.x[p] - columns.left) / columns.width;
        if (!(cells > -same_place && cells < columns.count + same_place)) return false;
        const int column = std::clamp(static_cast<int>(std::floor(cells + same_place)), 0, columns.count - 1);
        columns.column[p] = column;
        columns.shift[p] = column * columns.width;
        if (column > 0) continue;
        columns.particles.push_back(p);
        if (!first_column.emplace(place_in_column(columns, particles.position[p], 0), p).second) return false;
    }
    std::vector<int> repeats(count, 0);
    for (std::size_t p = 0; p < count; ++p) {
        const auto source =
            first_column.find(place_in_column(columns, particles.position[p], columns.column[p]));
        if (source == first_column.end()) return false;
        columns.source[p] = source->second;
        ++repeats[source->second];
    }
    return std::all_of(columns.particles.begin(), columns.particles.end(),
                       [&](std::size_t p) { return repeats[p] == columns.count; });
}

/// Whether every particle carries what its source does.
bool values_repeat(const Particles& particles, const EqualColumns& columns)
{
    bool repeat = true;
    for_each_index_array(particles, [&](std::string_view name, const std::vector<std::int32_t>& values) {
        if (name == "identifier") return;
        for (std::size_t p = 0; p < values.size(); ++p)
            repeat = repeat && values[p] == values[columns.source[p]];
    });
    for_each_array(particles, [&](std::string_view name, const Scalars& values) {
        const bool is_place = name == "position_x" || name == "reference_position_x";
        double size = is_place ? columns.width : 0.0;
        for (const double value : values) size = std::max(size, is_place ? 0.0 : std::abs(value));
        for (std::size_t p = 0; p < values.size(); ++p) {
            const double expected = values[columns.source[p]] + (is_place ? columns.shift[p] : 0.0);
            repeat = repeat && std::abs(values[p] - expected) <= same_value * size;
        }
    });
    return repeat;
}

using Row = std::vector<std::size_t>; // from left to right

std::vector<Row> rows_of_first_column(const Particles& particles, const EqualColumns& columns)
{
    std::map<std::int64_t, Row> by_height;
    for (const std::size_t p : columns.particles)
        by_height[millionths(particles.position.y[p], columns.width)].push_back(p);
    std::vector<Row> rows;
    const Scalars& x = particles.position.x;
    for (auto& [height, row] : by_height) {
        std::sort(row.begin(), row.end(), [&](std::size_t p, std::size_t q) { return x[p] < x[q]; });
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Whether the particles of a row divide the column's width evenly.
bool is_even(const Particles& particles, const EqualColumns& columns, const Row& row)
{
    const double part = columns.width / static_cast<double>(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) {
        const double middle = columns.left + (static_cast<double>(k) + 0.5) * part;
        if (!(std::abs(particles.position.x[row[k]] - middle) <= same_place * columns.width)) return false;
    }
    return true;
}

} // namespace

std::optional<EqualColumns> find_equal_columns(const Problem& problem, const Particles& particles)
{
    EqualColumns columns;
    columns.left = problem.tied_sides->x_left;
    columns.width = problem.grid.cell_size;
    columns.count =
        static_cast<int>(std::lround((problem.tied_sides->x_right - columns.left) / columns.width));
    if (!match_particles(particles, columns) || !values_repeat(particles, columns)) return std::nullopt;
    return columns;
}

void join_rows(const Particles& particles, EqualColumns& columns)
{
    const std::vector<Row> rows = rows_of_first_column(particles, columns);
    const std::size_t length = rows.empty() ? 1 : rows.front().size();
    const bool are_even = std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
        return row.size() == length && is_even(particles, columns, row);
    });
    if (length == 1 || !are_even) return;
    EqualColumns joined = columns;
    joined.row_length = static_cast<int>(length);
    joined.particles.clear();
    std::map<std::size_t, std::size_t> first_of_row; // of the particles of the first column
    for (const Row& row : rows) {
        joined.particles.push_back(row.front());
        for (const std::size_t p : row) first_of_row.emplace(p, row.front());
    }
    std::sort(joined.particles.begin(), joined.particles.end());
    for (std::size_t p = 0; p < particles.size(); ++p) {
        joined.source[p] = first_of_row.at(columns.source[p]);
        joined.shift[p] = particles.position.x[p] - particles.position.x[joined.source[p]];
    }
    if (values_repeat(particles, joined)) columns = std::move(joined);
}

} // namespace quicksand
