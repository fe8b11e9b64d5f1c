#include "solver/run/staged_run.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/balances.hpp"
#include "solver/run/column_observer.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace quicksand {

StagedRun::StagedRun(const Problem& body, State initial, const RunControls& controls,
                     std::optional<State> kept)
    : body_(&body), controls_(controls)
{
    if (controls.columns == ColumnsComputed::one) search_ = find_soil_column(body, initial);
    const bool is_of_all_columns =
        kept && search_.column && kept->particles.size() != search_.column->state.particles.size();
    if (is_of_all_columns) search_.column.reset();
    if (!search_.column) state_ = std::move(initial);
    if (!kept) return;
    is_shaking_ = kept->stage == Stage::shaking;
    computed() = std::move(*kept);
}

void StagedRun::go_on_from(State reached, const StageStart& start)
{
    ENSURE(!is_shaking_);
    computed() = begin_stage(problem(), state(), std::move(reached), start);
    if (start.settles) return;
    enter_shaking();
}

const State& StagedRun::state_of_body()
{
    if (!column()) return state_;
    widen(*column(), state(), wide_);
    return wide_;
}

RelaxationReport StagedRun::settle(const RelaxationControls& relaxation, const SettlingWatcher& progress,
                                   const StopRule& stop)
{
    ENSURE(!is_shaking_);
    RelaxationReport report = relax(problem(), relaxation, computed(), progress, stop);
    if (column()) report.at_failure *= column()->repeats();
    if (report.settled) enter_shaking();
    return report;
}

std::size_t StagedRun::begin_shaking()
{
    ENSURE(!is_shaking_);
    const std::size_t limited = quicksand::begin_shaking(problem(), computed());
    enter_shaking();
    return column() ? limited * column()->repeats() : limited;
}

void StagedRun::enter_shaking()
{
    is_shaking_ = true;
    if (controls_.keeps_balances) open_balances(problem(), computed());
}

bool StagedRun::shake(const std::vector<Observer*>& observers, const StopRule& stop)
{
    ENSURE(is_shaking_);
    if (!column()) return run(*body_, controls_.end_time, observers, state_, stop);
    std::vector<Observer*> at_ends = observers;
    const auto within = std::stable_partition(at_ends.begin(), at_ends.end(), [](const Observer* observer) {
        return !observer->looks_into_steps();
    });
    ColumnObserver into_steps(*column(), *body_, {within, at_ends.end()});
    at_ends.erase(within, at_ends.end());
    ColumnObserver at_ends_of_steps(*column(), *body_, at_ends);
    return run(problem(), controls_.end_time, {&at_ends_of_steps, &into_steps}, computed(), stop);
}

} // namespace quicksand
