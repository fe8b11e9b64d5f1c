#include "io/frame_writer.hpp"

#include <optional>
#include <utility>

namespace quicksand {

FrameWriter::FrameWriter(VtkSeries series, ObservationClock clock, double start_time, MakeFrame make_frame)
    : series_(std::move(series)), clock_(clock), make_frame_(std::move(make_frame))
{
    std::optional<double> last;
    if (!series_.entries().empty()) last = series_.entries().back().time;
    clock_.go_on(start_time, last);
}

void FrameWriter::observe(const Problem& problem, const State& state, const StepReport&)
{
    series_.append(make_frame_(problem, state));
    clock_.advance();
}

} // namespace quicksand
