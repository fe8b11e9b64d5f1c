// Fit keys of a sand to measured points of cyclic strength.
//
// What       The keys are changed by factors so that the cycles to the criterion of each point come near the
//            measured ones: least squares of ln N, by subplex (NLopt), which needs no derivatives.
#pragma once

#include "io/element/element_programme.hpp"
#include "io/keys/diagnostics.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// A measured point: undrained simple shear under a stress ratio.
struct StrengthObservation {
    double csr = 0.0, cycles = 0.0;  // [-]
    double static_shear_ratio = 0.0; // alpha [-]
    double k0 = 0.5;                 // [-]
    double vertical_stress = 100e3;  // [Pa]
    LiquefactionCriterion criterion = LiquefactionCriterion::ru_95;
};

/// A point, without its stress ratio and cycles, under the conditions of the file's first test. Throws
/// InputError.
StrengthObservation conditions_of_first_test(const std::filesystem::path& test_file,
                                             const std::vector<std::string>& overrides);

/// Columns CSR and N and, where they are there, alpha, k0, sigma_v [Pa] and criterion (the words of
/// tests.*.criterion); what they do not tell is as `usual`. Throws InputError.
std::vector<StrengthObservation> read_observations(const std::filesystem::path& file,
                                                   const StrengthObservation& usual = {});

/// Cycles after which a test of the fit ends [-].
double longest_test(const StrengthObservation& observation);

/// Cycles to the criterion, between reversals as the path goes; beyond the longest test where the criterion
/// is not reached, the more the farther the specimen is from it. [-]
double cycles_of(const SkeletonLaw& law, const StrengthObservation& observation);

struct FittedKey {
    std::string path;    // "materials.sand.secondary_factor"
    double start, value; // [the key's SI unit]
};

struct SandCalibration {
    std::vector<FittedKey> keys;
    std::vector<double> cycles_before, cycles_after; // of the points [-]
    double error_before = 0.0, error_after = 0.0;    // root mean square of ln(N/N measured) [-]
    int evaluations = 0;
};

/// Fit keys of the first test's material. Throws InputError where a key is none or has no value.
SandCalibration calibrate_sand(const std::filesystem::path& test_file,
                               const std::vector<std::string>& overrides,
                               const std::vector<std::string>& keys,
                               const std::vector<StrengthObservation>& observations);

} // namespace quicksand
