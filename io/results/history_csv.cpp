#include "io/results/history_csv.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/body_quantities.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

namespace {

std::vector<std::string> column_names(const Problem& problem, const State& state)
{
    std::vector<std::string> names;
    for (const BodyQuantity* quantity : body_quantities(problem, state))
        names.push_back(column_name(*quantity));
    return names;
}

CsvFile open_history_file(const Problem& problem, const State& state, const RunLabel& label,
                          const std::filesystem::path& path, bool resume)
{
    std::vector<std::string> comments = run_comments(label);
    comments.emplace_back("sums and energies are per metre of thickness");
    for (const BodyQuantity* quantity : body_quantities(problem, state))
        comments.push_back(fmt::format("{}: {}", quantity->name, quantity->meaning));
    return resume ? CsvFile::resume(path, comments, column_names(problem, state), state.time)
                  : CsvFile::begin(path, comments, column_names(problem, state));
}

} // namespace

std::vector<std::int32_t> reference_crest(const Particles& particles)
{
    // A resumed run has moved already, and must find the crest it began with.
    Particles at_start = particles;
    return_to_reference(at_start);
    return crest_particles(at_start);
}

HistoryWriter::HistoryWriter(const Scene& scene, const Problem& problem, const State& state,
                             const RunLabel& label, const std::filesystem::path& path, bool resume)
    : clock_(scene.output.history_interval, scene.end_time),
      file_(open_history_file(problem, state, label, path, resume)), crest_(reference_crest(state.particles))
{
    clock_.go_on(state.time, file_.last_time());
}

std::vector<double> HistoryWriter::measure(const Problem& problem, const State& state,
                                           std::int64_t limited_domains) const
{
    const MeasuredBody body = measure_body(problem, state, crest_, limited_domains);
    std::vector<double> values;
    for (const BodyQuantity* quantity : body_quantities(problem, state))
        values.push_back(quantity->value(body));
    return values;
}

void HistoryWriter::before_step(const Problem& problem, const State& state, double)
{
    start_time_ = state.time;
    starts_ = end_time_ == state.time ? ends_ : measure(problem, state, 0);
}

void HistoryWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    const std::vector<const BodyQuantity*> quantities = body_quantities(problem, state);
    ends_ = measure(problem, state, report.limited_domains);
    end_time_ = state.time;
    clock_.strike(start_time_, state.time, [&](double time, double weight) {
        std::vector<double> values = ends_;
        if (weight < 1.0) {
            ENSURE(starts_.size() == ends_.size());
            for (std::size_t k = 0; k < ends_.size(); ++k)
                if (!quantities[k]->is_counted) values[k] = std::lerp(starts_[k], ends_[k], weight);
            values.front() = time;
        }
        write(values);
    });
    file_.flush();
}

void HistoryWriter::write(const std::vector<double>& values)
{
    file_.add_numbers(values);
}

} // namespace quicksand
