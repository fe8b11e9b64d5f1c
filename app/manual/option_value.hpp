// What the value of an option or positional is, as its parser says it.
#pragma once

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace quicksand {

struct OptionValue {
    std::string name;               // "DIR"; empty where the option takes no value
    std::string allowed;            // "1 to 1024", empty: anything
    std::vector<std::string> words; // where only these are allowed
};

/// The value of an option. Not constant, because CLI11 lends the validators of options only so.
OptionValue value_of(CLI::Option& option);

} // namespace quicksand
