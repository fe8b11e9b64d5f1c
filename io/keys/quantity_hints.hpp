// What a message says of a quantity that cannot be taken: its units, its form, what was probably meant.
#pragma once

#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_units.hpp"

#include <string>
#include <string_view>

namespace quicksand {

/// The units of the dimension: "one of Pa, kPa, MPa".
std::string list_units(Dimension dimension);

/// The unit that differs from the text in capitals only, "" when there is none.
std::string unit_in_other_case(std::string_view text, Dimension dimension);

/// How a number of the dimension is written.
std::string number_form(Dimension dimension);

/// The quantity that was probably meant: the same number in a unit that makes `wanted` hold; "" when none
/// does.
std::string likely_quantity(const WrittenQuantity& written, Dimension dimension, const Interval& wanted);

} // namespace quicksand
