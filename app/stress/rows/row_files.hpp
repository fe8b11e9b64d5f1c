// Where the files of a row lie.
#pragma once

#include "app/stress/scenes/stress_row.hpp"

#include <filesystem>

namespace quicksand {

struct RowFiles {
    std::filesystem::path folder; // of the row
    std::filesystem::path scene() const { return folder / "scene.toml"; }
    std::filesystem::path drawing() const { return folder / "section.geo"; }
    std::filesystem::path results() const { return folder / "results"; }
    std::filesystem::path words() const { return folder / "output.txt"; }        // its standard output
    std::filesystem::path complaints() const { return folder / "messages.txt"; } // its standard error
    std::filesystem::path margin() const { return folder / "margin.csv"; }       // the largest stable step
};

/// The files of a row below the laboratory's folder.
RowFiles files_of(const std::filesystem::path& laboratory, const StressRow& row);

/// Write scene and drawing, and remove the results of a former run. Throws FileError.
void write_row(const StressRow& row, const RowFiles& files);

/// Keep scene and drawing alone, of a row of which nothing is to be said. Throws FileError.
void remove_results(const RowFiles& files);

} // namespace quicksand
