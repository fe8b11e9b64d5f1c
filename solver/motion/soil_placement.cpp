#include "solver/motion/soil_placement.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

template <class Value>
void keep_only(const std::vector<std::int32_t>& indices, std::vector<Value>& values)
{
    if (values.empty()) return;
    std::vector<Value> kept;
    kept.reserve(indices.size());
    for (const std::int32_t index : indices) kept.push_back(values[static_cast<std::size_t>(index)]);
    values.swap(kept);
}

void keep_only(const std::vector<std::int32_t>& indices, Particles& particles)
{
    for_each_index_array(particles, [&](const char*, auto& values) { keep_only(indices, values); });
    for_each_array(particles, [&](const char*, Scalars& values) { keep_only(indices, values); });
}

/// Index of the particle of each lasting number, -1: not there.
std::vector<std::int32_t> places_of(const Particles& particles)
{
    std::vector<std::int32_t> places;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const auto number = static_cast<std::size_t>(particles.identifier[p]);
        if (number >= places.size()) places.resize(number + 1, -1);
        places[number] = static_cast<std::int32_t>(p);
    }
    return places;
}

std::int32_t place_of(const std::vector<std::int32_t>& places, std::int32_t identifier)
{
    const auto number = static_cast<std::size_t>(identifier);
    return number < places.size() ? places[number] : -1;
}

/// Whether regions that go on have particles among the others.
bool splits_a_region(const Particles& goes_on, const Particles& all, const std::vector<std::int32_t>& others)
{
    std::vector<bool> goes;
    for (const std::int32_t region : goes_on.region) {
        const auto r = static_cast<std::size_t>(region);
        if (r >= goes.size()) goes.resize(r + 1, false);
        goes[r] = true;
    }
    return std::any_of(others.begin(), others.end(), [&](std::int32_t p) {
        const auto region = static_cast<std::size_t>(all.region[static_cast<std::size_t>(p)]);
        return region < goes.size() && goes[region];
    });
}

/// How far the ground beneath a fill has settled since it was drawn, by columns of cells.
class GroundBeneath {
public:
    GroundBeneath(const BackgroundGrid& grid, const MatchedSoil& matched)
        : grid_(grid), columns_(static_cast<std::size_t>(grid.nodes_x()))
    {
        const Particles& drawn = matched.drawn;
        for (std::size_t p = matched.size(); p < drawn.size(); ++p) {
            double& bottom = columns_[column_of(drawn.position.x[p])].bottom;
            bottom = std::min(bottom, drawn.position.y[p]);
        }
        for (std::size_t p = 0; p < matched.size(); ++p) {
            Column& column = columns_[column_of(drawn.position.x[p])];
            const double depth = column.bottom - drawn.position.y[p];
            if (!(depth > 0.0 && depth < grid.cell_size)) continue;
            column.moved += matched.reached.position.y[p] - drawn.position.y[p];
            column.particles += 1.0;
        }
    }

    /// Upward, linear between the middles of columns; 0 where there is no ground beneath [m].
    double movement(double x) const
    {
        const double place = (x - grid_.rim_origin().x()) / grid_.cell_size - 0.5;
        const double first = std::floor(place);
        double weight = 0.0, moved = 0.0;
        const auto add = [&](double k, double share) {
            if (k < 0.0 || k >= static_cast<double>(columns_.size())) return;
            const Column& column = columns_[static_cast<std::size_t>(k)];
            if (column.particles <= 0.0) return;
            weight += share;
            moved += share * column.moved / column.particles;
        };
        add(first, first + 1.0 - place);
        add(first + 1.0, place - first);
        return weight > 0.0 ? moved / weight : 0.0;
    }

private:
    struct Column {
        double bottom = std::numeric_limits<double>::infinity(); // lowest particle of the fill [m]
        double moved = 0.0;     // upward, sum over the ground's particles within a cell beneath [m]
        double particles = 0.0; // [-]
    };

    std::size_t column_of(double x) const
    {
        const double cells = std::floor((x - grid_.rim_origin().x()) / grid_.cell_size);
        return static_cast<std::size_t>(std::clamp(cells, 0.0, static_cast<double>(columns_.size()) - 1.0));
    }

    const BackgroundGrid& grid_;
    std::vector<Column> columns_;
};

} // namespace

MatchedSoil match_soil(const Particles& drawn, Particles reached)
{
    const std::vector<std::int32_t> of_drawn = places_of(drawn), of_reached = places_of(reached);
    std::vector<std::int32_t> order, going_on, placed, removed;
    for (std::size_t p = 0; p < reached.size(); ++p) {
        const std::int32_t place = place_of(of_drawn, reached.identifier[p]);
        (place < 0 ? removed : going_on).push_back(static_cast<std::int32_t>(p));
        if (place >= 0) order.push_back(place);
    }
    for (std::size_t p = 0; p < drawn.size(); ++p)
        if (place_of(of_reached, drawn.identifier[p]) < 0) placed.push_back(static_cast<std::int32_t>(p));
    MatchedSoil matched;
    matched.is_same = placed.empty() && removed.empty();
    const std::size_t before = reached.size();
    matched.drawn = drawn;
    matched.reached = std::move(reached);
    const Particles all = matched.is_same ? Particles() : matched.reached;
    if (!matched.is_same) keep_only(going_on, matched.reached);
    if (splits_a_region(matched.reached, drawn, placed) || splits_a_region(matched.reached, all, removed))
        throw InputError(
            "the stage before has " + std::to_string(before) + " particles and this one " +
            std::to_string(drawn.size()) +
            ", which differ within a region\nexpected: the same drawing, grid and sampling"
            "\nhint: where one of them computes one column for all, set analysis.columns = \"all\" in "
            "both");
    order.insert(order.end(), placed.begin(), placed.end());
    keep_only(order, matched.drawn);
    return matched;
}

void place_soil(const Problem& problem, const MatchedSoil& matched, Particles& particles)
{
    for (std::size_t p = matched.size(); p < particles.size(); ++p)
        particles.stress.xx[p] = particles.stress.yy[p] = particles.stress.zz[p] = particles.stress.xy[p] =
            0.0;
    if (problem.strain == StrainForm::small) return;
    const GroundBeneath ground(problem.grid, matched);
    for (std::size_t p = matched.size(); p < particles.size(); ++p) {
        particles.position.y[p] += ground.movement(particles.position.x[p]);
        particles.reference_position.y[p] = particles.position.y[p];
    }
}

} // namespace quicksand
