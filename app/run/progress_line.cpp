#include "app/run/progress_line.hpp"

#include "app/run/number_format.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace quicksand {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds terminal_interval{0.2};
constexpr Seconds plain_interval{30.0};

} // namespace

std::string unbalanced_text(const UnbalancedForces& unbalanced, double tolerance)
{
    const double times = unbalanced.of_weight / tolerance;
    const std::string multiple =
        times < 1e6 ? grouped(static_cast<long long>(times + 0.5)) : short_number(times, 2);
    return fmt::format("out-of-balance force {} of the weight, {} times the tolerance, largest at ({}, {}) m",
                       short_number(unbalanced.of_weight, 2), multiple, short_number(unbalanced.place.x(), 4),
                       short_number(unbalanced.place.y(), 4));
}

ProgressLine::ProgressLine(double start_time, double end_time, std::size_t particles, Journal& journal)
    : start_time_(start_time), end_time_(end_time), particles_(static_cast<double>(particles)),
      journal_(journal), terminal_(isatty(STDOUT_FILENO) == 1), began_(Clock::now()), last_line_(began_),
      last_plain_(began_)
{
    if (end_time > 0.0) last_tenth_ = static_cast<int>(10.0 * start_time / end_time);
}

double ProgressLine::elapsed() const
{
    return Seconds(Clock::now() - began_).count();
}

void ProgressLine::after_step(const StepReport& report)
{
    ++steps_;
    const TimeStep& step = report.time_step;
    if (step.limiter != TimeStepLimiter::output || last_limit_.empty()) {
        last_limit_ = short_number(step.dt, 2) + " (" + name_of(step.limiter) +
                      (step.material.empty() ? "" : ", " + step.material) + ")";
    }
    const int tenth = static_cast<int>(10.0 * report.time / end_time_);
    const Clock::time_point now = Clock::now();
    if (tenth == last_tenth_ && now - last_line_ < terminal_interval) return;
    last_line_ = now;
    const double wall = Seconds(now - began_).count();
    const double rate = particles_ * static_cast<double>(steps_) / wall;
    const double left = wall * (end_time_ - report.time) / (report.time - start_time_);
    show(fmt::format("t {:.4f}/{} s  {:2.0f}%  dt {}  {} particle-steps/s  elapsed {}  left {}", report.time,
                     short_number(end_time_), 100.0 * report.time / end_time_, last_limit_,
                     short_number(rate, 2), duration_text(wall), duration_text(left)),
         tenth);
}

void ProgressLine::went_back(const FailureRecord& record, const State& state)
{
    clear();
    const char* remedy =
        record.remedy == Remedy::explicit_steps ? "explicit steps for a while" : "half the step";
    journal_.say(fmt::format("The run went bad in step {}, t = {} s, at ({}, {}) m ({}): {}\n"
                             "  It goes on from t = {} s with {}.",
                             record.step, short_number(record.time), coordinate_text(record.position.x()),
                             coordinate_text(record.position.y()), record.phase, record.what,
                             short_number(state.time), remedy));
}

void ProgressLine::show_relaxation(const SettlingProgress& settling, double tolerance)
{
    const Clock::time_point now = Clock::now();
    if (now - last_line_ < terminal_interval) return;
    last_line_ = now;
    show(fmt::format("settling: step {}  {}  elapsed {}", grouped(settling.steps),
                     unbalanced_text(settling.unbalanced, tolerance), duration_text(elapsed())),
         last_tenth_);
}

void ProgressLine::show(const std::string& line, int tenth)
{
    if (terminal_) {
        std::cout << '\r' << line << "\x1b[K" << std::flush;
        line_open_ = true;
    }
    if (tenth == last_tenth_ && last_line_ - last_plain_ < plain_interval) return;
    last_tenth_ = tenth;
    last_plain_ = last_line_;
    if (terminal_) {
        journal_.note(line);
    } else {
        journal_.say(line);
    }
}

void ProgressLine::clear()
{
    if (line_open_) std::cout << "\r\x1b[K" << std::flush;
    line_open_ = false;
}

} // namespace quicksand
