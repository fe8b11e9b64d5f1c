// Random values that are the same on all machines: the standard library's distributions are not.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

enum class DistributionKind { normal, lognormal, uniform };

/// How a key is drawn.
struct Distribution {
    DistributionKind kind = DistributionKind::uniform;
    double mean = 0.0, deviation = 1.0; // of the key itself, for a lognormal key too; in `unit`
    double low = 0.0, high = 1.0;       // of a uniform one; in `unit`
    std::string unit;                   // "" without one
};

/// z with a probability `share` (between 0 and 1) below it in the standard normal distribution; algorithm AS
/// 241 of M. J. Wichura, Applied Statistics 37 (1988), 477-484, to about 16 digits.
double normal_quantile(double share);

/// The value that is larger than the share (between 0 and 1) of all.
double quantile(const Distribution& distribution, double share);

/// `count` values of the distribution. Each name has its own sequence for a seed, so that further keys and
/// further samples leave the values before them as they are.
std::vector<double> draw_values(const Distribution& distribution, std::uint64_t seed, std::string_view name,
                                std::int64_t count);

} // namespace quicksand
