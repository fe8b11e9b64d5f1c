// Reading a sweep: which keys of a scene take which values.
#pragma once

#include "io/keys/source_place.hpp"
#include "io/sweeps/random_draws.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// A key of the scene that differs from run to run.
struct VariedKey {
    std::string key;                          // "motion.amplitude"
    std::vector<std::string> values;          // as TOML writes them; none where it is random
    std::optional<Distribution> distribution; // of a random one
    SourcePlace place;                        // of its table
};

/// A curve of how often a quantity is above a threshold.
struct FragilityRequest {
    std::string quantity;   // column of sweep.csv, "crest_settlement_m"
    double threshold = 0.0; // in the unit of the column
    std::string intensity;  // one of the varied keys
};

struct Sweep {
    std::filesystem::path file;
    std::string title;
    std::filesystem::path scene;    // the file itself
    std::vector<std::string> fixed; // path=value, the same for all runs
    std::vector<VariedKey> varied;
    std::int64_t samples = 1; // of the random keys [-]
    std::uint64_t seed = 1;
    std::optional<FragilityRequest> fragility;
};

/// Read a sweep's file; the scene itself is not read. Throws InputError with all errors at once.
Sweep read_sweep_file(const std::filesystem::path& file);

} // namespace quicksand
