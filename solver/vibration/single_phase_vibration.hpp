// Small motions of a body that moves as one phase: dry, drained or undrained.
#pragma once

#include "solver/problem/state.hpp"
#include "solver/step/single_phase_step.hpp"
#include "solver/vibration/nodal_equations.hpp"
#include "solver/vibration/small_motion.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

/// The equations of a step from the state; dt does not appear in them. Two components for a node. The state
/// is copied. Throws NumericalError.
class SinglePhaseEquations : public NodalEquations {
public:
    SinglePhaseEquations(const Problem& problem, const State& state);

    Scalars root_masses() const override;
    void deform(const Scalars& velocity, Scalars& force) override;
    void respond(const Scalars& force, Scalars& velocity) override;

private:
    static constexpr std::size_t components = 2; // of a node
    /// Velocities of the nodes that follow from the forces and momenta of the sums.
    void solve_velocities();
    /// Leave as the only load the momenta of the motion that the particles do not give back, R (1 - F) v.
    void keep_lost_momenta();

    Problem problem_, small_; // small_: its form of small motion
    State state_;
    SinglePhaseWorkspace work_;
    TangentModuli moduli_;
    std::vector<SinglePhaseSums> restoring_; // sums of which only the forces count
};

} // namespace quicksand
