// What element tests gave, in the order in which the programme names them.
#pragma once

#include "io/element/element_programme.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// One specimen in one loading.
struct ElementRun {
    std::size_t specimen = 0, loading = 0; // of the test [-]
    CyclicTest result;
};

struct ElementOutcome {
    ElementTest test;
    std::vector<ElementRun> runs;                         // loadings of the first specimen, of the next, ...
    std::vector<std::optional<CyclicStrength>> strengths; // of the specimens, where CSR is given

    const ElementSpecimen& specimen(const ElementRun& run) const { return test.specimens[run.specimen]; }
    const ElementLoading& loading(const ElementRun& run) const { return test.loadings[run.loading]; }
};

/// "CSR 0.15", "gamma 0.1 %", "" for a loading that a test has only one of.
std::string loading_label(const ElementLoading& loading);

/// "n1_60 = 10, CSR 0.15"; "" where there is one run only.
std::string run_label(const ElementOutcome& outcome, const ElementRun& run);

/// "undrained cyclic simple shear, stress-controlled"
std::string loading_name(const ElementLoading& loading);

/// Cycles to the criterion of the test, where they were reached [-].
std::optional<double> cycles_to_liquefaction(const ElementOutcome& outcome, const ElementRun& run);

/// A number with few digits, 14.5, 0.146, "-" for none.
std::string short_text(std::optional<double> number, int digits = 3);

} // namespace quicksand
