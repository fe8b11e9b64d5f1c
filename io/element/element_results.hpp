// The folder and the CSV files of element tests.
#pragma once

#include "io/element/element_outcome.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// Where the results go, and what has been written so far. The list of files is in the folder; by it a later
/// run removes what this one wrote, and nothing else.
class ElementResults {
public:
    /// Make the folder ready: results of former element tests are removed. Throws InputError where the folder
    /// holds something else, FileError.
    ElementResults(std::filesystem::path directory, const ElementProgramme& programme);

    const std::filesystem::path& directory() const { return directory_; }

    /// Path of a new file in the folder of the test, noted in the list.
    std::filesystem::path add(const std::string& test, const std::string& name);
    std::filesystem::path add(const std::string& name);

    /// Write the list of files. Throws FileError.
    void finish() const;

private:
    std::filesystem::path directory_;
    std::vector<std::string> files_; // relative to the folder
};

/// Paths of all runs; csr_n.csv and strength.csv of stress-controlled tests, cycles.csv of strain-controlled
/// ones. Throws FileError.
void write_element_csv(const ElementOutcome& outcome, ElementResults& results);

} // namespace quicksand
