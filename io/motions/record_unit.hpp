// Units as the headers of records and histories name them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace quicksand {

/// A unit in the words of a record.
struct RecordUnit {
    std::string name;   // as written
    double value = 0.0; // [m/s2]
};

/// The unit of these words: G, CM/S/S, M/S2, GAL and forms of them, in upper or lower case.
std::optional<RecordUnit> record_unit(std::string_view words);

/// The unit that the last column of a header states: "Acceleration [g]", "a (cm/s2)", "acceleration_m_s2".
std::optional<RecordUnit> unit_of_column(std::string_view header);

/// What stands in brackets after the name of the last column where it is a unit, though none of accelerations
/// that is known: "ft/s2", "%g", "m/s"; or the name, where it is that of velocities or displacements; empty
/// otherwise.
std::string unknown_unit_of_column(std::string_view header);

/// The unit that the first column of a header states where it is one of time but not the second: "time [ms]",
/// "t_min"; empty otherwise.
std::string foreign_unit_of_time(std::string_view header);

/// The unit of pressure, length or velocity that the last column states: "pressure [kPa]", "head_m"; empty
/// where there is none.
std::string unit_of_values(std::string_view header);

} // namespace quicksand
