// Vertices on the line count as above it, as if the line ran ever so little lower: every crossing then lies
// inside an edge, and those along the line belong together two by two, with the area between them.
#include "geometry/exact_rings.hpp"

#include "solver/failure.hpp"

#include <algorithm>
#include <numeric>

namespace quicksand {

namespace {

/// Where a ring changes sides.
struct Crossing {
    std::size_t ring, edge;  // the edge starts at the ring's vertex of this number
    bool leaves_above;       // the edge goes from above the line to below it
    bool at_vertex;          // the edge's upper end lies on the line
    ExactNumber along;       // coordinate along the line
    ExactNumber run, rise;   // of the edge along the line and across it, upwards
    std::size_t next = 0;    // crossing of the same ring
    std::size_t partner = 0; // the crossing at the other end of the stretch of area on the line
    bool followed = false;   // the part on the side to which its edge goes
};

class Division {
public:
    Division(const ExactRings& rings, std::size_t axis, const ExactNumber& at)
        : rings_(rings), axis_(axis), at_(at)
    {
        for (std::size_t r = 0; r < rings.size(); ++r) find_crossings(r);
        pair_crossings();
    }

    DividedArea parts()
    {
        for (std::size_t c = 0; c < crossings_.size(); ++c) follow(c);
        return std::move(parts_);
    }

private:
    bool is_below(const ExactPoint& point) const { return point[axis_] < at_; }

    void find_crossings(std::size_t r)
    {
        const std::vector<ExactPoint>& ring = rings_[r];
        const std::size_t first = crossings_.size();
        std::vector<bool> below;
        for (const ExactPoint& point : ring) below.push_back(is_below(point));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::size_t next = (k + 1) % ring.size();
            if (below[k] == below[next]) continue;
            add_crossing(r, k, below[next] ? ring[next] : ring[k], below[next] ? ring[k] : ring[next],
                         below[next]);
        }
        if (crossings_.size() == first) {
            if (ring.empty()) return;
            (below[0] ? parts_.below : parts_.above).push_back(ring);
            return;
        }
        for (std::size_t c = first; c < crossings_.size(); ++c)
            crossings_[c].next = c + 1 < crossings_.size() ? c + 1 : first;
    }

    void add_crossing(std::size_t r, std::size_t edge, const ExactPoint& low, const ExactPoint& high,
                      bool leaves_above)
    {
        const std::size_t other = 1 - axis_;
        Crossing crossing{r,
                          edge,
                          leaves_above,
                          high[axis_] == at_,
                          high[other],
                          high[other] - low[other],
                          high[axis_] - low[axis_]};
        if (!crossing.at_vertex)
            crossing.along = low[other] + (at_ - low[axis_]) * crossing.run / crossing.rise;
        // keeps the tree of lazy numbers flat and their bounds tight
        crossing.along.exact();
        crossings_.push_back(std::move(crossing));
    }

    /// Whether a crossing lies before another along the line, which runs ever so little lower.
    bool lies_before(const Crossing& a, const Crossing& b) const
    {
        if (a.along != b.along) return a.along < b.along;
        return a.run * b.rise > b.run * a.rise;
    }

    void pair_crossings()
    {
        std::vector<std::size_t> order(crossings_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return lies_before(crossings_[a], crossings_[b]);
        });
        // the area is to the left of its edges: along x it begins at one that goes down, along y at one that
        // goes up; edges on top of each other come in this order, too
        const bool begins_leaving = axis_ == 1;
        for (std::size_t k = 0; k < order.size(); k += 2) {
            for (const std::size_t place : {k, k + 1}) {
                const bool leaving = begins_leaving == (place == k);
                const auto here = order.begin() + static_cast<std::ptrdiff_t>(place);
                const auto fitting = std::find_if(
                    here, order.end(), [&](std::size_t c) { return crossings_[c].leaves_above == leaving; });
                ENSURE(fitting != order.end());
                std::rotate(here, fitting, fitting + 1);
            }
            crossings_[order[k]].partner = order[k + 1];
            crossings_[order[k + 1]].partner = order[k];
        }
    }

    /// Follow the ring that goes on from a crossing, on the side to which its edge goes.
    void follow(std::size_t start)
    {
        const bool below = crossings_[start].leaves_above;
        std::vector<ExactPoint> ring;
        for (std::size_t c = start; !crossings_[c].followed; c = crossings_[crossings_[c].next].partner) {
            crossings_[c].followed = true;
            const Crossing &from = crossings_[c], &to = crossings_[from.next];
            const std::vector<ExactPoint>& whole = rings_[from.ring];
            add_place(from, below, ring);
            for (std::size_t k = from.edge; k != to.edge; k = (k + 1) % whole.size())
                ring.push_back(whole[(k + 1) % whole.size()]);
            add_place(to, below, ring);
        }
        if (ring.size() > 2) (below ? parts_.below : parts_.above).push_back(std::move(ring));
    }

    void add_place(const Crossing& crossing, bool below, std::vector<ExactPoint>& ring) const
    {
        if (crossing.at_vertex && !below) return; // a vertex of the part above
        ExactPoint point;
        point[axis_] = at_;
        point[1 - axis_] = crossing.along;
        ring.push_back(point);
    }

    const ExactRings& rings_;
    std::size_t axis_;
    ExactNumber at_;
    std::vector<Crossing> crossings_;
    DividedArea parts_;
};

} // namespace

DividedArea divide_area(const ExactRings& rings, std::size_t axis, const ExactNumber& at)
{
    return Division(rings, axis, at).parts();
}

} // namespace quicksand
