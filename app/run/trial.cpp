#include "app/run/trial.hpp"

#include "io/files/file_error.hpp"
#include "io/frames/observation_clock.hpp"
#include "io/results/output_observers.hpp"
#include "solver/base/threads.hpp"
#include "solver/measure/balances.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/run/events.hpp"
#include "solver/step/step_forecast.hpp"

#include <stdlib.h>
#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr double step_trial_seconds = 1.5;       // wall time of the trial of steps [s]
constexpr double relaxation_trial_seconds = 4.0; // and of the settling [s]
constexpr double output_trial_seconds = 0.5;     // and of each writer, one call at least [s]
constexpr std::int64_t warm_up_steps = 20;

/// Soil whose law remembers cycles settles on with the strength of the shaking, in about as many steps as
/// before: 0.4 to 1.8 times as many on the examples lateral_spread, sloping_ground, river_dike, free_field
/// and sea_dike_caisson [-].
constexpr double steps_at_strength = 1.0;

class StopWatch {
public:
    double seconds() const
    {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    }

private:
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

std::vector<double> observation_times(double interval, double end_time)
{
    std::vector<double> times;
    if (interval <= 0.0) return times;
    for (ObservationClock clock(interval, end_time); std::isfinite(clock.next()); clock.advance()) {
        times.push_back(clock.next());
    }
    return times;
}

/// Times the steps after the first few.
class StepWatch final : public Observer {
public:
    double next_time() const override { return std::numeric_limits<double>::infinity(); }
    void observe(const Problem&, const State&, const StepReport&) override {}
    void after_step(const StepReport& report) override
    {
        steps_ = report.step;
        if (steps_ == warm_up_steps) watch_ = StopWatch();
    }

    bool has_enough() const { return steps_ > warm_up_steps && watch_.seconds() > step_trial_seconds; }
    /// A run shorter than the trial has been measured as a whole.
    double seconds_of_a_step() const
    {
        const std::int64_t measured = steps_ > warm_up_steps ? steps_ - warm_up_steps : steps_;
        return watch_.seconds() / static_cast<double>(std::max<std::int64_t>(measured, 1));
    }

private:
    StopWatch watch_;
    std::int64_t steps_ = 0;
};

double measure_step(StagedRun run)
{
    run.begin_shaking();
    StepWatch watch;
    run.shake({&watch}, [&] { return watch.has_enough(); });
    return watch.seconds_of_a_step();
}

/// How the out-of-balance force has fallen.
struct Decay {
    std::vector<double> steps, logarithms;

    /// Steps until the force has fallen to the tolerance, by the slope of the second half of the trial.
    double steps_until(double tolerance) const
    {
        const std::size_t half = steps.size() / 2;
        const double run = steps.back() - steps[half];
        const double fall = logarithms[half] - logarithms.back();
        if (run <= 0.0 || fall <= 0.0) return std::numeric_limits<double>::infinity();
        return steps.back() + std::max(0.0, logarithms.back() - std::log(tolerance)) * run / fall;
    }
};

/// A new folder with a name of its own, for none of the user's may be touched; removed at the end.
class ScratchFolder {
public:
    explicit ScratchFolder(const fs::path& parent)
    {
        std::string name = (parent / "trial_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw FileError(parent, "cannot make a folder in it", system_reason(errno), "");
        path_ = name;
    }
    ~ScratchFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

double folder_bytes(const fs::path& folder)
{
    double bytes = 0.0;
    for (const auto& item : fs::recursive_directory_iterator(folder)) {
        if (item.is_regular_file()) bytes += static_cast<double>(item.file_size());
    }
    return bytes;
}

/// Let one writer look at the state a few times and add what all its looks will cost.
void measure_writer(Observer& writer, const Problem& problem, State& state, double end_time,
                    const fs::path& scratch, OutputForecast& forecast)
{
    const StepReport report{0, 0.0, {}, 0};
    state.time = writer.next_time();
    if (!std::isfinite(state.time)) return;
    writer.observe(problem, state, report);
    writer.finish();
    const double interval = writer.next_time() - state.time;
    const double bytes_before = folder_bytes(scratch);
    const StopWatch watch;
    double looks = 0.0, looking = 0.0;
    while (std::isfinite(writer.next_time()) &&
           (looks == 0.0 || (watch.seconds() < output_trial_seconds && looks < 5.0))) {
        state.time = writer.next_time();
        const StopWatch look;
        writer.observe(problem, state, report);
        looking += look.seconds();
        writer.finish();
        looks += 1.0;
    }
    if (looks == 0.0) return;
    const double all_looks = std::ceil(end_time / interval) + 1.0;
    forecast.seconds += all_looks * looking / looks;
    forecast.background_seconds += all_looks * (watch.seconds() - looking) / looks;
    forecast.bytes += all_looks * (folder_bytes(scratch) - bytes_before) / looks;
}

OutputForecast forecast_output(const AssembledCase& assembled, const fs::path& directory)
{
    OutputForecast forecast;
    forecast.has_own_core = static_cast<unsigned>(thread_count()) < std::thread::hardware_concurrency();
    State state = assembled.state;
    begin_shaking(assembled.problem, state);
    open_balances(assembled.problem, state);
    const ScratchFolder scratch(directory);
    const auto writers =
        make_output_observers(assembled.scene, assembled.problem, state, {scratch.path(), "", "", false});
    for (const auto& writer : writers) {
        measure_writer(*writer, assembled.problem, state, assembled.scene.end_time, scratch.path(), forecast);
    }
    forecast.bytes += static_cast<double>(memory_bytes(state.particles)); // the checkpoint
    forecast.frames = static_cast<std::int64_t>(
        observation_times(assembled.scene.output.frame_interval, assembled.scene.end_time).size());
    return forecast;
}

double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

} // namespace

std::int64_t count_steps(const AssembledCase& assembled, const TimeStep& step)
{
    const Scene& scene = assembled.scene;
    const Problem& problem = assembled.problem;
    std::vector<double> times = observation_times(scene.output.frame_interval, scene.end_time);
    if (times.empty()) times.push_back(scene.end_time);
    constexpr double none = std::numeric_limits<double>::infinity();
    Events events{scene.end_time, none, none};
    const auto hit = [&events](double interval) {
        if (interval > 0.0) add_interval(interval, interval, events);
    };
    hit(scene.output.frame_interval);
    hit(scene.output.history_interval);
    if (!scene.probes.empty()) hit(scene.output.probe_interval);
    const bool is_implicit = step.scheme == TimeScheme::implicit;
    if (!is_implicit && std::isfinite(events.interval) && divides_well(events, step.dt))
        return count_steps(problem, assembled.state.particles, step_of_interval(events.interval, step.dt),
                           {scene.end_time});
    return count_steps(problem, assembled.state.particles, step.dt, times);
}

RelaxationForecast forecast_settling(const RelaxationControls& controls, StagedRun& run)
{
    Decay decay;
    const StopWatch watch;
    const auto note = [&](const SettlingProgress& settling) {
        decay.steps.push_back(static_cast<double>(settling.steps));
        decay.logarithms.push_back(std::log(settling.unbalanced.of_weight));
    };
    const auto enough = [&] { return watch.seconds() > relaxation_trial_seconds; };
    const RelaxationReport report = run.settle(controls, note, enough);
    RelaxationForecast forecast;
    forecast.needed = true;
    forecast.step_seconds = watch.seconds() / static_cast<double>(report.steps);
    const auto taken = static_cast<double>(report.steps);
    double steps = report.settled ? taken : decay.steps_until(controls.tolerance);
    forecast.reliable = report.settled || steps < static_cast<double>(controls.max_steps);
    if (!report.settled && memory_columns(run.problem()) > 0)
        steps = std::max(taken, (1.0 + steps_at_strength) * steps);
    forecast.steps = forecast.reliable ? static_cast<std::int64_t>(steps) : controls.max_steps;
    return forecast;
}

Forecast forecast_run(const AssembledCase& assembled, const StagedRun& run, const TimeStep& step,
                      const fs::path& directory)
{
    Forecast forecast;
    forecast.steps = count_steps(assembled, step);
    forecast.step_seconds = measure_step(run);
    if (assembled.scene.relaxation) {
        StagedRun trial = run;
        forecast.relaxation = forecast_settling(*assembled.scene.relaxation, trial);
    }
    forecast.output = forecast_output(assembled, directory);
    forecast.memory = peak_memory();
    return forecast;
}

} // namespace quicksand
