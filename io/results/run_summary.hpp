// What a run came to, in a few numbers: for its manifest and for tables of many runs.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// What tables of histories call that of the whole body, history.csv, beside those of the probes.
inline constexpr const char* history_name = "history";

/// Columns of history.csv that no picture draws and engineers ask for first.
inline constexpr std::array<std::string_view, 2> summarized_extremes = {"max_displacement_m",
                                                                        "max_velocity_m_s"};

/// A column of history.csv or of a probe.
struct SummaryValue {
    std::string table;        // history_name or the probe's
    std::string column;       // with its unit
    double peak = 0.0;        // largest in amount, with its sign
    double peak_time = 0.0;   // [s]
    double final_value = 0.0; // of the last row
};

/// The largest value of a field in the last frame, in amount, and where.
struct SummaryPlace {
    std::string field;
    std::string unit;   // SI, "" without one
    double value = 0.0; // with its sign
    double x = 0.0;     // of the particle's centre in that frame [m]
    double y = 0.0;     // [m]
};

struct RunSummary {
    std::vector<SummaryValue> values;
    double frame_time = 0.0; // of the last frame [s]
    std::vector<SummaryPlace> places;
};

} // namespace quicksand
