#include "io/results/history_csv.hpp"

#include "solver/measure/body_quantities.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

std::vector<std::string> column_names(const Problem& problem, const State& state)
{
    std::vector<std::string> names;
    for (const BodyQuantity* quantity : body_quantities(problem, state))
        names.push_back(column_name(*quantity));
    return names;
}

CsvFile open_file(const Problem& problem, const State& state, const RunLabel& label,
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
      file_(open_file(problem, state, label, path, resume)), crest_(reference_crest(state.particles))
{
    clock_.go_on(state.time, file_.last_time());
}

void HistoryWriter::observe(const Problem& problem, const State& state, const StepReport& report)
{
    const MeasuredBody body = measure_body(problem, state, crest_, report.limited_domains);
    CsvRow row;
    for (const BodyQuantity* quantity : body_quantities(problem, state))
        row.push_back(csv_number(quantity->value(body)));
    file_.add_row(row);
    file_.flush();
    clock_.advance();
}

} // namespace quicksand
