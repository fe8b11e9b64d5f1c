// A run of a body: what is computed of it, its two stages in their order, and one way to stop both.
//
//   StagedRun run(body, initial, controls);                // with `kept` as well, to go on from it
//   if (!run.is_shaking()) run.settle(relaxation);         // or run.begin_shaking(), without settling
//   const bool finished = run.shake(observers, stop);
#pragma once

#include "solver/columns/soil_column.hpp"
#include "solver/run/simulation.hpp"
#include "solver/run/stage_start.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Which columns of cells a run computes where all of them are the same.
enum class ColumnsComputed { one, all };

struct RunControls {
    double end_time = 0.0; // of the shaking [s]
    ColumnsComputed columns = ColumnsComputed::all;
    bool keeps_balances = false; // balances from the start of the shaking
};

/// One column of cells is computed for the whole body where the controls let it; observers are shown the
/// body all the same. After a stop, a run that goes on from the state comes to the same bits.
class StagedRun {
public:
    /// `initial` is the state of the body as drawn; `kept` the state of an earlier part of this run, in
    /// either stage. The body outlives the run and its copies.
    StagedRun(const Problem& body, State initial, const RunControls& controls,
              std::optional<State> kept = std::nullopt);

    /// Begin with the end of another run's stage: to settle anew, or to go on shaking from time zero. Before
    /// anything is computed. Throws InputError where it was one column or a body and this run is not.
    void go_on_from(State reached, const StageStart& start);

    const Problem& body() const { return *body_; }
    /// The computed problem: the body, or the column that represents it.
    const Problem& problem() const { return column() ? column()->problem : *body_; }
    const State& state() const { return column() ? column()->state : state_; }
    /// The column that represents the body; null without one; `obstacle` has the reason, see ColumnSearch.
    const SoilColumn* column() const { return search_.column ? &*search_.column : nullptr; }
    const std::string& obstacle() const { return search_.obstacle; }
    /// The whole body's state; true until the run goes on.
    const State& state_of_body();

    /// Whether the shaking has begun.
    bool is_shaking() const { return is_shaking_; }
    bool is_finished() const { return is_shaking_ && state().time >= controls_.end_time; }

    /// Settle, and begin the shaking unless it was stopped; see relax(). Before the shaking.
    RelaxationReport settle(const RelaxationControls& relaxation, const SettlingWatcher& progress = {},
                            const StopRule& stop = {});

    /// Begin the shaking from the stress as it is; returns what begin_shaking() of the problem does. Before
    /// the shaking.
    std::size_t begin_shaking();

    /// Shake; returns whether the end time is reached, false after a stop. See run(). Throws NumericalError.
    bool shake(const std::vector<Observer*>& observers, const StopRule& stop = {});

private:
    State& computed() { return search_.column ? search_.column->state : state_; }
    void enter_shaking();

    const Problem* body_;
    RunControls controls_;
    ColumnSearch search_;
    State state_; // of the body, unless a column represents it
    State wide_;  // of the body, where one does
    bool is_shaking_ = false;
};

} // namespace quicksand
