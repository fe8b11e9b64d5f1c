// The quantities that results tell of the whole body, one row each: history.csv, the picture of the history
// and io/RESULTS.md follow from this table.
#pragma once

#include "solver/measure/balances.hpp"
#include "solver/measure/monitors.hpp"
#include "solver/measure/pressure_oscillations.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// The body at one moment and what has been measured of it.
struct MeasuredBody {
    const Problem& problem;
    const State& state;
    Monitors monitors;
    PressureOscillations oscillations;
    BalanceErrors balance;            // of a run with balances, zeros otherwise
    std::int64_t limited_domains = 0; // particle domains scaled down in the last step [-]
};

/// `crest` are the lasting numbers of the particles at the crest.
MeasuredBody measure_body(const Problem& problem, const State& state, const std::vector<std::int32_t>& crest,
                          std::int64_t limited_domains);

/// Which runs have a quantity of the body.
enum class BodyQuantityOf : std::uint8_t {
    any_body,
    small_body,         // of a run in small strain
    wet_body,           // of a scene with water
    balanced_body,      // of a run with balances
    balanced_wet_body,  // of such a run with water
    balanced_stiff_body // of such a run with the implicit scheme
};

struct BodyQuantity {
    std::string_view name;    // "crest_settlement"
    std::string_view unit;    // SI, "-" without one
    std::string_view meaning; // with its sign
    BodyQuantityOf of = BodyQuantityOf::any_body;
    double (*value)(const MeasuredBody&) = nullptr;
    std::string_view label = {}; // in the picture of the history; none: it is not drawn there
    std::string_view drawn = {}; // unit in pictures where it is not the SI unit
    bool is_counted = false;     // in a whole step: there are no values between its ends
};

/// All of them in the order of their columns.
std::span<const BodyQuantity> all_body_quantities();

/// Those that the run has.
std::vector<const BodyQuantity*> body_quantities(const Problem& problem, const State& state);

/// "crest_settlement_m".
std::string column_name(const BodyQuantity& quantity);

} // namespace quicksand
