#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/stress/rows/row_process.hpp"
#include "app/stress/rows/row_run.hpp"
#include "app/stress/rows/stress_figures.hpp"
#include "app/stress/rows/stress_report.hpp"
#include "app/stress/scenes/designed_set.hpp"
#include "app/stress/scenes/random_scene.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

StressRows all_rows(const StressChoice& choice)
{
    StressRows rows = designed_rows(choice.long_ones);
    for (int k = 1; k <= choice.random_scenes; ++k)
        for (StressRow& row : random_rows(choice.seed, k)) rows.push_back(std::move(row));
    return rows;
}

[[noreturn]] void refuse(const std::string& word)
{
    std::string groups;
    for (const std::string& group : stress_groups()) groups += (groups.empty() ? "" : ", ") + group;
    throw InputError("no row of the laboratory begins with '" + word + "'\nexpected: " + groups +
                     ", or more of a row's name\nhint: --random and --seed say which random rows there are, "
                     "and --long adds million_steps");
}

StressRows chosen_rows(const StressChoice& choice)
{
    StressRows rows = all_rows(choice);
    if (choice.rows.empty()) return rows;
    for (const std::string& word : choice.rows)
        if (std::none_of(rows.begin(), rows.end(),
                         [&](const StressRow& row) { return row.id().starts_with(word); }))
            refuse(word);
    std::erase_if(rows, [&](const StressRow& row) {
        return std::none_of(choice.rows.begin(), choice.rows.end(),
                            [&](const std::string& word) { return row.id().starts_with(word); });
    });
    return rows;
}

ExitCode run_alone(const StressChoice& choice)
{
    const StressRows rows = all_rows(choice);
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const StressRow& each) { return each.id() == choice.row; });
    if (row == rows.end()) refuse(choice.row);
    const RowFiles files = files_of(choice.directory, *row);
    write_row(*row, files);
    return run_row(*row, files);
}

/// The words with which a process runs a row alone.
std::vector<std::string> words_for(const StressRow& row, const StressChoice& choice)
{
    std::vector<std::string> words = {"stress",
                                      "--row",
                                      row.id(),
                                      "--random",
                                      std::to_string(choice.random_scenes),
                                      "--seed",
                                      std::to_string(choice.seed),
                                      "-o",
                                      choice.directory.string()};
    if (choice.long_ones) words.emplace_back("--long");
    return words;
}

std::vector<RowOutcome> run_rows(const StressRows& rows, const StressChoice& choice, Journal& journal)
{
    std::vector<RowFiles> files;
    std::vector<std::vector<std::string>> words;
    for (const StressRow& row : rows) {
        files.push_back(files_of(choice.directory, row));
        fs::create_directories(files.back().folder);
        words.push_back(words_for(row, choice));
    }
    std::vector<RowOutcome> outcomes(rows.size());
    const ProcessLimits limits{choice.threads > 0 ? choice.threads : thread_count(), choice.limit};
    run_processes(words, files, limits, [&](std::size_t k, const ProcessEnd& end) {
        outcomes[k] = read_outcome(rows[k], files[k], end);
        journal.say(describe_row(outcomes[k]));
        const bool is_well = outcomes[k].end == RowEnd::good && !is_silent(outcomes[k]);
        if (is_well && outcomes[k].bad_file.empty()) remove_results(files[k]);
    });
    compare_twins(outcomes);
    return outcomes;
}

} // namespace

ExitCode stress_solver(const StressChoice& choice)
{
    if (!choice.row.empty()) return run_alone(choice);
    const auto start = std::chrono::steady_clock::now();
    const StressRows rows = chosen_rows(choice);
    Journal journal;
    fs::create_directories(choice.directory);
    journal.keep(choice.directory / "stress.txt");
    journal.say(row_heading());
    const std::vector<RowOutcome> outcomes = run_rows(rows, choice, journal);

    const StressSummary summary = summarize(outcomes);
    constexpr std::size_t most_lines = 20;
    journal.say('\n' + describe_summary(summary, most_lines));
    write_stress_csv(choice.directory / "stress.csv", outcomes);
    const std::vector<fs::path> figures =
        draw_pictures({plot_drawing(outcome_plot(outcomes), choice.directory / "stress.png")});
    write_stress_page(choice.directory / "stress.md", outcomes, figures);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    journal.say(fmt::format("{} rows in {}. Page, table and figure: {}", rows.size(), duration_text(seconds),
                            choice.directory.string()));
    return summary.silent.empty() ? ExitCode::good : ExitCode::numerical;
}

} // namespace quicksand
