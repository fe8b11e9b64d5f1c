// What a run changes: time, step count and the particles. A checkpoint of it resumes to the same bits.
#pragma once

#include "solver/particles.hpp"

#include <cstdint>

namespace quicksand {

/// The stages of a run, in their order.
enum class Stage {
    relaxation, // damped settling under gravity, drained, time not counted
    shaking,    // the two-phase run from t = 0
};

struct State {
    Stage stage = Stage::shaking;
    double time = 0.0;     // t since the start of shaking [s]
    std::int64_t step = 0; // steps taken in this stage [-]
    Particles particles;
};

} // namespace quicksand
