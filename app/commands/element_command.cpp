#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/scene_setup.hpp"
#include "io/element/element_file.hpp"
#include "io/element/element_results.hpp"
#include "io/element/element_sheet.hpp"
#include "io/element/element_table.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/parallel_tasks.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <vector>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows = 1000; // that the terminal shows

fs::path find_test_file(const fs::path& file)
{
    if (!fs::exists(file)) {
        throw InputError("there is no file " + file.string() +
                         "\nhint: name a file of element tests, for example examples/element_dss/test.toml");
    }
    if (!fs::is_directory(file)) return file;
    if (fs::exists(file / "test.toml")) return file / "test.toml";
    throw InputError("the folder " + file.string() + " holds no test.toml\nhint: name the test file itself");
}

fs::path default_folder(const fs::path& test_file)
{
    const fs::path file = fs::absolute(test_file).lexically_normal();
    return fs::path("results") /
           (file.filename() == "test.toml" ? file.parent_path().filename() : file.stem());
}

/// A failure of the loading says which of the runs it was.
CyclicTest perform_named(const ElementOutcome& outcome, const ElementRun& run)
{
    try {
        return perform(outcome.specimen(run).soil.law, outcome.specimen(run).start, outcome.loading(run));
    } catch (const NumericalError& error) {
        FailureRecord record = error.record;
        const std::string label = run_label(outcome, run);
        record.phase = "element test " + outcome.test.name + (label.empty() ? "" : ", " + label);
        throw NumericalError(record);
    }
}

/// All tests of the kind, side by side on the threads: the strengths of the specimens, then the runs.
ElementOutcome perform_test(const ElementTest& test)
{
    ElementOutcome outcome{test, {}, {}};
    for (std::size_t specimen = 0; specimen < test.specimens.size(); ++specimen) {
        for (std::size_t loading = 0; loading < test.loadings.size(); ++loading)
            outcome.runs.push_back({specimen, loading, {}});
    }
    if (std::holds_alternative<StressCycles>(test.loadings.front()))
        outcome.strengths.resize(test.specimens.size());
    const std::size_t strengths = outcome.strengths.size(), tasks = strengths + outcome.runs.size();
    std::vector<std::exception_ptr> failures = attempt_each(tasks, [&](std::size_t k) {
        if (k < strengths) {
            const ElementSpecimen& specimen = test.specimens[k];
            outcome.strengths[k] = cyclic_strength(specimen.soil.law, specimen.start);
        } else {
            ElementRun& run = outcome.runs[k - strengths];
            run.result = perform_named(outcome, run);
        }
    });
    // the runs name themselves when they fail
    std::rotate(failures.begin(), failures.begin() + static_cast<std::ptrdiff_t>(strengths), failures.end());
    rethrow_first(failures);
    return outcome;
}

void report(const ElementOutcome& outcome, Journal& journal)
{
    journal.say("Test " + outcome.test.name);
    for (const std::string& line : describe_conditions(outcome)) journal.say("  " + line);
    for (const std::string& line : result_table(outcome, most_rows)) journal.say("    " + line);
    journal.say("");
}

} // namespace

ExitCode run_element_tests(const ElementChoice& choice)
{
    Journal journal;
    const ElementReading reading = read_element_file(find_test_file(choice.file), choice.overrides);
    const ElementProgramme& programme = reading.programme;
    if (!reading.warnings.empty()) journal.complain(reading.warnings.render(programme.text));
    ElementResults results(choice.directory.empty() ? default_folder(programme.file) : choice.directory,
                           programme);
    journal.keep(results.add("report.txt"));
    if (!programme.title.empty()) journal.say(programme.title + "\n");
    std::optional<FailureRecord> failure; // of the first test that fails; the others are done all the same
    for (const ElementTest& test : programme.tests) {
        try {
            const ElementOutcome outcome = perform_test(test);
            report(outcome, journal);
            write_element_csv(outcome, results);
            draw_element_pictures(outcome, programme.title, results);
        } catch (const NumericalError& error) {
            journal.say("Test " + test.name + "\n  fails: " + error.what() + "\n");
            if (!failure) failure = error.record;
        }
        results.finish();
    }
    journal.say("Look at " + (results.directory() / programme.tests.front().name / "report.png").string() +
                "; paths and tables are the CSV files beside it");
    if (failure) throw NumericalError(*failure);
    return ExitCode::good;
}

} // namespace quicksand
