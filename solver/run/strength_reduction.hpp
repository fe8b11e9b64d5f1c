// The factor of safety of a slope by strength reduction: the number by which cohesion and tan(friction) have
// to be divided for the slope to fail under its weight (Zienkiewicz, Humpheson and Lewis 1975; Griffiths and
// Lane 1999).
//
// For every factor the body relaxes under gravity with damping, on a fixed shape, from the stress in
// which it was stable with the last factor. It is stable if the forces come into balance, and fails
// otherwise: then its displacement grows far beyond that of an elastic body. The factor is found by
// bisection. A body that fails at the factor 1 comes to rest with the greatest strength first: at the end of
// a shaking it is out of balance, and what it moves by then is none of its failure.
#pragma once

#include "solver/problem/problem.hpp"
#include "solver/problem/state.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace quicksand {

struct StrengthReductionControls {
    double tolerance = 0.005; // width of the last bracket over the factor [-]
    double settled = 1e-5;    // out-of-balance force over weight and loads at which the slope stands [-]
    double damping = 0.7;     // local damping factor [-]
    double largest_displacement = 1.0; // over (gamma H + p) H / G, p the largest pressure of the loads, at
                                       // which the slope has failed [-]
    double crossings = 30.0; // a body that has not settled when a shear wave has crossed the grid's width and
                             // height so many times does not stand, unless it comes to rest later [-]
    double seismic_coefficient = 0.0; // k_h, horizontal force towards +x over weight [-]
    double greatest_factor = 32.0;    // beyond which the slope is safe [-]
};

/// Result for one factor.
struct StrengthTrial {
    double factor = 0.0; // F [-]
    bool stands = false;
    double displacement = 0.0;   // largest, since the first trial in which the body stood [m]
    double out_of_balance = 0.0; // out-of-balance force over weight and loads at the end [-]
    std::int64_t steps = 0;
};

struct SafetyFactor {
    double factor = 0.0;               // middle of the bracket, 0 where the body stands at no strength [-]
    double stands = 0.0, fails = 0.0;  // the bracket; fails is infinite above the greatest factor [-]
    std::vector<StrengthTrial> trials; // in the order in which they were made
    Particles failure; // displaced as in the last trial that failed, none when no trial failed
};

/// The soil of a failure that moves by a quarter or more of the largest displacement.
struct MovingSoil {
    double area = 0.0; // [m2]
    Vector2 low, high; // the box around its places before [m]
};

/// Of the particles displaced as in a failure, one at least.
MovingSoil moving_soil(const Particles& failure);

/// The problem with its strengths divided; laws without strength stay as they are.
Problem with_reduced_strength(const Problem& problem, double factor);

/// Whether a particle has a strength that can be reduced.
bool has_strength(const Problem& problem, const Particles& particles);

/// The factor of safety of a body at rest, its stress being the initial one. The pore pressure is held: what
/// exceeds the static one takes part. `state` keeps its shape and becomes that of the last factor at which
/// the body stood, if it did at any down to 1 / greatest_factor. Throws NumericalError.
SafetyFactor safety_factor(const Problem& problem, const StrengthReductionControls& controls, State& state,
                           const std::function<void(const StrengthTrial&)>& progress = {});

} // namespace quicksand
