#include "io/pictures/picture_outline.hpp"

#include "geometry/section/region_locator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace quicksand {
namespace {

/// Tells whether a domain holds a point; each is looked for in the boxes of a lattice that it touches.
class DomainLattice {
public:
    explicit DomainLattice(const std::vector<DomainCorners>& domains)
    {
        for (const DomainCorners& domain : domains) {
            domains_.push_back({domain, {}});
            for (const Vector2& corner : domain) {
                lower_ = lower_.cwiseMin(corner);
                upper_ = upper_.cwiseMax(corner);
            }
        }
        const double per_side = std::sqrt(static_cast<double>(domains.size()));
        box_ = ((upper_ - lower_) / per_side).cwiseMax(1e-12);
        columns_ = static_cast<std::size_t>(per_side) + 1;
        boxes_.resize(columns_ * columns_);
        for (std::size_t d = 0; d < domains.size(); ++d) enter(d);
    }

    bool covers(const Vector2& point) const
    {
        const std::vector<std::size_t>& near = boxes_[column(point.x(), 0) + columns_ * column(point.y(), 1)];
        return std::any_of(near.begin(), near.end(),
                           [&](std::size_t d) { return contains(domains_[d], point); });
    }

private:
    std::size_t column(double coordinate, int axis) const
    {
        const double place = (coordinate - lower_[axis]) / box_[axis];
        return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(columns_ - 1)));
    }

    void enter(std::size_t d)
    {
        Vector2 low = upper_, high = lower_;
        for (const Vector2& corner : domains_[d].outer)
            low = low.cwiseMin(corner), high = high.cwiseMax(corner);
        for (std::size_t row = column(low.y(), 1); row <= column(high.y(), 1); ++row)
            for (std::size_t c = column(low.x(), 0); c <= column(high.x(), 0); ++c)
                boxes_[c + columns_ * row].push_back(d);
    }

    std::vector<Polygon> domains_;
    Vector2 lower_ = Vector2::Constant(INFINITY), upper_ = Vector2::Constant(-INFINITY), box_;
    std::size_t columns_ = 1;
    std::vector<std::vector<std::size_t>> boxes_;
};

using Piece = std::array<Vector2, 2>;

/// What of an edge has soil on its left only.
void add_open_pieces(const Vector2& start, const Vector2& end, const DomainLattice& lattice, double gap,
                     std::vector<Piece>& open)
{
    const Vector2 along = end - start;
    const Vector2 outward = gap * Vector2(along.y(), -along.x()).normalized();
    const double count = std::ceil(along.norm() / (3.0 * gap));
    bool goes_on = false;
    for (double k = 0.0; k < count; k += 1.0) {
        const Vector2 middle = start + (k + 0.5) / count * along;
        // The neighbour may be thin, or lie beyond a gap.
        const bool covered = lattice.covers(middle + 0.02 * outward) || lattice.covers(middle + outward);
        if (!covered && !goes_on) open.push_back({start + k / count * along, start});
        if (!covered) open.back()[1] = start + (k + 1.0) / count * along;
        goes_on = !covered;
    }
}

/// The pieces as long lines: drawn one by one, they would show where they meet.
std::vector<std::vector<Vector2>> join(const std::vector<Piece>& pieces, double gap)
{
    using Place = std::pair<long, long>;
    const auto place_of = [gap](const Vector2& point) {
        return Place{std::lround(10.0 * point.x() / gap), std::lround(10.0 * point.y() / gap)};
    };
    std::map<Place, std::size_t> starts;
    for (std::size_t k = 0; k < pieces.size(); ++k) starts.emplace(place_of(pieces[k][0]), k);
    std::vector<std::vector<Vector2>> lines;
    std::vector<bool> done(pieces.size(), false);
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (done[first]) continue;
        lines.push_back({pieces[first][0]});
        std::size_t next = first;
        while (!done[next]) {
            done[next] = true;
            lines.back().push_back(pieces[next][1]);
            const auto found = starts.find(place_of(pieces[next][1]));
            if (found != starts.end()) next = found->second;
        }
    }
    return lines;
}

} // namespace

std::vector<std::vector<Vector2>> outline_of(const std::vector<DomainCorners>& domains, double gap)
{
    if (domains.empty()) return {};
    std::vector<Piece> open;
    const DomainLattice lattice(domains);
    for (const DomainCorners& domain : domains)
        for (std::size_t k = 0; k < domain.size(); ++k)
            add_open_pieces(domain[k], domain[(k + 1) % domain.size()], lattice, gap, open);
    return join(open, gap);
}

} // namespace quicksand
