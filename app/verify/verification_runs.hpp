// The runs of `verify`: every problem on every grid, several at the same time, each on one thread.
#pragma once

#include "app/run/choices.hpp"
#include "app/run/journal.hpp"
#include "io/assembly/case_assembly.hpp"
#include "solver/verification/studies/study.hpp"

#include <exception>
#include <string>
#include <vector>

namespace quicksand {

/// One problem on one grid.
struct VerificationRun {
    std::string problem; // name of the scene
    std::string title;   // of the scene
    const Study* study = nullptr;
    SceneVerification verification; // of the scene
    int cells = 0;                  // along its length [-]
    AssembledCase assembled;
    // the outcome
    std::vector<StudyError> errors;
    double seconds = 0.0;       // wall time [s]
    std::exception_ptr failure; // why there are no errors; null: there are
};

/// Read and sample all the problems that the choice names, in their order, coarse to fine. Throws InputError.
std::vector<VerificationRun> prepare_runs(const VerifyChoice& choice);

/// Run them all, the largest first; each is told when it ends. A failure is kept with its run.
void execute_runs(int threads, std::vector<VerificationRun>& runs, Journal& journal);

} // namespace quicksand
