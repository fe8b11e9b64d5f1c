#include "solver/boundaries/boundary_pieces.hpp"

#include "solver/base/cross_product.hpp"
#include "solver/base/failure.hpp"
#include "solver/interpolation/cpdi.hpp"
#include "solver/interpolation/cpdi2.hpp"
#include "solver/interpolation/gimp.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

/// The bilinear functions of the domain's corners at local coordinates.
std::array<double, 4> corner_fractions(const Vector2& local)
{
    const double xi = local.x(), eta = local.y();
    return {0.25 * (1.0 - xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 + eta),
            0.25 * (1.0 - xi) * (1.0 + eta)};
}

Vector2 at_local(const std::array<Vector2, 4>& corners, const Vector2& local)
{
    const std::array<double, 4> fraction = corner_fractions(local);
    return fraction[0] * corners[0] + fraction[1] * corners[1] + fraction[2] * corners[2] +
           fraction[3] * corners[3];
}

/// Local coordinates of a point: Newton's method, done after one iteration in a parallelogram.
Vector2 local_coordinates(const std::array<Vector2, 4>& x, const Vector2& point)
{
    const Vector2 along_1 = 0.25 * (x[1] + x[2] - x[0] - x[3]), along_2 = 0.25 * (x[2] + x[3] - x[0] - x[1]);
    const Vector2 twist = 0.25 * (x[0] + x[2] - x[1] - x[3]);
    Vector2 local = Vector2::Zero();
    constexpr int iterations = 8;
    for (int k = 0; k < iterations; ++k) {
        Eigen::Matrix2d slope;
        slope << along_1 + local.y() * twist, along_2 + local.x() * twist;
        local += slope.inverse() * (point - at_local(x, local));
    }
    return local;
}

/// A particle that may carry a piece of a segment.
struct Candidate {
    std::size_t p;
    std::array<Vector2, 4> frame; // where the local coordinates are +-1 [m]
    std::vector<Vector2> corners; // of the domain [m]
    bool is_cut;                  // the domain is not the frame
    double size = 0.0;            // largest distance of a corner from the particle [m]
    double first = std::numeric_limits<double>::infinity(); // the corners' range along the segment [m]
    double last = -std::numeric_limits<double>::infinity();
};

/// How far a point is outside the candidate's domain; negative inside [m]. Local coordinates would not tell:
/// those of a quadrilateral have two solutions, and Newton's method may find neither.
double distance_outside(const Candidate& candidate, const Vector2& point)
{
    const std::vector<Vector2>& x = candidate.corners;
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < x.size(); ++c) {
        const Vector2 along = x[(c + 1) % x.size()] - x[c];
        farthest = std::max(farthest, cross(point - x[c], along) / along.norm());
    }
    return farthest;
}

/// The edge of a cut domain that a point lies nearest to; -1 of a whole one.
std::int32_t nearest_edge(const Candidate& candidate, const Vector2& point)
{
    if (!candidate.is_cut) return -1;
    const std::vector<Vector2>& x = candidate.corners;
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < x.size(); ++c) {
        const Vector2 along = x[(c + 1) % x.size()] - x[c];
        const double fraction = std::clamp((point - x[c]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double distance = (x[c] + fraction * along - point).norm();
        if (distance < least) nearest = c, least = distance;
    }
    return static_cast<std::int32_t>(nearest);
}

/// Particles whose domains touch the segment or come close to it, in their order along it.
std::vector<Candidate> find_candidates(const Problem& problem, const Particles& particles,
                                       const Segment& segment)
{
    const double length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length, normal(along.y(), -along.x());
    std::vector<Candidate> candidates;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 from_start = particles.position[p] - segment.start;
        const double size = particles.half_edge_1[p].norm() + particles.half_edge_2[p].norm();
        constexpr double reach = 2.5; // sizes
        const double s = from_start.dot(along);
        if (std::abs(from_start.dot(normal)) > reach * size || s < -reach * size || s > length + reach * size)
            continue;
        Candidate candidate{p, quadrilateral_corners(particles, p),
                            domain_polygon(problem.cut_domains, particles, p),
                            problem.cut_domains.find(particles.identifier[p]) != nullptr};
        for (const Vector2& corner : candidate.corners) {
            candidate.size = std::max(candidate.size, (corner - particles.position[p]).norm());
            candidate.first = std::min(candidate.first, (corner - segment.start).dot(along));
            candidate.last = std::max(candidate.last, (corner - segment.start).dot(along));
        }
        candidates.push_back(std::move(candidate));
    }
    std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
        return a.first != b.first ? a.first < b.first : particles.identifier[a.p] < particles.identifier[b.p];
    });
    return candidates;
}

/// Places along a segment where the carrier may change: the corners of the domains beside it [m].
std::vector<double> find_cuts(const std::vector<Candidate>& candidates, const Segment& segment)
{
    const double length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length;
    const double shortest = 1e-6 * candidates.front().size;
    std::vector<double> all = {0.0, length};
    for (const Candidate& candidate : candidates) {
        for (const Vector2& corner : candidate.corners) all.push_back((corner - segment.start).dot(along));
    }
    std::sort(all.begin(), all.end());
    std::vector<double> cuts = {0.0};
    for (const double cut : all) {
        if (cut > cuts.back() + shortest && cut < length - shortest) cuts.push_back(cut);
    }
    cuts.push_back(length);
    return cuts;
}

/// The particle that carries the curve at a point: whose domain the point lies in, a little inside the soil,
/// or else whose domain is nearest; none where there is no soil beside the curve.
const Candidate* find_carrier(const Particles& particles, const std::vector<Candidate>& candidates,
                              double widest, double s, const Vector2& point)
{
    const Candidate* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    const auto begin = std::lower_bound(candidates.begin(), candidates.end(), s - 3.0 * widest,
                                        [](const Candidate& c, double value) { return c.first < value; });
    for (auto c = begin; c != candidates.end() && c->first < s + 3.0 * widest; ++c) {
        const double outside = std::max(0.0, distance_outside(*c, point));
        const bool first_of_equals =
            best != nullptr && outside == least && particles.identifier[c->p] < particles.identifier[best->p];
        if (outside < least || first_of_equals) {
            best = &*c;
            least = outside;
        }
    }
    return best;
}

/// Cut one segment; false where there is no soil beside it.
bool cut_segment(const Problem& problem, const Particles& particles, const Segment& segment,
                 std::vector<BoundaryPiece>& pieces)
{
    const std::vector<Candidate> candidates = find_candidates(problem, particles, segment);
    if (candidates.empty()) return false;
    double widest = 0.0;
    for (const Candidate& c : candidates) widest = std::max({widest, c.last - c.first, c.size});
    const double length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length, inward(-along.y(), along.x());
    const auto point = [&](double s) -> Vector2 {
        return s < length ? segment.start + s * along : segment.end;
    };

    const std::vector<double> cuts = find_cuts(candidates, segment);
    constexpr double inset = 1e-7; // into the soil: thinner than any piece of a domain [sizes]
    const Candidate* carrier = nullptr;
    std::int32_t edge = -1;
    double begin = 0.0;
    const auto finish = [&](double end) {
        if (carrier == nullptr) return;
        pieces.push_back({particles.identifier[carrier->p], local_coordinates(carrier->frame, point(begin)),
                          local_coordinates(carrier->frame, point(end)), end - begin, edge});
    };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
        const Vector2 inside = point(middle) + inset * widest * inward;
        const Candidate* next = find_carrier(particles, candidates, widest, middle, inside);
        if (next == nullptr) return false;
        const std::int32_t next_edge = nearest_edge(*next, point(middle));
        if (carrier == next && edge == next_edge) continue;
        finish(cuts[k]);
        carrier = next;
        edge = next_edge;
        begin = cuts[k];
    }
    finish(length);
    return true;
}

/// Corners of the particle's domain where the equations have it: in small strain at the reference.
std::array<Vector2, 4> domain_corners(const Problem& problem, const Particles& particles, std::size_t p)
{
    return problem.strain == StrainForm::small ? reference_corners(particles, p)
                                               : quadrilateral_corners(particles, p);
}

ParallelogramDomain domain_in_equations(const Problem& problem, const Particles& particles, std::size_t p)
{
    if (problem.strain == StrainForm::large)
        return {particles.position[p], particles.half_edge_1[p], particles.half_edge_2[p]};
    return {particles.reference_position[p], particles.reference_edge_1[p], particles.reference_edge_2[p]};
}

/// Move corners to the box, or the cell, whose nodes have weights of the particle.
void move_into_reach(const Problem& problem, const Particles& particles, std::size_t p,
                     std::array<Vector2, 4>& corners)
{
    const BackgroundGrid& grid = problem.grid;
    const Vector2 x = domain_in_equations(problem, particles, p).centre;
    Vector2 lower, upper;
    if (problem.interpolation == Interpolation::linear) {
        lower = grid.rim_origin() + grid.cell_size * grid.cells_from_rim(x).array().floor().matrix();
        upper = lower + Vector2::Constant(grid.cell_size);
    } else {
        const bool keeps_size =
            problem.interpolation == Interpolation::gimp || problem.strain == StrainForm::small;
        const Vector2 box = keeps_size ? uniform_box(grid, particles, p) : contiguous_box(grid, particles, p);
        lower = x - 0.5 * box;
        upper = x + 0.5 * box;
    }
    for (Vector2& corner : corners) corner = corner.cwiseMax(lower).cwiseMin(upper);
}

/// Where the corners of a domain pass their load to the grid: within the reach of the particle's weights, so
/// that a loaded node has mass.
std::array<Vector2, 4> loaded_corners(const Problem& problem, const Particles& particles, std::size_t p)
{
    const BackgroundGrid& grid = problem.grid;
    if (problem.interpolation == Interpolation::cpdi2) {
        std::array<Vector2, 4> quadrilateral = domain_corners(problem, particles, p);
        limit_corners(grid.cell_size, domain_in_equations(problem, particles, p).centre, quadrilateral);
        return quadrilateral;
    }
    ParallelogramDomain domain = domain_in_equations(problem, particles, p);
    limit_domain(grid.cell_size, domain);
    const Vector2 &x = domain.centre, &r1 = domain.half_edge_1, &r2 = domain.half_edge_2;
    std::array<Vector2, 4> corners = {x - r1 - r2, x + r1 - r2, x + r1 + r2, x - r1 + r2};
    if (problem.interpolation != Interpolation::cpdi) move_into_reach(problem, particles, p, corners);
    return corners;
}

/// A piece on an edge of a cut domain.
PresentPiece piece_on_edge(const Problem& problem, const Particles& particles, const BoundaryPiece& piece,
                           std::size_t p)
{
    const CutDomain* shape = problem.cut_domains.find(piece.identifier);
    ENSURE(shape != nullptr);
    const auto [centre, r1, r2] = domain_in_equations(problem, particles, p);
    const std::size_t from = static_cast<std::size_t>(piece.edge), to = (from + 1) % shape->corners.size();
    const Vector2 along = shape->corners[to] - shape->corners[from];
    const Vector2 middle = 0.5 * (piece.start + piece.end);
    const double fraction = (middle - shape->corners[from]).dot(along) / along.squaredNorm();

    std::vector<Vector2> corners = corners_in_frame(*shape, centre, r1, r2);
    limit_polygon(problem.grid.cell_size, centre, corners);
    PresentPiece present;
    present.start = centre + piece.start.x() * r1 + piece.start.y() * r2;
    present.end = centre + piece.end.x() * r1 + piece.end.y() * r2;
    present.corners = {corners[from], corners[to], corners[from], corners[to]};
    present.fractions = {1.0 - fraction, fraction, 0.0, 0.0};
    present.tolerance = line_tolerance(problem.grid, centre);
    if (problem.interpolation != Interpolation::cpdi) move_into_reach(problem, particles, p, present.corners);
    return present;
}

/// Mark the segments beside which the soil is dry. Their nodes may be those of wet soil a cell below, whose
/// water is free to pass its own surface.
void mark_dry_segments(Problem& problem, const Particles& particles)
{
    ParticlePlaces places;
    for (Boundary& boundary : problem.boundaries) {
        for (Segment& segment : boundary.segments) {
            if (hold_of(boundary, segment, Stage::shaking).water == WaterHold::none) continue;
            std::vector<BoundaryPiece> pieces;
            if (!cut_segment(problem, particles, segment, pieces)) continue;
            segment.is_dry = std::all_of(pieces.begin(), pieces.end(), [&](const BoundaryPiece& piece) {
                const std::size_t p = places.find(particles, piece.identifier);
                const auto material = static_cast<std::size_t>(particles.material[p]);
                return problem.materials[material].has_pores && !problem.materials[material].saturated;
            });
        }
    }
}

/// Points of a domain that share out a force to all its nodes: its centre, or the middles of the edges of a
/// cut one.
void add_holders(const Problem& problem, std::int32_t identifier, std::vector<BoundaryPiece>& holders)
{
    const CutDomain* shape = problem.cut_domains.find(identifier);
    if (shape == nullptr) {
        holders.push_back({identifier});
        return;
    }
    for (std::size_t c = 0; c < shape->corners.size(); ++c) {
        const Vector2 middle = 0.5 * (shape->corners[c] + shape->corners[(c + 1) % shape->corners.size()]);
        holders.push_back({identifier, middle, middle, 0.0, static_cast<std::int32_t>(c)});
    }
}

/// Mark the nodes within the number of cells of those that are marked.
void widen(const BackgroundGrid& grid, int cells, std::vector<std::uint8_t>& marked)
{
    const std::vector<std::uint8_t> before = marked;
    const auto columns = static_cast<std::size_t>(grid.nodes_x());
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == 0) continue;
        const int x = static_cast<int>(i % columns), y = static_cast<int>(i / columns);
        for (int b = std::max(0, y - cells); b <= std::min(grid.nodes_y() - 1, y + cells); ++b)
            for (int a = std::max(0, x - cells); a <= std::min(grid.nodes_x() - 1, x + cells); ++a)
                marked[static_cast<std::size_t>(b) * columns + static_cast<std::size_t>(a)] = 1;
    }
}

/// Holders of the domains that reach a node within two cells of those which the curve's pieces reach: a node
/// that a wall on a grid line holds, or a row of a slanted one, may lie as far beyond its end.
void find_holders(const Problem& problem, const Particles& particles, Boundary& boundary)
{
    boundary.holders.clear();
    std::vector<std::uint8_t> reached(problem.grid.node_count(), 0);
    ParticlePlaces places;
    const auto present = [&](const BoundaryPiece& piece) {
        return present_piece(problem, particles, piece, places.find(particles, piece.identifier));
    };
    for (const BoundaryPiece& piece : boundary.pieces)
        for_each_loaded_node(problem.grid, present(piece), [&](std::size_t i, double) { reached[i] = 1; });
    constexpr int beyond_ends = 2; // [cells]
    widen(problem.grid, beyond_ends, reached);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        std::vector<BoundaryPiece> holders;
        add_holders(problem, particles.identifier[p], holders);
        bool reaches = false;
        for (const BoundaryPiece& holder : holders)
            for_each_loaded_node(problem.grid, present(holder), [&](std::size_t i, double fraction) {
                reaches = reaches || (fraction > 0.0 && reached[i] != 0);
            });
        if (reaches) boundary.holders.insert(boundary.holders.end(), holders.begin(), holders.end());
    }
}

} // namespace

std::vector<std::string> attach_boundaries(Problem& problem, const Particles& particles)
{
    std::vector<std::string> without_soil;
    if (is_partly_wet(problem)) mark_dry_segments(problem, particles);
    for (Boundary& boundary : problem.boundaries) {
        boundary.pieces.clear();
        if (!acts_on_soil(boundary)) continue;
        bool complete = true;
        for (const Segment& segment : boundary.segments)
            complete = cut_segment(problem, particles, segment, boundary.pieces) && complete;
        if (!complete) without_soil.push_back(boundary.name);
        if (lets_go(boundary.soil)) find_holders(problem, particles, boundary);
    }
    return without_soil;
}

std::size_t ParticlePlaces::find(const Particles& particles, std::int32_t identifier)
{
    const auto number = static_cast<std::size_t>(identifier);
    const auto is_there = [&](std::int32_t index) {
        return index >= 0 && static_cast<std::size_t>(index) < particles.size() &&
               particles.identifier[static_cast<std::size_t>(index)] == identifier;
    };
    if (number >= index_of_identifier_.size() || !is_there(index_of_identifier_[number])) {
        index_of_identifier_.clear();
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const auto named = static_cast<std::size_t>(particles.identifier[p]);
            if (named >= index_of_identifier_.size()) index_of_identifier_.resize(named + 1, -1);
            index_of_identifier_[named] = static_cast<std::int32_t>(p);
        }
        ENSURE(number < index_of_identifier_.size() && is_there(index_of_identifier_[number]));
    }
    return static_cast<std::size_t>(index_of_identifier_[number]);
}

PresentPiece present_piece(const Problem& problem, const Particles& particles, const BoundaryPiece& piece,
                           std::size_t p)
{
    if (piece.edge >= 0) return piece_on_edge(problem, particles, piece, p);
    const std::array<Vector2, 4> domain = domain_corners(problem, particles, p);
    const std::array<double, 4> at_start = corner_fractions(piece.start),
                                at_end = corner_fractions(piece.end);
    PresentPiece present;
    present.start = at_local(domain, piece.start);
    present.end = at_local(domain, piece.end);
    present.corners = loaded_corners(problem, particles, p);
    for (std::size_t c = 0; c < 4; ++c) present.fractions[c] = 0.5 * (at_start[c] + at_end[c]);
    return present;
}

} // namespace quicksand
