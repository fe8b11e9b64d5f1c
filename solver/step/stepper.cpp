#include "solver/step/stepper.hpp"

#include "solver/boundaries/node_response.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/step/two_phase_step.hpp"

namespace quicksand {

namespace {

/// A stepper with the workspace of its step.
template <class Workspace>
class WorkingStepper : public Stepper {
public:
    explicit WorkingStepper(Workspace work) : work_(std::move(work)) {}
    std::int64_t limited_domains() const override { return work_.limited_domains; }
    PhaseTimers& timers() override { return work_.timers; }
    void restart() override {}
    const StepWorkspace& workspace() const override { return work_; }
    std::optional<Vector2> mean_velocity(std::size_t node) const override
    {
        if (!work_.sums[work_.conditions.master[node]].active()) return std::nullopt;
        const auto& motion = work_.motion[node];
        return 0.5 * (velocity_before(motion) + solid_velocity(motion));
    }

protected:
    Workspace work_;
};

class TwoPhaseStepper : public WorkingStepper<TwoPhaseWorkspace> {
public:
    using WorkingStepper::WorkingStepper;
    void advance(const Problem& problem, double dt, State& state) override
    {
        advance_two_phase_step(problem, dt, state, work_);
    }
};

class SemiImplicitStepper : public WorkingStepper<SemiImplicitWorkspace> {
public:
    using WorkingStepper::WorkingStepper;
    void advance(const Problem& problem, double dt, State& state) override
    {
        advance_semi_implicit_step(problem, dt, state, work_);
    }
    void restart() override { work_.pressure.blocks_are_due = true; }
    double acting_increment(std::size_t p) const override
    {
        return work_.pressure.increment[static_cast<std::size_t>(work_.lists.cell_of_particle[p])];
    }
};

class SinglePhaseStepper : public WorkingStepper<SinglePhaseWorkspace> {
public:
    using WorkingStepper::WorkingStepper;
    void advance(const Problem& problem, double dt, State& state) override
    {
        advance_single_phase_step(problem, dt, 0.0, state, work_);
    }
};

} // namespace

std::unique_ptr<Stepper> make_stepper(const Problem& problem)
{
    if (water_flow(problem) != WaterFlow::coupled)
        return std::make_unique<SinglePhaseStepper>(make_single_phase_workspace(problem));
    if (problem.scheme != TimeScheme::explicit_steps)
        return std::make_unique<SemiImplicitStepper>(make_semi_implicit_workspace(problem));
    return std::make_unique<TwoPhaseStepper>(make_two_phase_workspace(problem));
}

} // namespace quicksand
