#include "app/commands/commands.hpp"
#include "app/run/number_format.hpp"
#include "app/verify/verification_runs.hpp"
#include "app/verify/verification_table.hpp"
#include "io/pictures/verification_figure.hpp"
#include "io/results/verification_csv.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/threads.hpp"
#include "solver/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

double limit_on(const SceneVerification& verification, const std::string& quantity, int cells)
{
    const auto limits = verification.limits.find(quantity);
    if (limits == verification.limits.end()) return std::numeric_limits<double>::infinity();
    const auto grid = std::find(verification.cells.begin(), verification.cells.end(), cells);
    ENSURE(grid != verification.cells.end());
    return limits->second[static_cast<std::size_t>(grid - verification.cells.begin())];
}

/// A limit or an order of a quantity that the study does not measure is a mistake of the scene.
void check_quantities(const VerificationRun& run)
{
    std::string known;
    std::vector<std::string> names;
    for (const StudyError& error : run.errors) {
        names.push_back(error.quantity);
        known += (known.empty() ? "\"" : ", \"") + error.quantity + '"';
    }
    const auto refuse_unknown = [&](const std::string& quantity, const SourcePlace& place) {
        if (std::find(names.begin(), names.end(), quantity) != names.end()) return;
        Diagnostics findings;
        findings.add(error_at(place, "quantity", run.problem + " measures no \"" + quantity + "\"", known));
        throw InputError(findings.render(""));
    };
    for (const auto& [quantity, limits] : run.verification.limits)
        refuse_unknown(quantity, run.verification.limits_place);
    for (const auto& [quantity, order] : run.verification.orders)
        refuse_unknown(quantity, run.verification.orders_place);
}

/// The quantities of the runs [first, last) of one problem, over its grids.
std::vector<Convergence> collect(const std::vector<VerificationRun>& runs, std::size_t first,
                                 std::size_t last)
{
    std::vector<Convergence> results;
    const VerificationRun& coarsest = runs[first];
    const SceneVerification& verification = coarsest.verification;
    for (std::size_t q = 0; q < coarsest.errors.size(); ++q) {
        Convergence result;
        result.problem = coarsest.problem;
        result.title = coarsest.title;
        result.length = verification.length;
        result.quantity = coarsest.errors[q].quantity;
        result.norm = coarsest.errors[q].norm;
        result.reference = coarsest.study->reference;
        const auto order = verification.orders.find(result.quantity);
        if (order != verification.orders.end()) result.least_order = order->second;
        for (std::size_t k = first; k < last; ++k) {
            ENSURE(runs[k].errors.size() == coarsest.errors.size());
            result.cells.push_back(runs[k].cells);
            result.errors.push_back(runs[k].errors[q].error);
            result.limits.push_back(limit_on(verification, result.quantity, runs[k].cells));
            result.seconds.push_back(runs[k].seconds);
        }
        results.push_back(std::move(result));
    }
    return results;
}

/// The problem's runs begin at `first`; where those of the next one begin.
std::size_t end_of_problem(const std::vector<VerificationRun>& runs, std::size_t first)
{
    std::size_t last = first;
    while (last < runs.size() && runs[last].problem == runs[first].problem) ++last;
    return last;
}

/// Tell what went wrong with a run; only a numerical failure lets the other problems be told.
void complain(const VerificationRun& run, Journal& journal)
{
    try {
        std::rethrow_exception(run.failure);
    } catch (const NumericalError& error) {
        journal.complain(fmt::format("{}, {} cells: {}", run.problem, run.cells, error.what()));
    } catch (const InputError& error) {
        throw InputError(run.problem + ": " + error.what());
    }
}

struct Outcome {
    std::vector<Convergence> results;
    std::vector<Drawing> figures;
    bool failed = false; // a run failed
};

Outcome evaluate(const std::vector<VerificationRun>& runs, const fs::path& directory, Journal& journal)
{
    Outcome outcome;
    for (std::size_t first = 0, last = 0; first < runs.size(); first = last) {
        last = end_of_problem(runs, first);
        bool whole = true;
        for (std::size_t k = first; k < last; ++k) {
            if (!runs[k].failure) continue;
            complain(runs[k], journal);
            whole = false;
        }
        outcome.failed = outcome.failed || !whole;
        if (!whole) continue;
        check_quantities(runs[first]);
        const std::vector<Convergence> results = collect(runs, first, last);
        if (last - first > 1) {
            outcome.figures.push_back(
                plot_drawing(convergence_plot(results), directory / (runs[first].problem + ".png")));
        }
        outcome.results.insert(outcome.results.end(), results.begin(), results.end());
    }
    return outcome;
}

} // namespace

ExitCode verify_problems(const VerifyChoice& choice)
{
    const auto start = std::chrono::steady_clock::now();
    Journal journal;
    std::vector<VerificationRun> runs = prepare_runs(choice);
    fs::create_directories(choice.directory);
    journal.keep(choice.directory / "verification.txt");
    execute_runs(choice.threads > 0 ? choice.threads : thread_count(), runs, journal);

    const Outcome outcome = evaluate(runs, choice.directory, journal);
    journal.say('\n' + describe_convergence(outcome.results));
    write_verification_csv(choice.directory / "verification.csv", outcome.results);
    draw_pictures(outcome.figures);
    const auto missed = std::count_if(outcome.results.begin(), outcome.results.end(),
                                      [](const Convergence& result) { return !meets_requirements(result); });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    journal.say(fmt::format("{} quantities in {}; {} miss what is required. Table and figures: {}",
                            outcome.results.size(), duration_text(seconds), missed,
                            choice.directory.string()));
    if (outcome.failed) return ExitCode::numerical;
    return missed > 0 ? ExitCode::inaccurate : ExitCode::good;
}

} // namespace quicksand
