// A lognormal fragility curve through runs that exceed a threshold or not.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Share of the standard normal distribution below z.
double normal_share(double z);

struct FragilityPoint {
    double intensity = 0.0; // above 0
    bool exceeds = false;
};

/// Probability of exceeding: normal_share(ln(intensity / median) / beta).
struct FragilityCurve {
    double median = 0.0; // in the unit of the intensity
    double beta = 0.0;   // standard deviation of ln(intensity) [-]
    double probability(double intensity) const;
};

/// A curve, or why the points give none.
struct FragilityFit {
    std::optional<FragilityCurve> curve;
    std::string why_not;
};

/// The curve of maximum likelihood (J. W. Baker, Earthquake Spectra 31 (2015), 579-599), a probit regression
/// on ln(intensity). It does not exist where one intensity parts the runs that exceed from those that do not.
FragilityFit fit_fragility(const std::vector<FragilityPoint>& points);

} // namespace quicksand
