#include "app/commands/commands.hpp"
#include "app/run/journal.hpp"
#include "app/run/number_format.hpp"
#include "app/run/stop_signal.hpp"
#include "app/sweep/engine_files.hpp"
#include "app/sweep/process_pool.hpp"
#include "app/sweep/sweep_collection.hpp"
#include "geometry/drawing/gmsh_file.hpp"
#include "io/files/file_error.hpp"
#include "io/files/folder_lock.hpp"
#include "io/files/output_folder.hpp"
#include "io/results/results_folder.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr const char* table_file = "runs.csv"; // marks the folder of a sweep

/// The last line that a process has written; of one that failed it tells why.
std::string last_line(const fs::path& log)
{
    std::string last;
    std::ifstream stream(log);
    for (std::string line; std::getline(stream, line);)
        if (!line.empty()) last = line;
    return last;
}

/// A run's end as a line. The manifest knows more than the exit code, where there is one.
std::string describe_end(const SweepOutcome& outcome, const PoolEnd& end, const fs::path& log)
{
    const std::string& folder = outcome.checked.run.folder;
    const std::string after = " after " + duration_text(end.seconds);
    if (outcome.state == "finished") return folder + ": " + outcome.verdict + after;
    if (outcome.state == "stopped") return folder + ": stopped" + after;
    if (end.code < 0) return fmt::format("{}: ended by signal {}{}", folder, -end.code, after);
    return fmt::format("{}: failed with exit code {}{}: {}\n  its messages: {}", folder, end.code, after,
                       outcome.reason.empty() ? last_line(log) : outcome.reason, log.string());
}

std::vector<PoolTask> tasks_of(const SweepPlan& plan)
{
    std::vector<PoolTask> tasks;
    for (const std::size_t k : plan.left) {
        const CheckedRun& run = plan.runs[k];
        tasks.push_back({words_of(plan, run), plan.folder / "logs" / (run.run.folder + ".txt")});
    }
    return tasks;
}

/// Do what is left; whether a run failed.
bool run_here(const SweepPlan& plan, Journal& journal)
{
    const StopSignal signal;
    // gmsh reads a drawing once for all runs that have its parameters; a user's own folder stays
    setenv(drawing_store_variable, drawings_of(plan).c_str(), 0);
    const std::vector<PoolTask> tasks = tasks_of(plan);
    std::size_t done = plan.runs.size() - tasks.size();
    bool failed = false;
    run_pool(tasks, plan.jobs, [&](std::size_t k, const PoolEnd& end) {
        const SweepOutcome outcome = read_outcomes({plan.runs[plan.left[k]]}, plan.folder).front();
        const bool ended_well = outcome.state == "finished" || outcome.state == "stopped";
        failed = failed || (!ended_well && !StopSignal::received());
        journal.say(
            fmt::format("{} ({} of {})", describe_end(outcome, end, tasks[k].log), ++done, plan.runs.size()));
    });
    if (StopSignal::received()) journal.say("Stopped on request. The same command goes on.");
    return failed;
}

void require_sweep(const SweepPlan& plan)
{
    if (!fs::exists(plan.folder / table_file))
        throw InputError("there is no sweep in " + plan.folder.string() +
                         ": no runs.csv\nhint: start it without --collect, or name its folder with -o");
}

} // namespace

ExitCode run_sweep(const SweepChoice& choice)
{
    const SweepPlan plan = plan_sweep(choice);
    Journal journal;
    if (choice.dry_run) {
        journal.say(describe_plan(plan));
        return ExitCode::good;
    }
    if (choice.collect) {
        require_sweep(plan);
        collect_sweep(plan, journal);
        return ExitCode::good;
    }
    make_output_folder(plan.folder, table_file);
    const FolderLock lock(plan.folder);
    write_runs_csv(plan.folder / table_file, plan.sweep, plan.runs);
    fs::create_directories(plan.folder / "logs");
    if (choice.engine != "local") {
        const std::string command = write_engine_files(plan, choice.engine);
        journal.say(fmt::format("{} runs in {}. Start them with\n  {}\nand when they have ended\n  {}",
                                plan.runs.size(), (plan.folder / "commands.txt").string(), command,
                                shell_line({"quicksand", "sweep", fs::absolute(plan.sweep.file).string(),
                                            "-o", plan.folder.string(), "--collect"})));
        return ExitCode::good;
    }
    journal.go_on_with(plan.folder / "sweep.txt");
    journal.say(fmt::format("{}: {} runs, {} left to do, {} at a time with {} each; results in {}",
                            plan.sweep.title.empty() ? plan.sweep.file.string() : plan.sweep.title,
                            plan.runs.size(), plan.left.size(), plan.jobs, threads_text(plan.threads),
                            plan.folder.string()));
    const bool failed = run_here(plan, journal);
    collect_sweep(plan, journal);
    return failed ? ExitCode::numerical : ExitCode::good;
}

} // namespace quicksand
