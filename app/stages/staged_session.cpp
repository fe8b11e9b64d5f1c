#include "app/stages/staged_session.hpp"

#include "app/run/stop_signal.hpp"
#include "app/stages/former_run.hpp"
#include "app/stages/run_origin.hpp"
#include "app/stages/stability_search.hpp"
#include "io/assembly/case_checks.hpp"
#include "io/results/run_record.hpp"
#include "io/results/stage_table.hpp"
#include "io/tables/stage_keys.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

/// Where a run begins that goes on from the results `before`; none for one that begins as drawn or is
/// resumed.
std::optional<Origin> origin_of_run(const std::optional<fs::path>& before, const RunChoice& choice,
                                    const SceneSetup& setup, Journal& journal)
{
    if (!before || choice.resume) return std::nullopt;
    Origin origin = origin_from(*before, setup.keys, setup.assembled);
    for (const std::string& warning : origin.warnings) journal.say(warning);
    return origin;
}

/// Have particles parted as in its own results where it is resumed, and else as in those before it.
void part_as_before(const RunChoice& chosen, const std::optional<fs::path>& before, SceneReading& reading)
{
    if (chosen.resume && fs::exists(ResultsFolder{chosen.directory}.manifest())) {
        resume_as_in(chosen.directory, reading);
    } else if (before) {
        part_as_in(*before, reading);
    }
}

/// The stages on their way: what each has come to, and where the next one goes on from.
class StageSequence {
public:
    StageSequence(const RunChoice& choice, std::vector<SceneReading> stages, fs::path directory)
        : choice_(choice), stages_(std::move(stages)), directory_(std::move(directory))
    {
        if (choice.from.empty()) return;
        before_ = folder_of_end(choice.from);
        const auto same = std::find_if(stages_.begin(), stages_.end(), [&](const SceneReading& reading) {
            return reading.scene.stage->name == before_->filename();
        });
        if (same != stages_.end()) next_ = static_cast<std::size_t>(same - stages_.begin()) + 1;
        if (next_ == stages_.size())
            throw InputError("--from " + choice.from +
                             " is the last stage of this scene: nothing is left to run");
    }

    SessionOutcome run(Journal& journal)
    {
        require_room();
        require_beginning();
        require_sound(stages_);
        const StopSignal signal; // also between the stages, and while one is set up
        SessionOutcome outcome;
        for (; next_ < stages_.size(); ++next_) {
            if (StopSignal::received()) return stop_before(outcome, journal);
            outcome = run_next(journal);
            if (outcome.end == SessionEnd::stopped && stage().kind == StageKind::stability) return outcome;
            rows_.push_back(row_of(outcome.folder));
            fs::create_directories(directory_);
            write_stage_table(directory_, rows_and_what_follows());
            if (outcome.end != SessionEnd::finished) break;
            if (stage().kind != StageKind::stability) before_ = outcome.folder.directory;
        }
        return outcome;
    }

private:
    /// Of a run that is taken up again: also the stages of the scene that it has still to come to, as they
    /// are.
    std::vector<StageRow> rows_and_what_follows() const
    {
        std::vector<StageRow> rows = rows_;
        if (!choice_.resume && !choice_.go_on) return rows;
        for (StageRow& former : read_stage_table(directory_)) {
            const auto is_former = [&](const StageRow& row) { return row.name == former.name; };
            const auto is_its_stage = [&](const SceneReading& stage) {
                return stage.scene.stage->name == former.name;
            };
            if (std::none_of(rows_.begin(), rows_.end(), is_former) &&
                std::any_of(stages_.begin(), stages_.end(), is_its_stage))
                rows.push_back(std::move(former));
        }
        return rows;
    }

    /// The request came when the stage before had no step left, or while none was under way.
    SessionOutcome stop_before(SessionOutcome outcome, Journal& journal) const
    {
        journal.say("Stopped on request before stage " + stage().name +
                    ". Go on with the same command and --resume.");
        outcome.end = SessionEnd::stopped;
        return outcome;
    }

    /// A former run in the folder of a later stage is told before hours of earlier ones.
    void require_room() const
    {
        if (choice_.resume || choice_.go_on || choice_.overwrite) return;
        for (std::size_t k = next_; k < stages_.size(); ++k)
            if (stages_[k].scene.stage->kind != StageKind::stability)
                require_no_former_run(directory_ / stages_[k].scene.stage->name, stages_[k].scene);
    }

    /// A run that began with the end of another one goes on from there, not with stages that it never had.
    void require_beginning() const
    {
        if (!(choice_.resume || choice_.go_on) || !choice_.from.empty()) return;
        std::string missing;
        for (const SceneReading& reading : stages_) {
            const SceneStage& each = *reading.scene.stage;
            if (each.kind == StageKind::stability) continue;
            const bool is_there = fs::exists(ResultsFolder{directory_ / each.name}.manifest());
            if (!is_there && missing.empty()) missing = each.name;
            if (is_there && !missing.empty())
                throw InputError(
                    fmt::format("{} has results of the stage {} and none of {} before it: the run "
                                "began with the end of another one, or that stage is new or was deleted"
                                "\nhint: go on with the same --from RESULTS:STAGE, or run all stages anew "
                                "with --overwrite",
                                directory_.string(), each.name, missing));
        }
    }

    const SceneStage& stage() const { return *stages_[next_].scene.stage; }

    SessionOutcome run_next(Journal& journal)
    {
        journal.say(fmt::format("Stage {} of {}: {} ({})", next_ + 1, stages_.size(), stage().name,
                                word_of_kind(stage().kind)));
        const fs::path folder = directory_ / stage().name;
        RunChoice chosen = choice_;
        chosen.directory = folder;
        if (is_finished(folder, chosen)) {
            journal.say("  finished already");
            return {SessionEnd::finished, {folder}};
        }
        Journal of_stage; // keeps the log of the stage
        SceneReading reading = stages_[next_];
        part_as_before(chosen, before_, reading);
        SceneSetup setup = set_up_reading(choice_.scene, std::move(reading), of_stage);
        if (stage().kind == StageKind::stability) return find_safety(folder, std::move(setup), of_stage);
        std::optional<Origin> origin = origin_of_run(before_, chosen, setup, of_stage);
        return run_session(chosen, std::move(setup), of_stage, std::move(origin));
    }

    /// With --resume and --continue; `chosen` then takes up what there is of an unfinished stage.
    bool is_finished(const fs::path& folder, RunChoice& chosen) const
    {
        if (!choice_.resume && !choice_.go_on) return false;
        if (stage().kind == StageKind::stability) {
            const std::optional<double> factor = read_factor_of_safety({folder});
            return factor && (before_ || *factor > 0.0);
        }
        const FormerRun former = former_run({folder}, hashes_of(choice_.scene, stages_[next_]));
        take_up(former, chosen);
        const bool is_another = former == FormerRun::none && fs::exists(ResultsFolder{folder}.manifest());
        if (is_another) chosen.resume = choice_.resume; // and is refused with what has changed
        return former == FormerRun::finished;
    }

    SessionOutcome find_safety(const fs::path& directory, SceneSetup setup, Journal& journal)
    {
        const ResultsFolder folder =
            prepare_report_folder(directory, stability_report, setup.assembled.scene);
        journal.keep(folder.directory / stability_report);
        State& state = setup.assembled.state;
        if (before_) {
            state = end_as_state(*before_, setup);
        } else {
            begin_shaking(setup.assembled.problem, state);
        }
        weaken_liquefied({stage().residual_strength, stage().liquefied_ru}, setup.assembled, state, journal);
        StrengthReductionControls controls;
        controls.seismic_coefficient = stage().seismic_coefficient;
        try {
            const SafetyFactor safety = search_stability(setup.assembled, controls, state, folder, journal);
            if (!before_) require_standing(safety);
        } catch (const SearchStopped&) {
            journal.say("Stopped on request. Go on with the same command and --resume.");
            return {SessionEnd::stopped, folder};
        }
        return {SessionEnd::finished, folder};
    }

    StageRow row_of(const ResultsFolder& folder) const
    {
        StageRow row;
        row.name = stage().name;
        row.kind = word_of_kind(stage().kind);
        row.start = rows_.empty() ? 0.0 : rows_.back().start + rows_.back().duration;
        if (stage().kind == StageKind::stability) {
            row.status = "finished";
            row.factor_of_safety = read_factor_of_safety(folder);
            return row;
        }
        const RunRecord record = read_run_record(folder.manifest());
        row.status = record.status;
        row.duration = record.simulated_time;
        return row;
    }

    const RunChoice& choice_;
    std::vector<SceneReading> stages_;
    fs::path directory_;
    std::size_t next_ = 0;
    std::optional<fs::path> before_; // results whose end the next stage goes on from
    std::vector<StageRow> rows_;
};

SessionOutcome run_whole(const RunChoice& choice, SceneReading reading, Journal& journal)
{
    RunChoice chosen = choice;
    if (chosen.directory.empty()) chosen.directory = default_results(reading.scene.file);
    if (choice.go_on) {
        const FormerRun former = former_run({chosen.directory}, hashes_of(choice.scene, reading));
        take_up(former, chosen);
        if (former == FormerRun::finished) {
            journal.say("Nothing to do: the run in " + chosen.directory.string() + " is finished.");
            return {SessionEnd::finished, {}};
        }
    }
    std::optional<fs::path> before;
    if (!choice.from.empty()) before = folder_of_end(choice.from);
    part_as_before(chosen, before, reading);
    SceneSetup setup = set_up_reading(choice.scene, std::move(reading), journal);
    std::optional<Origin> origin = origin_of_run(before, chosen, setup, journal);
    return run_session(chosen, std::move(setup), journal, std::move(origin));
}

} // namespace

SessionOutcome run_stages(const RunChoice& choice, std::vector<SceneReading> stages, Journal& journal)
{
    if (!stages.front().scene.stage) return run_whole(choice, std::move(stages.front()), journal);
    const fs::path directory =
        choice.directory.empty() ? default_results(stages.front().scene.file) : choice.directory;
    return StageSequence(choice, std::move(stages), directory).run(journal);
}

} // namespace quicksand
