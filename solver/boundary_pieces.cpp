#include "solver/boundary_pieces.hpp"

#include "solver/cpdi.hpp"
#include "solver/cpdi2.hpp"
#include "solver/failure.hpp"
#include "solver/gimp.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace quicksand {

namespace {

/// The bilinear functions of the domain's corners at local coordinates.
std::array<double, 4> corner_shares(const Vector2& local)
{
    const double xi = local.x(), eta = local.y();
    return {0.25 * (1.0 - xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 + eta),
            0.25 * (1.0 - xi) * (1.0 + eta)};
}

Vector2 at_local(const std::array<Vector2, 4>& corners, const Vector2& local)
{
    const std::array<double, 4> share = corner_shares(local);
    return share[0] * corners[0] + share[1] * corners[1] + share[2] * corners[2] + share[3] * corners[3];
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
    std::array<Vector2, 4> corners; // [m]
    double size;                    // largest distance of a corner from the particle [m]
    double first, last;             // the corners' range along the segment [m]
};

/// How far a point is outside the candidate's domain; negative inside [m].
double distance_outside(const Candidate& candidate, const Vector2& point)
{
    return (local_coordinates(candidate.corners, point).cwiseAbs().maxCoeff() - 1.0) * candidate.size;
}

/// Particles whose domains touch the segment or come close to it, in their order along it.
std::vector<Candidate> find_candidates(const Particles& particles, const Segment& segment)
{
    const double length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length, normal(along.y(), -along.x());
    std::vector<Candidate> candidates;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 from_start = particles.position[p] - segment.start;
        const double size = particles.half_edge_1[p].norm() + particles.half_edge_2[p].norm();
        // the stairs of domains along a slanted curve leave gaps of less than a domain
        constexpr double reach = 2.5; // sizes
        const double s = from_start.dot(along);
        if (std::abs(from_start.dot(normal)) > reach * size || s < -reach * size || s > length + reach * size)
            continue;
        Candidate candidate{p, quadrilateral_corners(particles, p), 0.0, 0.0, 0.0};
        candidate.first = std::numeric_limits<double>::infinity();
        candidate.last = -candidate.first;
        for (const Vector2& corner : candidate.corners) {
            candidate.size = std::max(candidate.size, (corner - particles.position[p]).norm());
            candidate.first = std::min(candidate.first, (corner - segment.start).dot(along));
            candidate.last = std::max(candidate.last, (corner - segment.start).dot(along));
        }
        candidates.push_back(candidate);
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
bool cut_segment(const Particles& particles, const Segment& segment, std::vector<BoundaryPiece>& pieces)
{
    const std::vector<Candidate> candidates = find_candidates(particles, segment);
    if (candidates.empty()) return false;
    double widest = 0.0;
    for (const Candidate& c : candidates) widest = std::max({widest, c.last - c.first, c.size});
    const double length = (segment.end - segment.start).norm();
    const Vector2 along = (segment.end - segment.start) / length, inward(-along.y(), along.x());
    const auto point = [&](double s) -> Vector2 {
        return s < length ? segment.start + s * along : segment.end;
    };

    const std::vector<double> cuts = find_cuts(candidates, segment);
    const Candidate* carrier = nullptr;
    double begin = 0.0;
    const auto finish = [&](double end) {
        if (carrier == nullptr) return;
        pieces.push_back({particles.identifier[carrier->p], local_coordinates(carrier->corners, point(begin)),
                          local_coordinates(carrier->corners, point(end)), end - begin});
    };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double middle = 0.5 * (cuts[k] + cuts[k + 1]);
        const Vector2 inside = point(middle) + 1e-3 * candidates.front().size * inward;
        const Candidate* next = find_carrier(particles, candidates, widest, middle, inside);
        if (next == nullptr) return false;
        if (carrier == next) continue;
        finish(cuts[k]);
        carrier = next;
        begin = cuts[k];
    }
    finish(length);
    return true;
}

bool carries_something(const Boundary& boundary)
{
    return boundary.load || boundary.outer_water || boundary.soil == SoilCondition::viscous;
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
    if (problem.interpolation == Interpolation::cpdi) return corners;

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
    return corners;
}

} // namespace

std::vector<std::string> attach_boundaries(Problem& problem, const Particles& particles)
{
    std::vector<std::string> without_soil;
    for (Boundary& boundary : problem.boundaries) {
        boundary.pieces.clear();
        if (!carries_something(boundary)) continue;
        bool complete = true;
        for (const Segment& segment : boundary.segments)
            complete = cut_segment(particles, segment, boundary.pieces) && complete;
        if (!complete) without_soil.push_back(boundary.name);
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
    const std::array<Vector2, 4> domain = domain_corners(problem, particles, p);
    const std::array<double, 4> at_start = corner_shares(piece.start), at_end = corner_shares(piece.end);
    PresentPiece present;
    present.start = at_local(domain, piece.start);
    present.end = at_local(domain, piece.end);
    present.corners = loaded_corners(problem, particles, p);
    for (std::size_t c = 0; c < 4; ++c) present.shares[c] = 0.5 * (at_start[c] + at_end[c]);
    return present;
}

} // namespace quicksand
