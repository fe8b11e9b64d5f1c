#include "solver/inertia/stiff_response.hpp"

#include "solver/inertia/node_masses.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace quicksand {

namespace {

/// Least pivots of a diagonal of ones, by the precision.
template <class Number>
constexpr auto least_pivot = std::is_same_v<Number, float> ? Number(1e-5) : Number(1e-10);
/// Rows whose smallest pivot is below need double precision to be told apart.
constexpr double least_pivot_of_rows = 1e-3;
// Of M + b K, all nodes together, that single precision still tells from it: steps of some 16 cells of a
// wave.
constexpr double least_mass = 1e-3;

template <class Number>
void solve_with(const BandedFactor<Number>& factor, Scalars& values)
{
    std::vector<Number> vector(factor.vector_length(), Number{0});
    std::transform(values.begin(), values.end(), vector.begin(),
                   [](double value) { return static_cast<Number>(value); });
    factor.solve(vector.data());
    std::copy_n(vector.begin(), values.size(), values.begin());
}

/// [0, count) from the first to the last, or by turns from both ends, so that the ends become neighbours.
std::vector<std::size_t> sequence(std::size_t count, bool folded)
{
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k < count; ++k)
        numbers.push_back(!folded ? k : k % 2 == 0 ? k / 2 : count - 1 - k / 2);
    return numbers;
}

/// Whether nodes at the far ends of the soil's longer side are tied.
bool ties_ends(const NodeConditions& conditions, const NodeRows& grid, bool wide)
{
    constexpr std::size_t near = 8; // nodes beyond a wall are tied to those on it
    return std::any_of(conditions.tied.begin(), conditions.tied.end(), [&](const TiedNodes& tie) {
        const auto along = [&](std::size_t node) { return wide ? node % grid.nodes_x : node / grid.nodes_x; };
        const std::size_t a = along(tie.node), b = along(tie.master);
        return std::max(a, b) - std::min(a, b) > near;
    });
}

std::vector<std::size_t> nodes_in_order(const Extent& extent, const NodeConditions& conditions,
                                        const NodeRows& grid)
{
    if (extent.x0 >= extent.x1) return {};
    const std::size_t width = extent.x1 - extent.x0, height = extent.y1 - extent.y0;
    const bool wide = width > height;
    std::vector<std::size_t> nodes;
    for (const std::size_t along : sequence(wide ? width : height, ties_ends(conditions, grid, wide)))
        for (std::size_t across = 0; across < (wide ? height : width); ++across)
            nodes.push_back((extent.y0 + (wide ? across : along)) * grid.nodes_x + extent.x0 +
                            (wide ? along : across));
    return nodes;
}

} // namespace

void StiffResponse::note_parts(const VelocityRows& rows)
{
    parts_.clear();
    rows.for_each_coefficient([&](std::size_t row, std::size_t node, const NodeVelocities& c) {
        parts_.push_back({node, row, c});
    });
    std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
        return a.node != b.node ? a.node < b.node : a.row < b.row;
    });
    std::size_t last = 0;
    for (std::size_t k = 1; k < parts_.size(); ++k) {
        if (parts_[k].node == parts_[last].node && parts_[k].row == parts_[last].row)
            parts_[last].coefficients += parts_[k].coefficients;
        else
            parts_[++last] = parts_[k];
    }
    if (!parts_.empty()) parts_.resize(last + 1);
}

StiffResponse::Pattern StiffResponse::present_pattern(std::size_t rows) const
{
    Pattern pattern{std::vector<std::uint8_t>(shares_.size()), {}, rows};
    for (std::size_t k = 0; k < shares_.size(); ++k) pattern.moves[k] = shares_[k].mass > 0.0 ? 1 : 0;
    pattern.row_nodes.reserve(parts_.size());
    for (const Part& part : parts_) pattern.row_nodes.emplace_back(part.row, part.node);
    return pattern;
}

void StiffResponse::number_equations(const NodeConditions& conditions, const NodeRows& grid)
{
    multipliers_.assign(pattern_.rows, 0);
    const auto is_active = [&](std::size_t i) { return share(i, 0).mass > 0.0 || share(i, 1).mass > 0.0; };
    const std::vector<std::size_t> nodes = nodes_in_order(extent_of(grid, is_active), conditions, grid);
    // multipliers after the last node of their rows
    std::vector<std::size_t> place(shares_.size() / 2, 0);
    for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = k;
    std::vector<std::size_t> last(multipliers_.size(), 0);
    for (const Part& part : parts_) last[part.row] = std::max(last[part.row], place[part.node]);
    std::vector<std::pair<std::size_t, std::size_t>> ends; // of the rows, and their numbers
    for (std::size_t r = 0; r < last.size(); ++r) ends.emplace_back(last[r], r);
    std::sort(ends.begin(), ends.end());

    unknowns_.assign(shares_.size() / 2, {-1, -1});
    list_.clear();
    std::size_t equations = 0, next = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (!(share(nodes[k], axis).mass > 0.0)) continue;
            unknowns_[nodes[k]][axis] = static_cast<std::int32_t>(list_.size());
            list_.push_back({nodes[k], grid.place(nodes[k]), axis, equations++, 0.0, 0.0});
        }
        for (; next < ends.size() && ends[next].first <= k; ++next)
            multipliers_[ends[next].second] = equations++;
    }
    for (; next < ends.size(); ++next) multipliers_[ends[next].second] = equations++;
    for (const TiedNodes& tie : conditions.tied) unknowns_[tie.node] = unknowns_[tie.master];
    equations_ = unknowns_;
    for (std::array<std::int32_t, 2>& of_node : equations_)
        for (std::int32_t& of_axis : of_node)
            if (of_axis >= 0)
                of_axis = static_cast<std::int32_t>(list_[static_cast<std::size_t>(of_axis)].equation);
}

/// Call visit(row, column, value) for the numbers that the masses have in the matrix.
template <class Visit>
void StiffResponse::for_each_of_masses(Visit&& visit) const
{
    for (const Unknown& u : list_) visit(u.equation, u.equation, share(u.node, u.axis).mass);
    for (const MixedShare& of : mixed_)
        visit(unknown(of.node, 1)->equation, unknown(of.node, 0)->equation, of.share.mass);
}

/// The same of the dashpots.
template <class Visit>
void StiffResponse::for_each_of_dashpots(double velocity_dt, const std::vector<Dashpot>& dashpots,
                                         Visit&& visit) const
{
    for (const Dashpot& dashpot : dashpots) {
        const Eigen::Matrix2d half = half_braking(dashpot, velocity_dt);
        const Unknown *x = unknown(dashpot.node, 0), *y = unknown(dashpot.node, 1);
        if (x != nullptr) visit(x->equation, x->equation, half(0, 0));
        if (y != nullptr) visit(y->equation, y->equation, half(1, 1));
        if (x != nullptr && y != nullptr) visit(y->equation, x->equation, half(1, 0));
    }
}

/// The same of K, of which the blocks of a node with itself and with those before it are read: it is
/// symmetric. Both blocks of two nodes that are tied to one are on its diagonal.
template <class Visit>
void StiffResponse::for_each_of_stiffness(const NodeRows& grid, const NodeStiffness& stiffness,
                                          Visit&& visit) const
{
    constexpr std::size_t own = 4; // of the 3 x 3 blocks
    stiffness.for_each_node([&](std::size_t i, std::size_t place) {
        const std::array<std::int32_t, 2>& of = equations_[i];
        if (of[0] < 0 && of[1] < 0) return;
        const std::size_t first = i - grid.nodes_x - 1;
        for (std::size_t k = 0; k <= own; ++k) {
            const std::array<std::int32_t, 2>& other = equations_[first + k / 3 * grid.nodes_x + k % 3];
            for (std::size_t row = 0; row < 2; ++row)
                for (std::size_t column = 0; column < (k == own ? row + 1 : 2); ++column) {
                    const std::int32_t a = of[row], b = other[column];
                    if (a < 0 || b < 0) continue;
                    const double value = stiffness.entry(place, k, row, column);
                    visit(static_cast<std::size_t>(std::max(a, b)), static_cast<std::size_t>(std::min(a, b)),
                          k != own && a == b ? 2.0 * value : value);
                }
        }
    });
}

/// The same of the rows at walls and of followers.
template <class Visit>
void StiffResponse::for_each_of_rows(Visit&& visit) const
{
    const auto add = [&](std::size_t a, std::size_t b, double value) {
        visit(std::max(a, b), std::min(a, b), value);
    };
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const Part& part = parts_[k];
        const AxisShare between = mixed(part.node);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto d = static_cast<int>(axis);
            const AxisShare& of = share(part.node, axis);
            const double c_w = part.coefficients[d + 2], across_w = part.coefficients[3 - d];
            if (const Unknown* u = unknown(part.node, axis); u != nullptr)
                add(multipliers_[part.row], u->equation,
                    part.coefficients[d] + of.carried * c_w + between.carried * across_w);
            const double moved = of.mobility * c_w + between.mobility * across_w;
            if (moved == 0.0) continue;
            for (std::size_t m = k; m < parts_.size() && parts_[m].node == part.node; ++m)
                add(multipliers_[part.row], multipliers_[parts_[m].row],
                    -moved * parts_[m].coefficients[d + 2]);
        }
    }
}

void StiffResponse::factorise(const NodeConditions& conditions, double velocity_dt, double factor,
                              const std::vector<Dashpot>& dashpots, const VelocityRows& walls,
                              const NodeRows& grid, const NodeStiffness& stiffness)
{
    note_parts(walls);
    if (Pattern present = present_pattern(walls.size()); present != pattern_) {
        pattern_ = std::move(present);
        number_equations(conditions, grid);
    }
    const std::size_t equations = list_.size() + multipliers_.size();
    std::vector<std::size_t> first_columns(equations);
    std::iota(first_columns.begin(), first_columns.end(), std::size_t{0});
    Scalars diagonal(equations, 0.0);
    const auto sum_diagonal = [&](std::size_t row, std::size_t column, double value) {
        first_columns[row] = std::min(first_columns[row], column);
        if (row == column) diagonal[row] += std::abs(value);
    };
    for_each_of_masses(sum_diagonal);
    for_each_of_dashpots(velocity_dt, dashpots, sum_diagonal);
    for_each_of_stiffness(grid, stiffness, [&](std::size_t row, std::size_t column, double value) {
        sum_diagonal(row, column, factor * value);
    });
    for_each_of_rows(sum_diagonal);
    // a row has the scale of what its nodes answer
    std::vector<std::uint8_t> is_multiplier(equations, 0);
    for (const std::size_t m : multipliers_) is_multiplier[m] = 1;
    for_each_of_rows([&](std::size_t row, std::size_t column, double value) {
        if (is_multiplier[row] == is_multiplier[column]) return;
        const auto [m, u] = is_multiplier[row] != 0 ? std::pair(row, column) : std::pair(column, row);
        diagonal[m] += value * value / diagonal[u];
    });

    scale_.resize(equations);
    for (std::size_t k = 0; k < equations; ++k)
        scale_[k] = diagonal[k] > 0.0 ? 1.0 / std::sqrt(diagonal[k]) : 0.0;
    double mass = 0.0, resistance = 0.0;
    for (Unknown& u : list_) {
        u.scale = scale_[u.equation];
        mass += share(u.node, u.axis).mass;
        resistance += diagonal[u.equation];
    }
    const bool needs_double = walls.smallest_pivot() < least_pivot_of_rows || mass < least_mass * resistance;
    if (needs_double != std::holds_alternative<BandedFactor<double>>(factor_)) {
        if (needs_double)
            factor_.emplace<BandedFactor<double>>();
        else
            factor_.emplace<BandedFactor<float>>();
    }
    std::visit(
        [&]<class Number>(BandedFactor<Number>& matrix) {
            matrix.reset(first_columns);
            const auto fill = [&](std::size_t row, std::size_t column, double value) {
                matrix.add(row, column, scale_[row] * scale_[column] * value);
            };
            for_each_of_masses(fill);
            for_each_of_dashpots(velocity_dt, dashpots, fill);
            for_each_of_stiffness(grid, stiffness, [&](std::size_t row, std::size_t column, double value) {
                fill(row, column, factor * value);
            });
            for_each_of_rows(fill);
            for (std::size_t row = 0; row < multipliers_.size(); ++row) {
                const std::size_t m = multipliers_[row];
                matrix.set_negative(m);
                matrix.add(m, m, scale_[m] == 0.0 ? -1.0 : -scale_[m] * scale_[m] * walls.softness(row));
            }
            matrix.factorise(least_pivot<Number>);
        },
        factor_);
    vector_.resize(equations);
}

void StiffResponse::answer_impulses(const NodeRows& grid, double velocity_dt,
                                    const std::vector<Dashpot>& dashpots, const Vectors& impulse,
                                    Vectors& answer, Vectors& moving)
{
    std::fill(vector_.begin(), vector_.end(), 0.0);
    for (const Unknown& u : list_) {
        const Scalars& part = u.axis == 0 ? impulse.x : impulse.y;
        vector_[u.equation] = u.scale * part[u.place];
    }
    std::visit([&](const auto& factor) { solve_with(factor, vector_); }, factor_);

    Scalars product(scale_.size(), 0.0); // M v + C^T l
    const auto value_of = [&](std::size_t k) { return scale_[k] * vector_[k]; };
    const auto multiply = [&](std::size_t row, std::size_t column, double entry) {
        product[row] += entry * value_of(column);
        if (row != column) product[column] += entry * value_of(row);
    };
    for_each_of_masses(multiply);
    for_each_of_dashpots(velocity_dt, dashpots, multiply);
    for_each_of_rows(multiply);

    for (Scalars* part : {&answer.x, &answer.y}) part->assign(grid.size(), 0.0);
    for (const Unknown& u : list_) {
        (u.axis == 0 ? answer.x : answer.y)[u.place] = value_of(u.equation);
        (u.axis == 0 ? moving.x : moving.y)[u.place] += product[u.equation];
    }
}

void StiffResponse::set_porosities(Scalars porosities)
{
    porosities_ = std::move(porosities);
    for (Unknown& u : list_) {
        const double n = porosities_[u.node];
        u.gain = 1.0 - n + n * share(u.node, u.axis).carried;
    }
    note_exchanges();
    own_x_.resize(porosities_.size());
    own_y_.resize(porosities_.size());
    for (std::size_t i = 0; i < porosities_.size(); ++i) {
        const double n = porosities_[i];
        own_x_[i] = n * n * share(i, 0).mobility;
        own_y_[i] = n * n * share(i, 1).mobility;
    }
}

void StiffResponse::note_exchanges()
{
    const auto number = [](std::size_t k) { return static_cast<std::uint32_t>(k); };
    of_grains_.clear();
    for (const Unknown& u : list_)
        of_grains_.push_back({number(u.node), number(u.axis), number(u.equation), u.scale * u.gain});
    of_rows_.clear();
    for (const Part& part : parts_) {
        const double between = mixed(part.node).mobility;
        const std::size_t m = multipliers_[part.row];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto d = static_cast<int>(axis);
            const double moved =
                porosities_[part.node] * (share(part.node, axis).mobility * part.coefficients[d + 2] +
                                          between * part.coefficients[3 - d]);
            if (moved != 0.0)
                of_rows_.push_back({number(part.node), number(axis), number(m), scale_[m] * moved});
        }
    }
}

FluxParts StiffResponse::flux_parts(std::size_t node) const
{
    FluxParts parts{own_x_[node] + own_y_[node]};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const Unknown* u = unknown(node, axis);
        if (u == nullptr || u->node != node) continue; // held, or tied to another
        const double mobility = 1.0 / share(node, axis).mass;
        parts += {0.0, u->gain * u->gain * mobility, mobility};
    }
    return parts;
}

void StiffResponse::answer_pressure(const Scalars& force_x, const Scalars& force_y, Scalars& flux_x,
                                    Scalars& flux_y)
{
    const Scalars* const forces[] = {&force_x, &force_y};
    Scalars* const fluxes[] = {&flux_x, &flux_y};
    std::fill(vector_.begin(), vector_.end(), 0.0);
    for (const Exchange& e : of_grains_) vector_[e.equation] = e.factor * (*forces[e.axis])[e.node];
    for (const MixedShare& of : mixed_) {
        const Unknown &x = *unknown(of.node, 0), &y = *unknown(of.node, 1);
        const double gain = porosities_[of.node] * of.share.carried;
        vector_[x.equation] += x.scale * gain * force_y[of.node];
        vector_[y.equation] += y.scale * gain * force_x[of.node];
    }
    for (const Exchange& e : of_rows_) vector_[e.equation] -= e.factor * (*forces[e.axis])[e.node];
    std::visit([&](const auto& factor) { solve_with(factor, vector_); }, factor_);
    for (std::size_t i = 0; i < own_x_.size(); ++i) {
        flux_x[i] = own_x_[i] * force_x[i];
        flux_y[i] = own_y_[i] * force_y[i];
    }
    for (const Exchange& e : of_grains_) (*fluxes[e.axis])[e.node] += e.factor * vector_[e.equation];
    for (const MixedShare& of : mixed_) {
        const Unknown &x = *unknown(of.node, 0), &y = *unknown(of.node, 1);
        const double n = porosities_[of.node], gain = n * of.share.carried, own = n * n * of.share.mobility;
        flux_x[of.node] += gain * y.scale * vector_[y.equation] + own * force_y[of.node];
        flux_y[of.node] += gain * x.scale * vector_[x.equation] + own * force_x[of.node];
    }
    for (const Exchange& e : of_rows_) (*fluxes[e.axis])[e.node] -= e.factor * vector_[e.equation];
}

} // namespace quicksand
