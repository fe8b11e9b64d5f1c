#include "solver/measure/nodal_fields.hpp"

#include "solver/base/slope_fit.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/particles/cell_lists.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace quicksand {

namespace {

/// The cells that a point lies in or at the edge of, wherever it may lie; of a point on a grid line both.
std::vector<PlaceInCell> cells_at(const BackgroundGrid& grid, const Vector2& point)
{
    constexpr double rounding = 1e-9; // [cells]
    const Vector2 cells = grid.cells_from_rim(point);
    const bool in_grid = cells.x() >= 0.0 && cells.y() >= 0.0 && cells.x() <= grid.all_cells_x() &&
                         cells.y() <= grid.all_cells_y();
    if (!in_grid) return {};
    const auto along = [&](double place, int count) {
        std::vector<int> numbers;
        for (const double beside : {rounding, -rounding}) {
            const int number = std::clamp(static_cast<int>(std::floor(place + beside)), 0, count - 1);
            if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
        }
        return numbers;
    };
    std::vector<PlaceInCell> places;
    for (const int j : along(cells.y(), grid.all_cells_y()))
        for (const int i : along(cells.x(), grid.all_cells_x()))
            places.push_back({i, j, cells.x() - i, cells.y() - j});
    return places;
}

/// Node k of the four of a cell, row by row.
std::size_t node_of(const BackgroundGrid& grid, const PlaceInCell& cell, int k)
{
    return grid.node_index(cell.i + k % 2, cell.j + k / 2);
}

/// Which nodes are asked for.
using NodeMask = std::vector<std::uint8_t>;

/// The columns and rows of nodes from the first to the last that is asked for; none: last < first.
struct NodeRange {
    int first_i = 0, last_i = -1, first_j = 0, last_j = -1;
};

NodeRange range_of(const BackgroundGrid& grid, const NodeMask& wanted)
{
    NodeRange range{grid.nodes_x(), -1, grid.nodes_y(), -1};
    for (int j = 0; j < grid.nodes_y(); ++j) {
        for (int i = 0; i < grid.nodes_x(); ++i) {
            if (wanted[grid.node_index(i, j)] == 0) continue;
            range = {std::min(range.first_i, i), std::max(range.last_i, i), std::min(range.first_j, j), j};
        }
    }
    return range;
}

/// A particle's present domain within its reach.
struct PresentDomain {
    ParallelogramDomain whole;
    const CutDomain* shape = nullptr; // of a cut domain
    std::vector<Vector2> corners;     // of a cut domain [m]
    Vector2 reach;                    // greatest distance from the centre along the axes [m]
};

PresentDomain present_domain(const Problem& problem, const Particles& particles, std::size_t p)
{
    const double h = problem.grid.cell_size;
    PresentDomain domain;
    domain.whole = {particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
    domain.shape = problem.cut_domains.find(particles.identifier[p]);
    if (domain.shape == nullptr) {
        limit_domain(h, domain.whole);
        domain.reach = domain.whole.half_edge_1.cwiseAbs() + domain.whole.half_edge_2.cwiseAbs();
        return domain;
    }
    domain.corners = domain_polygon(problem.cut_domains, particles, p);
    limit_polygon(h, domain.whole.centre, domain.corners);
    domain.reach = Vector2::Zero();
    bool finite = true;
    for (const Vector2& corner : domain.corners) {
        const Vector2 apart = (corner - domain.whole.centre).cwiseAbs();
        domain.reach = domain.reach.cwiseMax(apart);
        finite = finite && apart.allFinite();
    }
    if (!finite) domain.reach.setConstant(std::numeric_limits<double>::quiet_NaN()); // reaches no node
    return domain;
}

/// Whether a domain may give weight to a node that is asked for.
bool may_reach(const BackgroundGrid& grid, const PresentDomain& domain, const NodeMask& wanted,
               const NodeRange& range)
{
    constexpr double rounding = 1e-6; // [cells]
    const Vector2 centre = grid.cells_from_rim(domain.whole.centre);
    const Vector2 lower = centre - domain.reach / grid.cell_size - Vector2::Constant(rounding),
                  upper = centre + domain.reach / grid.cell_size + Vector2::Constant(1.0 + rounding);
    const bool meets_range = upper.x() >= range.first_i && upper.y() >= range.first_j &&
                             lower.x() < range.last_i + 1 && lower.y() < range.last_j + 1;
    if (!meets_range) return false;
    const int last_i = std::min(static_cast<int>(upper.x()), range.last_i),
              last_j = std::min(static_cast<int>(upper.y()), range.last_j);
    for (int j = std::max(range.first_j, static_cast<int>(lower.y())); j <= last_j; ++j) {
        for (int i = std::max(range.first_i, static_cast<int>(lower.x())); i <= last_i; ++i)
            if (wanted[grid.node_index(i, j)] != 0) return true;
    }
    return false;
}

/// Weights of a domain that may lie partly outside the grid, as displaced domains of small strain do: the
/// stencil's columns and rows then lie outside, too.
void evaluate_anywhere(const BackgroundGrid& grid, const PresentDomain& domain, NodeStencil& stencil)
{
    const Vector2 lower = grid.cells_from_rim(domain.whole.centre) - domain.reach / grid.cell_size;
    const int columns = std::max(0, static_cast<int>(std::ceil(-lower.x()))),
              rows = std::max(0, static_cast<int>(std::ceil(-lower.y())));
    BackgroundGrid around = grid;
    around.origin -= grid.cell_size * Vector2(columns, rows);
    if (domain.shape == nullptr)
        evaluate_cpdi(around, domain.whole, stencil);
    else
        evaluate_polygon(around, *domain.shape, domain.corners, stencil);
    stencil.column -= columns;
    stencil.row -= rows;
}

NodalFields empty_fields(const BackgroundGrid& grid, const Particles& particles)
{
    NodalFields fields;
    fields.volume.assign(grid.node_count(), 0.0);
    for (const Quantity* quantity : quantities_of(on_nodes)) {
        if (!have(particles, *quantity)) continue;
        fields.fields.push_back({quantity, std::vector<Scalars>(component_count(quantity->form),
                                                                Scalars(grid.node_count(), 0.0))});
    }
    return fields;
}

/// What a node's particles are besides their values: their mean place, and the part of them that is wet.
struct NodeSoil {
    Vector2 place = Vector2::Zero(); // [m]
    double wet = 0.0;                // of their volume [-]
};
constexpr std::size_t numbers_of_soil = 3;

/// What the particle is for a NodeSoil and its values of all fields, one after the other.
void take_values(const NodalFields& fields, const Problem& problem, const Particles& particles, std::size_t p,
                 std::vector<double>& values)
{
    values[0] = particles.position.x[p], values[1] = particles.position.y[p];
    values[2] = is_wet(problem.materials[static_cast<std::size_t>(particles.material[p])]) ? 1.0 : 0.0;
    std::size_t k = numbers_of_soil;
    for (const NodalField& field : fields.fields) {
        const Quantity& quantity = *field.quantity;
        const ParticleValue value = quantity.averaged != nullptr ? quantity.averaged : quantity.value;
        const QuantityValues of_particle = value(problem, particles, p);
        for (std::size_t c = 0; c < field.components.size(); ++c) values[k++] = of_particle[c];
    }
}

/// Call work(neighbour) for the nodes of the 3 x 3 around a node, itself left out.
template <class Work>
void for_each_around(const BackgroundGrid& grid, std::size_t node, Work&& work)
{
    const auto columns = static_cast<std::size_t>(grid.nodes_x());
    const int i = static_cast<int>(node % columns), j = static_cast<int>(node / columns);
    for (int b = std::max(0, j - 1); b <= std::min(j + 1, grid.nodes_y() - 1); ++b)
        for (int a = std::max(0, i - 1); a <= std::min(i + 1, grid.nodes_x() - 1); ++a)
            if (a != i || b != j) work(grid.node_index(a, b));
}

/// The nodes that are asked for and those around them.
NodeMask with_neighbours(const BackgroundGrid& grid, const NodeMask& wanted)
{
    NodeMask grown = wanted;
    for (std::size_t node = 0; node < wanted.size(); ++node)
        if (wanted[node] != 0) for_each_around(grid, node, [&](std::size_t other) { grown[other] = 1; });
    return grown;
}

/// Sums over the particles at the nodes that are asked for, the volume first: those of a node lie side by
/// side, since a particle gives to all of them.
class NodeSums {
public:
    NodeSums(const BackgroundGrid& grid, const NodeMask& wanted, std::size_t components)
        : grid_(grid), width_(components + 1), first_(wanted.size(), none)
    {
        std::size_t count = 0;
        for (std::size_t node = 0; node < wanted.size(); ++node)
            if (wanted[node] != 0) first_[node] = width_ * count++;
        sums_.assign(width_ * count, 0.0);
    }

    void add(const NodeStencil& stencil, double volume, const std::vector<double>& values)
    {
        const int first_i = std::max(0, stencil.column), first_j = std::max(0, stencil.row);
        const int end_i = std::min(stencil.column + stencil.width, grid_.nodes_x()),
                  end_j = std::min(stencil.row + stencil.height, grid_.nodes_y());
        for (int j = first_j; j < end_j; ++j) {
            const int row = (j - stencil.row) * stencil.width - stencil.column;
            for (int i = first_i; i < end_i; ++i) {
                const std::size_t first = first_[grid_.node_index(i, j)];
                if (first == none) continue;
                const double weight = stencil.weights[row + i].value * volume;
                double* const sum = sums_.data() + first;
                sum[0] += weight;
                for (std::size_t f = 0; f < values.size(); ++f) sum[1 + f] += weight * values[f];
            }
        }
    }

    void find_means(std::vector<NodeSoil>& soils, NodalFields& fields) const
    {
        for (std::size_t node = 0; node < first_.size(); ++node) {
            if (first_[node] == none || sums_[first_[node]] <= 0.0) continue;
            const double* sum = sums_.data() + first_[node];
            fields.volume[node] = sum[0];
            soils[node] = {Vector2(sum[1], sum[2]) / sum[0], sum[3] / sum[0]};
            sum += 1 + numbers_of_soil;
            for (NodalField& field : fields.fields)
                for (Scalars& component : field.components) component[node] = *sum++ / fields.volume[node];
        }
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    const BackgroundGrid& grid_;
    std::size_t width_;              // of a node's sums
    std::vector<std::size_t> first_; // of every node's sums
    std::vector<double> sums_;
};

/// Nodes that are not asked for have nothing.
void leave_out(const NodeMask& wanted, NodalFields& fields)
{
    for (std::size_t node = 0; node < wanted.size(); ++node) {
        if (wanted[node] != 0) continue;
        fields.volume[node] = 0.0;
        for (NodalField& field : fields.fields)
            for (Scalars& component : field.components) component[node] = 0.0;
    }
}

bool is_water_pressure(const Quantity& quantity)
{
    return quantity.of == QuantityOf::wet_soil && quantity.unit == "Pa";
}

/// Whether the slope of a quantity tells it a part of a cell farther on: motion and the pressure of the
/// water. Stresses and states of the soil scatter.
bool is_smooth(const Quantity& quantity)
{
    return quantity.form == QuantityForm::vector || is_water_pressure(quantity);
}

/// A mean, brought from the mean place of what it is the mean of to the node: by the slope of the plane
/// through it and the means around that count(other), each at its own mean place.
template <class Count>
double value_at_node(const BackgroundGrid& grid, std::size_t node, const std::vector<NodeSoil>& soils,
                     const Scalars& volume, const Scalars& means, Count&& count)
{
    // times the largest difference of the means: linear fields have 2 where soil ends .3 cells above a line
    constexpr double farthest = 2.0;
    PlaneFit fit;
    double most = 0.0;
    for_each_around(grid, node, [&](std::size_t other) {
        if (!(volume[other] > 0.0) || !count(other)) return;
        const double difference = means[other] - means[node];
        fit.add(volume[other] / volume[node], soils[other].place - soils[node].place, difference);
        most = std::max(most, farthest * std::abs(difference));
    });
    const double change = fit.slope(grid.cell_size).dot(grid.node_position(node) - soils[node].place);
    return means[node] + std::clamp(change, -most, most);
}

/// Bring the means of nodes at the rim of the soil, whose particles lie on one side, to the nodes themselves:
/// they are exact for linear fields. Water has no pressure in soil that is not wet: pressures have no slope
/// there.
void move_to_nodes(const BackgroundGrid& grid, const NodeMask& wanted, const std::vector<NodeSoil>& soils,
                   NodalFields& fields)
{
    constexpr double rounding = 1e-3;      // [cells]
    constexpr double all_wet = 1.0 - 1e-9; // [-]
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < wanted.size(); ++node)
        if (wanted[node] != 0 && fields.volume[node] > 0.0 &&
            (soils[node].place - grid.node_position(node)).norm() > rounding * grid.cell_size)
            nodes.push_back(node);
    for (NodalField& field : fields.fields) {
        if (!is_smooth(*field.quantity)) continue;
        const bool of_water = is_water_pressure(*field.quantity);
        const auto counts = [&](std::size_t node) { return !of_water || soils[node].wet > all_wet; };
        for (Scalars& component : field.components) {
            Scalars values;
            for (const std::size_t node : nodes)
                values.push_back(counts(node)
                                     ? value_at_node(grid, node, soils, fields.volume, component, counts)
                                     : component[node]);
            for (std::size_t k = 0; k < nodes.size(); ++k) component[nodes[k]] = values[k];
        }
    }
}

NodalFields average(const Problem& problem, const Particles& particles, const NodeMask& wanted)
{
    const BackgroundGrid& grid = problem.grid;
    NodalFields fields = empty_fields(grid, particles);
    std::size_t components = numbers_of_soil;
    for (const NodalField& field : fields.fields) components += field.components.size();

    const NodeMask summed = with_neighbours(grid, wanted);
    NodeSums sums(grid, summed, components);
    NodeStencil stencil;
    std::vector<double> values(components);
    const NodeRange range = range_of(grid, summed);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const PresentDomain domain = present_domain(problem, particles, p);
        if (!may_reach(grid, domain, summed, range)) continue;
        evaluate_anywhere(grid, domain, stencil);
        take_values(fields, problem, particles, p, values);
        sums.add(stencil, particles.volume[p], values);
    }
    std::vector<NodeSoil> soils(grid.node_count());
    sums.find_means(soils, fields);
    move_to_nodes(grid, wanted, soils, fields);
    leave_out(wanted, fields);
    return fields;
}

} // namespace

const NodalField* NodalFields::find(std::string_view name) const
{
    const auto found = std::find_if(fields.begin(), fields.end(),
                                    [&](const NodalField& field) { return field.quantity->name == name; });
    return found == fields.end() ? nullptr : &*found;
}

NodalField* NodalFields::find(std::string_view name)
{
    return const_cast<NodalField*>(std::as_const(*this).find(name));
}

NodalFields nodal_fields(const Problem& problem, const Particles& particles)
{
    return average(problem, particles, NodeMask(problem.grid.node_count(), 1));
}

NodalFields nodal_fields_at(const Problem& problem, const Particles& particles,
                            const std::vector<Vector2>& points)
{
    NodeMask wanted(problem.grid.node_count(), 0);
    for (const Vector2& point : points)
        for (const PlaceInCell& cell : cells_at(problem.grid, point))
            for (int k = 0; k < 4; ++k) wanted[node_of(problem.grid, cell, k)] = 1;
    return average(problem, particles, wanted);
}

PointWeights point_weights(const BackgroundGrid& grid, const NodalFields& fields, const Vector2& point)
{
    PointWeights result;
    for (const PlaceInCell& cell : cells_at(grid, point)) {
        result.inside = true;
        for (int k = 0; k < 4; ++k) {
            result.node[k] = node_of(grid, cell, k);
            result.weight[k] =
                (k % 2 == 0 ? 1.0 - cell.xi : cell.xi) * (k / 2 == 0 ? 1.0 - cell.eta : cell.eta);
            result.inside = result.inside && fields.volume[result.node[k]] > 0.0;
        }
        if (result.inside) break;
    }
    return result;
}

} // namespace quicksand
