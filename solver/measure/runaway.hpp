// Whether a body that settles under damping runs away instead.
//
// Where nothing holds the soil its resistance has come to its end: what is left of the weight is constant,
// and so is the acceleration, u ~ t^2. Soil that comes to rest finds more resistance as it moves: its speed
// grows less and less and falls, as in u = U (1 - cos wt). At twice the time a body in free motion has twice
// the speed; with the bound below one that comes to rest has gone through a quarter of its way at most. So a
// body is meant whose displacement is far beyond that of soil which stands: slopes of Griffiths and Lane that
// are stable by two per cent move 0.1 gamma H^2 / G, measured on cells of 1 and 0.5 m.
//
// Soil may also creep on at a constant speed, as the corner of a slope does. Then the force that is out of
// balance does not fall, which falls by orders in a body that comes to rest. A slide of weak soil is over
// soon, for it flattens the slope: where a body has gone as far as gamma H^2 / G, at which strength reduction
// says that it fails, eight looks are enough, over which half of the force is left. Bodies that stood had
// gone half as far at most.
#pragma once

#include <cstddef>
#include <vector>

namespace quicksand {

/// The largest displacement and the unbalanced force of a body as its steps go on, at equal intervals.
class Runaway {
public:
    /// `least_displacement`: that of no body which stands, 0: nothing moves it [m].
    explicit Runaway(double least_displacement) : least_displacement_(least_displacement) {}

    /// Note the largest displacement [m] and the unbalanced force over the weight [-], every so many steps,
    /// the same number each time.
    void note(double displacement, double unbalanced);

    /// Whether the body has gone farther than one that stands and moves faster and faster, or moves on while
    /// its unbalanced force does not fall.
    bool is_certain() const { return moves_faster() || creeps(); }

private:
    bool moves_faster() const;
    bool creeps() const;
    /// Whether it has gone far enough, in as many looks at least.
    bool is_beyond(std::size_t fewest) const;

    double least_displacement_;         // [m]
    std::vector<double> displacements_; // from the first look on [m]
    std::vector<double> unbalanced_;    // at the same time [-]
};

} // namespace quicksand
