// The stages of a run.
#pragma once

namespace quicksand {

/// In their order.
enum class Stage {
    relaxation, // damped settling under gravity, drained, time not counted
    shaking,    // the two-phase run from t = 0
};

} // namespace quicksand
