#include "solver/walls/velocity_rows.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace quicksand {

namespace {

/// Added to the diagonal of ones where rows nearly repeat each other, as at corners and at the tips of
/// wedges: a pivot is then below `least_pivot`. The nodes are held by what such rows have in common; what
/// only their difference asks for is left free. It comes from parts of rows as small as 1e-4 and would hold
/// nodes that no wall holds.
constexpr double ridge = 1e-10, least_pivot = 1e-8;
/// A row acts on nothing where all of its nodes are held: its P is below this part of what free nodes would
/// give.
constexpr double least_response = 1e-14;

/// Axes along which an entry acts: 1 for x, 2 for y, 3 for both.
std::uint8_t axes_of(const NodeVelocities& c)
{
    return static_cast<std::uint8_t>((c[0] != 0.0 || c[2] != 0.0 ? 1 : 0) |
                                     (c[1] != 0.0 || c[3] != 0.0 ? 2 : 0));
}

/// beta^T R beta, beta = (1-n, n): flux per force of the pressure.
Eigen::Matrix2d pressure_compliance(const NodeInverse& R, double n)
{
    return (1.0 - n) * (1.0 - n) * R.topLeftCorner<2, 2>() +
           (1.0 - n) * n * (R.topRightCorner<2, 2>() + R.bottomLeftCorner<2, 2>()) +
           n * n * R.bottomRightCorner<2, 2>();
}

} // namespace

template <class Visit>
void VelocityRows::for_each_entry_of(std::size_t row, Visit&& visit) const
{
    const std::size_t last = end_of(row);
    for (std::size_t k = first_[row]; k < last; ++k) visit(k);
}

template <class Visit>
void VelocityRows::for_each_entry(Visit&& visit) const
{
    for (std::size_t r = 0; r < size(); ++r) for_each_entry_of(r, [&](std::size_t k) { visit(r, k); });
}

void VelocityRows::clear(std::size_t node_count)
{
    for (const std::size_t node : nodes_) place_of_node_[node] = -1;
    place_of_node_.resize(node_count, -1);
    nodes_.clear();
    values_.clear();
    first_.clear();
    entries_.clear();
    by_pressure_.clear();
}

void VelocityRows::begin_row(double value)
{
    values_.push_back(value);
    first_.push_back(entries_.size());
}

void VelocityRows::add(std::size_t node, const NodeVelocities& coefficients)
{
    std::int32_t& place = place_of_node_[node];
    if (place < 0) {
        place = static_cast<std::int32_t>(nodes_.size());
        nodes_.push_back(node);
    }
    entries_.push_back({static_cast<std::size_t>(place), coefficients});
}

bool VelocityRows::inverses_turn() const
{
    return std::any_of(inverses_.begin(), inverses_.end(), [](const NodeInverse& R) {
        return R(0, 1) != 0.0 || R(0, 3) != 0.0 || R(2, 1) != 0.0 || R(2, 3) != 0.0;
    });
}

void VelocityRows::find_pattern(bool turns, Factor& factor) const
{
    Pattern& pattern = factor.pattern;
    pattern.first = first_;
    pattern.turns = turns;
    pattern.places.clear();
    pattern.axes.clear();
    for (const Entry& entry : entries_) {
        pattern.places.push_back(entry.place);
        pattern.axes.push_back(axes_of(entry.coefficients));
    }

    std::vector<std::size_t> row_of(entries_.size());
    for_each_entry([&](std::size_t r, std::size_t k) { row_of[k] = r; });
    std::vector<std::vector<std::size_t>> of_node(nodes_.size()); // entries
    for (std::size_t k = 0; k < entries_.size(); ++k) of_node[entries_[k].place].push_back(k);

    // column by column; `below` are the rows whose products with the column's are not zero
    Eigen::SparseMatrix<double>& matrix = factor.matrix;
    const auto index = [](std::size_t r) { return static_cast<int>(r); };
    matrix.resize(index(size()), index(size()));
    pattern.products.clear();
    pattern.diagonal.clear();
    std::vector<int> inner, below;
    std::vector<std::size_t> target(size()); // of a row in the present column, among the matrix's values
    std::vector<std::size_t> seen(size(), size());
    for (std::size_t column = 0; column < size(); ++column) {
        const std::size_t first_product = pattern.products.size();
        below.assign(1, index(column));
        seen[column] = column;
        for_each_entry_of(column, [&](std::size_t b) {
            for (const std::size_t a : of_node[entries_[b].place]) {
                const std::size_t row = row_of[a];
                if (row < column || (!turns && (pattern.axes[a] & pattern.axes[b]) == 0)) continue;
                pattern.products.push_back({a, b, row});
                if (std::exchange(seen[row], column) != column) below.push_back(index(row));
            }
        });
        std::sort(below.begin(), below.end());
        matrix.outerIndexPtr()[column] = index(inner.size());
        pattern.diagonal.push_back(inner.size());
        for (const int row : below) {
            target[static_cast<std::size_t>(row)] = inner.size();
            inner.push_back(row);
        }
        for (std::size_t k = first_product; k < pattern.products.size(); ++k)
            pattern.products[k].target = target[pattern.products[k].target];
    }
    matrix.outerIndexPtr()[size()] = index(inner.size());
    matrix.resizeNonZeros(index(inner.size()));
    std::copy(inner.begin(), inner.end(), matrix.innerIndexPtr());
    factor.solver.analyzePattern(matrix);
}

bool VelocityRows::is_made_for_rows(const Pattern& pattern, bool turns) const
{
    if (pattern.first != first_ || pattern.places.size() != entries_.size() || pattern.turns != turns)
        return false;
    for (std::size_t k = 0; k < entries_.size(); ++k)
        if (entries_[k].place != pattern.places[k] || axes_of(entries_[k].coefficients) != pattern.axes[k])
            return false;
    return true;
}

void VelocityRows::choose_factor(bool turns)
{
    constexpr std::size_t most = 4; // nodes that hardly any soil touches come and go: patterns return
    std::erase_if(factors_, [](const auto& factor) { return factor.use_count() > 1; });
    auto chosen = std::find_if(factors_.begin(), factors_.end(),
                               [&](const auto& factor) { return is_made_for_rows(factor->pattern, turns); });
    if (chosen == factors_.end()) {
        if (factors_.size() < most) factors_.push_back(std::make_shared<Factor>());
        chosen = factors_.end() - 1;
        find_pattern(turns, **chosen);
    }
    std::rotate(factors_.begin(), chosen, chosen + 1);
}

void VelocityRows::fill_matrix()
{
    responses_.resize(entries_.size());
    Scalars own(size(), 0.0), of_free_nodes(size(), 0.0);
    for_each_entry([&](std::size_t r, std::size_t k) {
        const Entry& entry = entries_[k];
        responses_[k] = inverses_[entry.place] * entry.coefficients;
        own[r] += entry.coefficients.dot(responses_[k]);
        const NodeVelocities c = entry.coefficients, R = inverses_[entry.place].diagonal();
        // apart: where there is hardly any water it answers by other orders than the grains
        of_free_nodes[r] += c.head<2>().squaredNorm() * R.head<2>().maxCoeff() +
                            c.tail<2>().squaredNorm() * R.tail<2>().maxCoeff();
    });
    scale_.resize(size());
    for (std::size_t r = 0; r < size(); ++r)
        scale_[r] = own[r] > least_response * of_free_nodes[r] ? 1.0 / std::sqrt(own[r]) : 0.0;

    std::vector<NodeVelocities> coefficients(entries_.size()), responses(entries_.size()); // scaled
    for_each_entry([&](std::size_t r, std::size_t k) {
        coefficients[k] = scale_[r] * entries_[k].coefficients;
        responses[k] = scale_[r] * responses_[k];
    });
    Factor& factor = *factors_.front();
    double* values = factor.matrix.valuePtr();
    std::fill(values, values + factor.matrix.nonZeros(), 0.0);
    for (std::size_t r = 0; r < size(); ++r) values[factor.pattern.diagonal[r]] = scale_[r] > 0.0 ? 0.0 : 1.0;
    for (const Product& product : factor.pattern.products)
        values[product.target] += coefficients[product.a].dot(responses[product.b]);
}

bool VelocityRows::repeat() const
{
    return smallest_pivot_ < least_pivot;
}

void VelocityRows::factorise(std::vector<NodeInverse> inverses)
{
    inverses_ = std::move(inverses);
    smallest_pivot_ = 1.0;
    if (empty()) return;
    choose_factor(inverses_turn());
    fill_matrix();
    Factor& factor = *factors_.front();
    factor.solver.factorize(factor.matrix);
    smallest_pivot_ = factor.solver.info() == Eigen::Success ? factor.solver.vectorD().minCoeff() : 0.0;
    if (!repeat()) return;
    double* values = factor.matrix.valuePtr();
    for (const std::size_t diagonal : factor.pattern.diagonal) values[diagonal] += ridge;
    factor.solver.factorize(factor.matrix);
    if (factor.solver.info() != Eigen::Success)
        throw InternalError("the conditions at the walls cannot be factorised");
}

double VelocityRows::product(std::size_t row, const std::vector<NodeVelocities>& velocities) const
{
    double sum = 0.0;
    for_each_entry_of(
        row, [&](std::size_t k) { sum += entries_[k].coefficients.dot(velocities[entries_[k].place]); });
    return sum;
}

void VelocityRows::extrapolate(std::vector<NodeVelocities>& velocities) const
{
    for_each_follower([&](std::size_t row, std::size_t follower, int direction) {
        velocities[follower][direction] = 0.0;
        velocities[follower][direction] = -product(row, velocities);
    });
}

Scalars VelocityRows::products(const std::vector<NodeVelocities>& velocities) const
{
    Scalars result(size(), 0.0);
    for_each_entry([&](std::size_t r, std::size_t k) {
        result[r] += entries_[k].coefficients.dot(velocities[entries_[k].place]);
    });
    return result;
}

Scalars VelocityRows::solve(Scalars right_hand_side) const
{
    Eigen::Map<Eigen::VectorXd> vector(right_hand_side.data(), static_cast<Eigen::Index>(size()));
    const Eigen::Map<const Eigen::VectorXd> scale(scale_.data(), static_cast<Eigen::Index>(size()));
    vector = scale.cwiseProduct(factors_.front()->solver.solve(scale.cwiseProduct(vector)));
    return right_hand_side;
}

Scalars VelocityRows::misses(bool to_zero, const std::vector<NodeVelocities>& velocities) const
{
    Scalars missing = products(velocities);
    if (to_zero) return missing;
    for (std::size_t r = 0; r < size(); ++r) missing[r] -= values_[r];
    return missing;
}

std::vector<NodeVelocities> VelocityRows::impulses(const Scalars& multipliers) const
{
    std::vector<NodeVelocities> result(nodes_.size(), NodeVelocities::Zero());
    for_each_entry([&](std::size_t r, std::size_t k) {
        result[entries_[k].place] -= multipliers[r] * entries_[k].coefficients;
    });
    return result;
}

Scalars VelocityRows::correct(bool to_zero, std::vector<NodeVelocities>& velocities) const
{
    Scalars sum(size(), 0.0);
    if (empty()) return sum;
    const int times = repeat() ? 2 : 1; // the second takes out what the ridge has left
    for (int time = 0; time < times; ++time) {
        const Scalars multipliers = solve(misses(to_zero, velocities));
        for (std::size_t r = 0; r < size(); ++r) sum[r] += multipliers[r];
        for_each_entry([&](std::size_t r, std::size_t k) {
            velocities[entries_[k].place] -= multipliers[r] * responses_[k];
        });
    }
    return sum;
}

double VelocityRows::softness(std::size_t row) const
{
    return repeat() && scale_[row] > 0.0 ? ridge / (scale_[row] * scale_[row]) : 0.0;
}

void VelocityRows::hold(std::vector<NodeVelocities>& velocities) const
{
    correct(false, velocities);
}

Scalars VelocityRows::project(std::vector<NodeVelocities>& velocities) const
{
    return correct(true, velocities);
}

void VelocityRows::set_porosities(const Scalars& porosities)
{
    porosities_ = porosities;
    by_pressure_.resize(entries_.size());
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        const double n = porosities_[entries_[k].place];
        by_pressure_[k] = (1.0 - n) * responses_[k].head<2>() + n * responses_[k].tail<2>();
    }
    compliances_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        compliances_[i] = pressure_compliance(inverses_[i], porosities_[i]);
}

HeldNode VelocityRows::held_node(std::size_t place, const NodeVelocities& c) const
{
    const NodeVelocities velocities = inverses_[place] * c;
    const double n = porosities_[place];
    return {nodes_[place], c, velocities, (1.0 - n) * velocities.head<2>() + n * velocities.tail<2>()};
}

std::vector<HeldRow> VelocityRows::held_rows() const
{
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::array<std::size_t, 4>> followed_by(nodes_.size(), {none, none, none, none}); // rows
    for_each_follower([&](std::size_t row, std::size_t follower, int direction) {
        followed_by[follower][static_cast<std::size_t>(direction)] = row;
    });
    std::vector<HeldRow> rows;
    for (std::size_t r = 0; r < first_follower_; ++r) {
        if (scale_[r] == 0.0) continue;
        std::map<std::size_t, NodeVelocities> folded; // by place
        const auto add = [&](std::size_t place, int d, double value) {
            folded.try_emplace(place, NodeVelocities::Zero()).first->second[d] += value;
        };
        for_each_entry_of(r, [&](std::size_t k) {
            for (int d = 0; d < 4; ++d) {
                const double c = entries_[k].coefficients[d];
                const std::size_t of = followed_by[entries_[k].place][static_cast<std::size_t>(d)];
                if (of == none) {
                    add(entries_[k].place, d, c);
                } else {
                    for (std::size_t m = first_[of] + 1; m < end_of(of); ++m)
                        add(entries_[m].place, d, -c * entries_[m].coefficients[d]);
                }
            }
        });
        HeldRow& row = rows.emplace_back();
        for (const auto& [place, c] : folded) row.nodes.push_back(held_node(place, c));
    }
    for_each_follower([&](std::size_t r, std::size_t follower, int direction) {
        if (direction >= 2) return; // of the water
        HeldRow& row = rows.emplace_back();
        row.compliance = inverses_[follower](direction, direction);
        for (std::size_t k = first_[r] + 1; k < end_of(r); ++k)
            row.nodes.push_back(held_node(entries_[k].place, entries_[k].coefficients));
    });
    return rows;
}

std::vector<Eigen::Matrix2d> VelocityRows::local_compliances() const
{
    std::vector<Eigen::Matrix2d> compliances = compliances_;
    for_each_follower([&](std::size_t row, std::size_t follower, int direction) {
        if (direction != 0) return; // one row tells: those of the other directions are alike
        Eigen::Matrix2d of_followed = Eigen::Matrix2d::Zero();
        for (std::size_t k = first_[row] + 1; k < end_of(row); ++k) {
            const double weight = entries_[k].coefficients[0];
            of_followed += weight * weight * compliances[entries_[k].place];
        }
        compliances[follower] = of_followed;
    });
    return compliances;
}

void VelocityRows::respond_to_pressure(const std::vector<Vector2>& force, std::vector<Vector2>& flux) const
{
    for (std::size_t i = 0; i < nodes_.size(); ++i) flux[i] = compliances_[i] * force[i];
    Scalars missing(size(), 0.0);
    for_each_entry(
        [&](std::size_t r, std::size_t k) { missing[r] += by_pressure_[k].dot(force[entries_[k].place]); });
    const Scalars multipliers = solve(std::move(missing));
    for_each_entry(
        [&](std::size_t r, std::size_t k) { flux[entries_[k].place] -= multipliers[r] * by_pressure_[k]; });
}

} // namespace quicksand
