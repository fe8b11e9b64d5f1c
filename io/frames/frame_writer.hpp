// Writes the frames of VTK series at an interval, in the background.
#pragma once

#include "io/files/background_writer.hpp"
#include "io/frames/observation_clock.hpp"
#include "io/frames/vtk_series.hpp"
#include "solver/run/simulation.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace quicksand {

/// One series and the way its frames are made.
struct FrameSeries {
    using MakeFrame = std::function<Frame(const Problem&, const State&)>;
    VtkSeries series;
    MakeFrame make_frame;
};

class FrameWriter : public Observer {
public:
    /// `start_time` is the time of the state with which the run begins or goes on [s]. The problem given to
    /// `observe` must outlive the writer.
    FrameWriter(std::vector<FrameSeries> all_series, const ObservationClock& clock, double start_time,
                std::shared_ptr<BackgroundWriter> background);
    /// Waits for a frame under way, which is written from the series kept here: a run that fails does not
    /// call `finish`, and others may hold the background writer for longer.
    ~FrameWriter() override { background_->wait(); }
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    double next_time() const override;
    double interval() const override;
    void observe(const Problem& problem, const State& state, const StepReport& report) override;
    void after_step(const StepReport&) override { background_->report_failure(); }
    void finish() override { background_->finish(); }

private:
    std::vector<FrameSeries> all_series_;
    std::vector<ObservationClock> clocks_; // of each: a kill may come between their frames
    std::shared_ptr<BackgroundWriter> background_;
};

} // namespace quicksand
