#include "solver/walls/wall_contacts.hpp"

#include "solver/boundaries/wall_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double least_length = 1e-9; // of a contact that counts [cells]

/// Places along a segment, from 0 to 1, where it crosses grid lines, with both ends.
std::vector<double> cut_at_grid_lines(const BackgroundGrid& grid, const Segment& segment)
{
    const Vector2 from = grid.cells_from_rim(segment.start), to = grid.cells_from_rim(segment.end);
    std::vector<double> cuts = {0.0, 1.0};
    for (int axis = 0; axis < 2; ++axis) {
        const double way = to[axis] - from[axis];
        if (std::abs(way) < on_wall) continue;
        const double low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
        for (double line = std::ceil(low); line <= high; line += 1.0) {
            const double t = (line - from[axis]) / way;
            if (t > 0.0 && t < 1.0) cuts.push_back(t);
        }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

/// Call add(node, int N_i ds, int N_i t ds) for the nodes along a segment, t from 0 to 1 along it; what lies
/// outside the grid is left out.
template <class Add>
void integrate_along(const BackgroundGrid& grid, const Segment& segment, Add&& add)
{
    const double length = (segment.end - segment.start).norm();
    const std::vector<double> cuts = cut_at_grid_lines(grid, segment);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = 0.5 * (cuts[k] + cuts[k + 1]), part = cuts[k + 1] - cuts[k];
        if (part * length < least_length * grid.cell_size) continue;
        const auto place = [&](double t) {
            return grid.cells_from_rim(segment.start + t * (segment.end - segment.start));
        };
        const Vector2 centre = place(middle);
        if ((centre.array() < 0.0).any() || centre.x() >= grid.all_cells_x() ||
            centre.y() >= grid.all_cells_y())
            continue;
        // a curve along a grid line belongs to either cell: the nodes beside it have the value zero
        const int i = static_cast<int>(centre.x()), j = static_cast<int>(centre.y());
        for (const double gauss : {-1.0, 1.0}) { // exact for the quadratic N along a straight line
            const double t = middle + 0.5 * part * gauss / std::sqrt(3.0), weight = 0.5 * part * length;
            const Vector2 local = place(t) - Vector2(i, j);
            for (int b = 0; b < 2; ++b) {
                for (int a = 0; a < 2; ++a) {
                    const double N =
                        (a == 0 ? 1.0 - local.x() : local.x()) * (b == 0 ? 1.0 - local.y() : local.y());
                    add(grid.node_index(i + a, j + b), weight * N, weight * N * t);
                }
            }
        }
    }
}

/// One contact a node and chain, or node and direction: the sums of all, in the order of the nodes.
template <class Contact, class IsSame, class Merge>
void merge_contacts(std::vector<Contact>& contacts, double least, IsSame&& is_same, Merge&& merge)
{
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.node < b.node; });
    std::vector<Contact> merged;
    for (const Contact& contact : contacts) {
        auto same = merged.rbegin();
        while (same != merged.rend() && same->node == contact.node && !is_same(*same, contact)) ++same;
        if (same != merged.rend() && same->node == contact.node) {
            merge(*same, contact);
        } else {
            merged.push_back(contact);
        }
    }
    std::erase_if(merged, [&](const Contact& contact) { return contact.length < least; });
    contacts = std::move(merged);
}

/// Where a wall is and how it moves.
struct WallPlace {
    Vector2 displacement = Vector2::Zero(); // [m]
    Vector2 velocity = Vector2::Zero(),
            last_velocity = Vector2::Zero(); // over the step and that before [m/s]
};

WallPlace place_of(const Problem& problem, const SoilCondition& soil, const Segment& drawn, bool shaking,
                   const StepTimes& times)
{
    WallPlace wall;
    if (!moves(soil)) return wall;
    wall.displacement =
        displacement_of(soil, drawn, shaking && problem.strain == StrainForm::large ? times.begin : 0.0);
    if (!shaking) return wall;
    wall.velocity = velocity_of(soil, drawn, times.begin, times.length);
    if (times.last > 0.0) wall.last_velocity = velocity_of(soil, drawn, times.begin - times.last, times.last);
    return wall;
}

void add_edge(const Problem& problem, const NodeConditions& conditions, std::size_t chain,
              const ChainEdge& edge, const WallPlace& wall, std::vector<WallContact>& contacts)
{
    const Segment present{edge.drawn.start + wall.displacement, edge.drawn.end + wall.displacement};
    const Vector2 normal = outward_normal(edge.drawn);
    const double length = (present.end - present.start).norm();
    integrate_along(problem.grid, present, [&](std::size_t node, double weight, double moment) {
        contacts.push_back({conditions.master[node], chain, weight, edge.beyond ? 0.0 : weight,
                            edge.first * weight + length * moment, weight * normal, weight * wall.velocity,
                            weight * (wall.velocity - wall.last_velocity)});
    });
}

/// What brings a part to the lap of a closed chain on which the sum is [m].
double lap_between(const WallChain& chain, const WallContact& sum, const WallContact& part)
{
    if (!chain.closed) return 0.0;
    const double apart = part.s / part.length - sum.s / sum.length;
    return -chain.last * std::round(apart / chain.last);
}

/// Where a chain has a contact, from its sums: the mean arc length, or the number of the grid line across the
/// chain.
double place_along(const BackgroundGrid& grid, const WallChain& chain, const WallContact& sum)
{
    if (chain.line_axis >= 0)
        return std::round(grid.cells_from_rim(grid.node_position(sum.node))[chain.line_axis]);
    const double s = sum.s / sum.length;
    return chain.closed ? s - chain.last * std::floor(s / chain.last) : s;
}

} // namespace

WallContacts find_contacts(const Problem& problem, const SoilEdges& edges, const NodeConditions& conditions,
                           Stage stage, const StepTimes& times)
{
    WallContacts contacts;
    for (std::size_t c = 0; c < edges.chains.size(); ++c) {
        for (const ChainEdge& edge : edges.chains[c].edges) {
            const Boundary& boundary = problem.boundaries[edge.boundary];
            const WallPlace wall = place_of(problem, boundary.soil, boundary.segments[edge.segment],
                                            stage == Stage::shaking, times);
            add_edge(problem, conditions, c, edge, wall, contacts.walls);
        }
    }
    for (const Segment& edge : edges.others) {
        const Vector2 normal = outward_normal(edge);
        integrate_along(problem.grid, edge, [&](std::size_t node, double weight, double) {
            contacts.others.push_back({conditions.master[node], weight, normal});
        });
    }
    const double least = least_length * problem.grid.cell_size;
    merge_contacts(
        contacts.walls, least, [](const WallContact& a, const WallContact& b) { return a.chain == b.chain; },
        [&](WallContact& sum, const WallContact& part) {
            const double lap = lap_between(edges.chains[sum.chain], sum, part);
            sum.length += part.length;
            sum.drawn += part.drawn;
            sum.s += part.s + lap * part.length;
            sum.normal += part.normal;
            sum.velocity += part.velocity;
            sum.change += part.change;
        });
    for (WallContact& contact : contacts.walls) {
        contact.s = place_along(problem.grid, edges.chains[contact.chain], contact);
        contact.normal.normalize();
        contact.velocity /= contact.length;
        contact.change /= contact.length;
    }
    constexpr double one_direction = 0.999; // cosine [-]
    merge_contacts(
        contacts.others, least,
        [](const EdgeContact& a, const EdgeContact& b) { return a.normal.dot(b.normal) > one_direction; },
        [](EdgeContact& sum, const EdgeContact& part) { sum.length += part.length; });
    return contacts;
}

std::vector<NodeLength> lengths_along(const BackgroundGrid& grid, const Segment& segment)
{
    std::vector<NodeLength> lengths;
    integrate_along(grid, segment, [&](std::size_t node, double weight, double) {
        lengths.push_back({node, weight});
    });
    return lengths;
}

} // namespace quicksand
