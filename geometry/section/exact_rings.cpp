// For the part below, vertices on the line count as above it, as if the line ran ever so little lower; for
// the part above as below it. Every crossing then lies inside an edge, and those along the line belong
// together two by two, with the area between them; neither part touches itself where a vertex lies on the
// line.
#include "geometry/section/exact_rings.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <numeric>

namespace quicksand {

namespace {

/// Where a ring changes sides.
struct Crossing {
    std::size_t ring, edge;  // the edge starts at the ring's vertex of this number
    bool enters;             // the edge goes into the part that is wanted
    ExactNumber along;       // coordinate along the line
    ExactNumber run, rise;   // of the edge along the line and across it, upwards
    std::size_t next = 0;    // crossing of the same ring
    std::size_t partner = 0; // the crossing at the other end of the stretch of area on the line
    bool followed = false;   // the part of the ring after it
};

/// The part of an area on one side of a line.
class PartOfArea {
public:
    PartOfArea(const ExactRings& rings, std::size_t axis, const ExactNumber& at, bool below)
        : rings_(rings), axis_(axis), at_(at), below_(below)
    {
        for (std::size_t r = 0; r < rings.size(); ++r) find_crossings(r);
        pair_crossings();
        for (std::size_t c = 0; c < crossings_.size(); ++c)
            if (crossings_[c].enters) follow(c);
    }

    ExactRings take() { return std::move(part_); }

private:
    bool is_inside(const ExactPoint& point) const { return below_ ? point[axis_] < at_ : point[axis_] > at_; }

    void find_crossings(std::size_t r)
    {
        const std::vector<ExactPoint>& ring = rings_[r];
        const std::size_t first = crossings_.size();
        std::vector<bool> inside;
        for (const ExactPoint& point : ring) inside.push_back(is_inside(point));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const std::size_t next = (k + 1) % ring.size();
            if (inside[k] != inside[next]) add_crossing(r, k, ring[k], ring[next], inside[next]);
        }
        if (crossings_.size() == first) {
            if (!ring.empty() && inside[0]) part_.push_back(ring);
            return;
        }
        for (std::size_t c = first; c < crossings_.size(); ++c)
            crossings_[c].next = c + 1 < crossings_.size() ? c + 1 : first;
    }

    void add_crossing(std::size_t r, std::size_t edge, const ExactPoint& from, const ExactPoint& to,
                      bool enters)
    {
        const bool upwards = enters != below_;
        const ExactPoint &low = upwards ? from : to, &high = upwards ? to : from;
        const std::size_t other = 1 - axis_;
        Crossing crossing{r, edge, enters, 0, high[other] - low[other], high[axis_] - low[axis_]};
        if (low[axis_] == at_)
            crossing.along = low[other];
        else if (high[axis_] == at_)
            crossing.along = high[other];
        else
            crossing.along = low[other] + (at_ - low[axis_]) * crossing.run / crossing.rise;
        // keeps the tree of lazy numbers flat and their bounds tight
        crossing.along.exact();
        crossings_.push_back(std::move(crossing));
    }

    /// Whether a crossing lies before another along the line, which runs ever so little inside the part.
    bool lies_before(const Crossing& a, const Crossing& b) const
    {
        if (a.along != b.along) return a.along < b.along;
        return below_ ? a.run * b.rise > b.run * a.rise : a.run * b.rise < b.run * a.rise;
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
        const bool begins_entering = (axis_ == 1) == below_;
        for (std::size_t k = 0; k < order.size(); k += 2) {
            for (const std::size_t place : {k, k + 1}) {
                const bool entering = begins_entering == (place == k);
                const auto here = order.begin() + static_cast<std::ptrdiff_t>(place);
                const auto fitting = std::find_if(
                    here, order.end(), [&](std::size_t c) { return crossings_[c].enters == entering; });
                ENSURE(fitting != order.end());
                std::rotate(here, fitting, fitting + 1);
            }
            crossings_[order[k]].partner = order[k + 1];
            crossings_[order[k + 1]].partner = order[k];
        }
    }

    /// Follow the part's ring that goes on from a crossing.
    void follow(std::size_t start)
    {
        std::vector<ExactPoint> ring;
        for (std::size_t c = start; !crossings_[c].followed; c = crossings_[crossings_[c].next].partner) {
            crossings_[c].followed = true;
            const Crossing &from = crossings_[c], &to = crossings_[from.next];
            const std::vector<ExactPoint>& whole = rings_[from.ring];
            ring.push_back(place_of(from));
            for (std::size_t k = from.edge; k != to.edge; k = (k + 1) % whole.size())
                ring.push_back(whole[(k + 1) % whole.size()]);
            ring.push_back(place_of(to));
        }
        if (ring.size() > 2) part_.push_back(std::move(ring));
    }

    ExactPoint place_of(const Crossing& crossing) const
    {
        ExactPoint point;
        point[axis_] = at_;
        point[1 - axis_] = crossing.along;
        return point;
    }

    const ExactRings& rings_;
    std::size_t axis_;
    ExactNumber at_;
    bool below_;
    std::vector<Crossing> crossings_;
    ExactRings part_;
};

} // namespace

ExactRings part_below(const ExactRings& rings, std::size_t axis, const ExactNumber& at)
{
    return PartOfArea(rings, axis, at, true).take();
}

ExactRings part_above(const ExactRings& rings, std::size_t axis, const ExactNumber& at)
{
    return PartOfArea(rings, axis, at, false).take();
}

} // namespace quicksand
