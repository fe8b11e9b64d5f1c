// How stiff the skeleton of a few particles is, for the time step.
#pragma once

namespace quicksand {

/// P-wave moduli of unloading at the particles' present state, per present volume, in the stiffest direction.
struct ParticleModuli {
    double mean = 0.0;     // over their volume [Pa]
    double stiffest = 0.0; // of any of them [Pa]
};

} // namespace quicksand
