// Writes the frames of a VTK series at an interval.
#pragma once

#include "io/observation_clock.hpp"
#include "io/vtk_series.hpp"
#include "solver/simulation.hpp"

#include <functional>

namespace quicksand {

class FrameWriter : public Observer {
public:
    using MakeFrame = std::function<Frame(const Problem&, const State&)>;

    /// `start_time` is the time of the state with which the run begins or goes on [s].
    FrameWriter(VtkSeries series, ObservationClock clock, double start_time, MakeFrame make_frame);

    double next_time() const override { return clock_.next(); }
    void observe(const Problem& problem, const State& state, const StepReport& report) override;

private:
    VtkSeries series_;
    ObservationClock clock_;
    MakeFrame make_frame_;
};

} // namespace quicksand
