// How the pore water moves relative to the grains.
#pragma once

namespace quicksand {

/// What is solved of the relative motion. A form that leaves it out has one velocity, that of grains and
/// water together, and the inertia of both.
enum class WaterFlow {
    coupled,   // water has a velocity of its own
    undrained, // none: the pressure follows from the change of the soil's volume
    drained,   // water comes and goes without resistance: no excess pressure, pores stay full
};

} // namespace quicksand
