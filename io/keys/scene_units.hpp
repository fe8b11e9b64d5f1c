// Quantities with units: the closed list of units of every dimension, and numbers as text.
#pragma once

#include "solver/base/conventions.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

enum class Dimension { none, length, time, frequency, acceleration, velocity, density, pressure, angle };

/// A unit and its size in SI, as a ratio so that "7.5 mm" is exactly 0.0075.
struct Unit {
    std::string_view symbol;
    double multiply = 1.0;
    double divide = 1.0;
};

/// The units allowed for a dimension, the SI unit first; for angles the degree, which scenes are written in.
const std::vector<Unit>& units_of(Dimension dimension);

/// Symbol of the SI unit, "" when dimensionless.
std::string_view si_symbol(Dimension dimension);

/// A quantity as written: `number` of a unit.
struct WrittenQuantity {
    double number = 0.0; // as written
    std::string unit;    // as written, "" when there is none
};

/// Split "60 kPa" into number and unit; nothing when it does not start with a number.
std::optional<WrittenQuantity> split_quantity(std::string_view text);

/// Value in SI; nothing when the unit is not one of the dimension's.
std::optional<double> to_si(const WrittenQuantity& quantity, Dimension dimension);

/// The shortest text that reads back as the same number: 0.45, 2.2e9.
std::string number_text(double number);

/// A coordinate in m with four digits, and to the centimetre where it is large, as on maps: 7.331, 155000.37.
std::string coordinate_text(double x);
/// "(7.331, 1.27)"
std::string place_text(const Vector2& place);

/// Three significant digits, for numbers that are told but not read back: 0.45, 2.2e+09.
std::string three_digits(double number);

/// Six significant digits, for places and factors that follow from others: 31.87.
std::string six_digits(double number);

/// A time with four digits, in hours from two hours on and in days from two days on: 0.45 s, 24 h, 10 d.
std::string time_text(double seconds);

/// The number with its SI unit: "2.2e9 Pa".
std::string quantity_text(double number, Dimension dimension);

} // namespace quicksand
