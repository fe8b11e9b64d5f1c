// A record of an earthquake from its file: in PEER's AT2 form, which states its unit, or as two columns, time
// and acceleration, whose unit their header or the user states. The motion begins with the first value,
// whatever its time.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "solver/problem/base_motion.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// What the user says of a record's unit beside its file.
struct StatedUnit {
    std::string word;  // "g" or "m/s2"; empty: nothing
    std::string key;   // that says it: "motion.unit", "--unit"
    std::string forms; // as which it is written: `motion.unit = "g" or "m/s2"`
    SourcePlace place;
};

struct MotionRecord {
    SampledMotion motion;  // as in the file
    std::string unit_hint; // what may be wrong with the unit where values are too large
};

/// Read a record. What is wrong is added to `findings`, at its place in the record or, for what is wrong with
/// the file as a whole, at `place`; then the result is empty.
std::optional<MotionRecord> read_motion_record(const std::filesystem::path& file, const SourcePlace& place,
                                               const StatedUnit& unit, Diagnostics& findings);

/// What is said of a record that can be read but hardly is one.
struct RecordDoubt {
    std::string what, expected, hint;
};

/// Doubts about the peak and the interval of a record, as read or as scaled, for a model in a field of so
/// many g [-]. `unit_hint` is that of the record.
std::vector<RecordDoubt> doubt_record(const SampledMotion& motion, const std::string& unit_hint,
                                      double field);

} // namespace quicksand
