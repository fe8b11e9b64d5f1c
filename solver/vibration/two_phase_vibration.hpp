// Small motions of a saturated body with two velocities, explicit and semi-implicit.
#pragma once

#include "solver/problem/state.hpp"
#include "solver/step/two_phase_step.hpp"
#include "solver/vibration/nodal_equations.hpp"
#include "solver/vibration/small_motion.hpp"

#include <cstddef>
#include <vector>

namespace quicksand {

/// The equations of a step of length dt from the state. Velocities of the grains and fluxes have four
/// components for a node, as the forces of stress and pressure. The state is copied. Throws NumericalError.
class TwoPhaseEquations : public NodalEquations {
public:
    TwoPhaseEquations(const Problem& problem, const State& state, double dt);

    Scalars root_masses() const override;
    void deform(const Scalars& velocity, Scalars& force) override;
    void respond(const Scalars& force, Scalars& velocity) override;

private:
    static constexpr std::size_t components = 4; // of a node: grains and flux, or stress and pressure
    bool is_semi_implicit() const { return problem_.scheme == TimeScheme::semi_implicit; }
    /// Velocities of the nodes that follow from the forces and momenta of the sums.
    void solve_velocities();
    /// Leave as the only load the momenta of the motion that the particles do not give back, R (1 - F) v.
    void keep_lost_momenta();

    Problem problem_, small_; // small_: its form of small motion
    State state_;
    double half_step_; // A = 4 (R + dt/2 (C'-C'') J + (dt/2)^2 Q): a step of half the length [s]
    SemiImplicitWorkspace work_;
    TangentModuli moduli_;
    std::vector<TwoPhaseSums> restoring_; // sums of which only the forces count
};

} // namespace quicksand
