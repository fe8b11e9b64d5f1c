// How far the probes of one run are from those of another.
#pragma once

#include "io/pictures/picture_table.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// A column of the probes' files that runs are compared by.
struct ComparedQuantity {
    const char *column, *name;
    const char* unit; // of figures
    double scale;     // from SI to the unit
};

inline constexpr std::array<ComparedQuantity, 3> compared_quantities = {
    {{"excess_pore_pressure_Pa", "excess pore pressure", "kPa", 1e-3},
     {"uy_m", "settlement", "mm", -1e3},
     {"ux_m", "sideways displacement", "mm", 1e3}}};

/// What a probe has written.
struct ProbeHistory {
    std::string probe;
    PictureTable table;
};

/// Of all probes but profiles, by name. Throws FileError.
std::vector<ProbeHistory> read_probe_histories(const std::filesystem::path& results);

/// What the probe of that name has written, null where there is none.
const PictureTable* find_probe(const std::vector<ProbeHistory>& histories, const std::string& probe);

/// Error of a quantity at one probe.
struct ProbeError {
    std::string probe;
    double error = 0.0; // root of the mean square difference over the range of the reference [-]
};

/// Errors of a quantity, the largest first.
struct HistoryError {
    std::string quantity;
    std::vector<ProbeError> probes; // at least one

    double largest() const { return probes.front().error; }
};

/// "excess pore pressure 4.02 % at A, 1.63 % at B".
std::string text_of(const HistoryError& error);

/// Of the probes' excess pore pressure, settlement and sideways displacement, as far as they have them,
/// between runs of the same scene with the same probe times. Probes are left out where a quantity hardly
/// changes: by less than 1 % of what it does where it changes most.
std::vector<HistoryError> history_errors(const std::vector<ProbeHistory>& run,
                                         const std::vector<ProbeHistory>& reference);

} // namespace quicksand
