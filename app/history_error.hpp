// How far the probes of one run are from those of another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

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

/// Of the probes' excess pore pressure, settlement and sideways displacement, as far as they have them. Both
/// are results folders of the same scene with the same probe times. Profiles are left out, and probes where a
/// quantity hardly changes: by less than 1 % of what it does where it changes most. Throws FileError.
std::vector<HistoryError> history_errors(const std::filesystem::path& results,
                                         const std::filesystem::path& reference);

} // namespace quicksand
