// Outlines and quadrilaterals from the elements of a mesh.
//
// MSH 2.2 carries no topology, so outlines are the element edges that occur once; MSH 4.1 is read alike.
#include "geometry/drawing/gmsh_model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace quicksand {

namespace {

using Node = std::size_t;
using Element = std::vector<Node>; // corner nodes

/// Positive where the corners run counter-clockwise.
double element_sense(const Element& element, const NodeTable& nodes)
{
    Polyline ring;
    for (const Node node : element) ring.push_back(nodes.place(node));
    return twice_signed_area(ring);
}

/// The corner nodes of a group's elements; those of surfaces counter-clockwise.
std::vector<Element> collect_elements(int dimension, const PhysicalGroup& group, const NodeTable& nodes)
{
    std::vector<Element> elements;
    for (const int entity : group.entities) {
        std::vector<int> types;
        std::vector<std::vector<std::size_t>> tags, node_tags;
        gmsh::model::mesh::getElements(types, tags, node_tags, dimension, entity);
        for (std::size_t t = 0; t < types.size(); ++t) {
            std::string name;
            int element_dimension = 0, order = 0, all_nodes = 0, corners = 0;
            std::vector<double> local;
            gmsh::model::mesh::getElementProperties(types[t], name, element_dimension, order, all_nodes,
                                                    local, corners);
            for (std::size_t e = 0; e < tags[t].size(); ++e) {
                Element element;
                for (int k = 0; k < corners; ++k) {
                    const std::size_t at =
                        e * static_cast<std::size_t>(all_nodes) + static_cast<std::size_t>(k);
                    element.push_back(nodes.node(node_tags[t][at]));
                }
                elements.push_back(std::move(element));
            }
        }
    }
    if (dimension == 2) {
        for (Element& element : elements) {
            if (element_sense(element, nodes) < 0.0) std::reverse(element.begin(), element.end());
        }
    }
    return elements;
}

using RimEdges = std::multimap<Node, Node>; // start to end, the elements on the left

RimEdges find_rim(const std::vector<Element>& elements)
{
    std::map<std::pair<Node, Node>, int> uses;
    for (const Element& element : elements) {
        for (std::size_t k = 0; k < element.size(); ++k) {
            const Node a = element[k], b = element[(k + 1) % element.size()];
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
    }
    RimEdges rim;
    for (const Element& element : elements) {
        for (std::size_t k = 0; k < element.size(); ++k) {
            const Node a = element[k], b = element[(k + 1) % element.size()];
            if (uses[{std::min(a, b), std::max(a, b)}] == 1) rim.emplace(a, b);
        }
    }
    return rim;
}

/// Of the rim edges that leave `at`, the first one met when turning through the elements. Where two parts
/// touch in one node this keeps their rings apart.
RimEdges::iterator next_edge(RimEdges& rim, Node from, Node at, const NodeTable& nodes)
{
    const auto [first, last] = rim.equal_range(at);
    const Point3 &centre = nodes.place(at), &back = nodes.place(from);
    const double back_angle = std::atan2(back[1] - centre[1], back[0] - centre[0]);
    auto best = rim.end();
    double least_turn = 10.0;
    for (auto edge = first; edge != last; ++edge) {
        const Point3& ahead = nodes.place(edge->second);
        double turn = back_angle - std::atan2(ahead[1] - centre[1], ahead[0] - centre[0]);
        if (turn <= 0.0) turn += 2.0 * std::numbers::pi;
        if (turn >= least_turn) continue;
        least_turn = turn;
        best = edge;
    }
    return best;
}

} // namespace

NodeTable::NodeTable()
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters);
    std::map<Point3, Node> places;
    for (std::size_t k = 0; k < tags.size(); ++k) {
        const Point3 place = {coordinates[3 * k], coordinates[3 * k + 1], coordinates[3 * k + 2]};
        const Node node = places.emplace(place, tags[k]).first->second;
        node_of_tag_[tags[k]] = node;
        place_of_node_[node] = place;
    }
}

std::vector<Polyline> outline_elements(const PhysicalGroup& surfaces, const NodeTable& nodes)
{
    RimEdges rim = find_rim(collect_elements(2, surfaces, nodes));
    std::vector<Polyline> rings;
    while (!rim.empty()) {
        const Node start = rim.begin()->first;
        Node from = start, at = rim.begin()->second;
        Polyline ring = {nodes.place(start)};
        rim.erase(rim.begin());
        while (at != start) {
            ring.push_back(nodes.place(at));
            const auto edge = next_edge(rim, from, at, nodes);
            if (edge == rim.end()) throw "the elements of \"" + surfaces.name + "\" have no closed outline";
            from = at;
            at = edge->second;
            rim.erase(edge);
        }
        rings.push_back(std::move(ring));
    }
    return rings;
}

std::vector<Polyline> chords_of_elements(const PhysicalGroup& curves, const NodeTable& nodes)
{
    std::vector<Polyline> chords;
    for (const Element& element : collect_elements(1, curves, nodes)) {
        chords.push_back({nodes.place(element.at(0)), nodes.place(element.at(1))});
    }
    return chords;
}

std::vector<Quad> quads_of_elements(const PhysicalGroup& surfaces, const NodeTable& nodes)
{
    std::vector<Quad> quads;
    for (const Element& element : collect_elements(2, surfaces, nodes)) {
        std::vector<Point3> corners;
        for (const Node node : element) corners.push_back(nodes.place(node));
        if (corners.size() == 4) {
            quads.push_back({corners[0], corners[1], corners[2], corners[3]});
            continue;
        }
        Point3 centre;
        std::array<Point3, 3> middles;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            centre[axis] = (corners.at(0)[axis] + corners.at(1)[axis] + corners.at(2)[axis]) / 3.0;
            for (std::size_t k = 0; k < 3; ++k)
                middles[k][axis] = 0.5 * (corners[k][axis] + corners[(k + 1) % 3][axis]);
        }
        for (std::size_t k = 0; k < 3; ++k)
            quads.push_back({corners[k], middles[k], centre, middles[(k + 2) % 3]});
    }
    return quads;
}

} // namespace quicksand
