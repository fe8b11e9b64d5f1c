// How far the probes of one run are from those of another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// The largest error of a quantity over the probes.
struct HistoryError {
    std::string quantity;
    double error = 0.0; // root of the mean square difference over the range of the reference [-]
};

/// Of the probes' excess pore pressure, settlement and sideways displacement, as far as they have them. Both
/// are results folders of the same scene with the same probe times. Profiles are left out, and probes where a
/// quantity hardly changes: by less than 1 % of what it does where it changes most. Throws FileError.
std::vector<HistoryError> history_errors(const std::filesystem::path& results,
                                         const std::filesystem::path& reference);

} // namespace quicksand
