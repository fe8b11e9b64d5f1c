// What a file of element tests asks for, read and checked.
#pragma once

#include "io/laws/soil_law.hpp"
#include "solver/element/element_loading.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// A point of the user's own in the picture of CSR over cycles.
struct StrengthDatum {
    double csr;                  // [-]
    double cycles;               // N [-]
    std::optional<double> value; // of the key that is varied, where the file has its column
};

struct StrengthData {
    std::string label;
    std::vector<StrengthDatum> points;
};

/// One soil in one state before loading.
struct ElementSpecimen {
    std::string label;  // "n1_60 = 10", "" where nothing is varied
    double value = 0.0; // of the key that is varied, in SI
    DescribedLaw soil;
    Consolidation start;
};

enum class LiquefactionCriterion { ru_95, strain_3_percent, strain_375_percent, double_amplitude_75_percent };

/// A series of tests: every specimen in every loading.
struct ElementTest {
    std::string name;
    std::string material;
    DescribedLaw soil;  // the material as the file gives it, nothing varied
    std::string varied; // the key, "" for none
    std::vector<ElementSpecimen> specimens;
    std::vector<ElementLoading> loadings;
    LiquefactionCriterion criterion = LiquefactionCriterion::ru_95;
    std::optional<StrengthData> data;
};

struct ElementProgramme {
    std::filesystem::path file;
    std::string text; // as read, for the copy in the results
    std::string title;
    std::vector<ElementTest> tests;
};

} // namespace quicksand
