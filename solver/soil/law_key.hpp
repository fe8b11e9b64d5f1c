// A parameter of a soil law as users give it.
#pragma once

#include "solver/base/interval.hpp"

#include <optional>
#include <string_view>

namespace quicksand {

/// What is said of a parameter.
struct LawKeyText {
    std::string_view name;               // of the key in a scene, "shear_modulus"
    std::string_view unit;               // "Pa", "deg"; "-" without one
    std::string_view meaning;            // one line of the reference
    Interval allowed = {};               // an error outside
    Interval usual = {};                 // a warning outside
    std::optional<double> standard = {}; // value where the user gives none
    std::string_view absent = {};        // what it means that there is none; without both the key is required
    bool hangs_on_time = false;          // without effect in element tests, which know none
};

/// And the member that it fills.
template <class Law>
struct LawKey {
    LawKeyText text;
    double Law::*member = nullptr;
    double factor = 1.0; // of the number in the member over that in the key's unit [-]
};

} // namespace quicksand
