// The crest of a dike before and after a run, against the height that it must keep.
#pragma once

#include <filesystem>
#include <optional>

namespace quicksand {

struct CrestCheck {
    double before = 0.0;     // y of the highest point of the soil in the first frame, with what it has
                             // settled in stages before [m]
    double settlement = 0.0; // of the crest since then, from history.csv, positive downward [m]
    bool is_unseen = false;  // whether the shape in frames and pictures lacks what was settled before
    double after() const { return before - settlement; } // [m]
};

/// None where the results have no frames or no crest settlement. Throws FileError.
std::optional<CrestCheck> check_crest(const std::filesystem::path& results);

} // namespace quicksand
