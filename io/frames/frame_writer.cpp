#include "io/frames/frame_writer.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace quicksand {

FrameWriter::FrameWriter(std::vector<FrameSeries> all_series, const ObservationClock& clock,
                         double start_time, std::shared_ptr<BackgroundWriter> background)
    : all_series_(std::move(all_series)), clocks_(all_series_.size(), clock),
      background_(std::move(background))
{
    for (std::size_t k = 0; k < clocks_.size(); ++k) {
        const std::vector<FrameEntry>& entries = all_series_[k].series.entries();
        clocks_[k].go_on(start_time, entries.empty() ? std::nullopt : std::optional(entries.back().time));
    }
}

double FrameWriter::interval() const
{
    return clocks_.empty() ? std::numeric_limits<double>::infinity() : clocks_.front().interval();
}

double FrameWriter::next_time() const
{
    double next = std::numeric_limits<double>::infinity();
    for (const ObservationClock& clock : clocks_) next = std::min(next, clock.next());
    return next;
}

void FrameWriter::observe(const Problem& problem, const State& state, const StepReport&)
{
    std::vector<FrameSeries*> due;
    for (std::size_t k = 0; k < clocks_.size(); ++k) {
        if (clocks_[k].next() > state.time) continue;
        due.push_back(&all_series_[k]);
        clocks_[k].advance();
    }
    background_->write(state, [&problem, due](const State& copy) {
        for (FrameSeries* each : due) each->series.append(each->make_frame(problem, copy));
    });
}

} // namespace quicksand
