#include "io/sweeps/fragility_fit.hpp"

#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace quicksand {

namespace {

double normal_density(double z)
{
    return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

/// ln of normal_share(z), also where that is too small for a double.
double log_share(double z)
{
    if (z > -37.0) return std::log(normal_share(z));
    return -0.5 * z * z - std::log(-z) - 0.5 * std::log(2.0 * std::numbers::pi);
}

/// density / share, likewise.
double density_over_share(double z)
{
    return z > -37.0 ? normal_density(z) / normal_share(z) : -z;
}

/// ln(intensity), shifted and scaled to a mean of 0 and a deviation of 1 for the sake of the iteration.
struct Regression {
    std::vector<double> x;
    std::vector<double> sign; // +1 where the run exceeds, else -1
    double mean = 0.0, deviation = 1.0;
};

Regression regression_of(const std::vector<FragilityPoint>& points)
{
    Regression regression;
    const auto count = static_cast<double>(points.size());
    double squares = 0.0;
    for (const FragilityPoint& point : points) regression.mean += std::log(point.intensity) / count;
    for (const FragilityPoint& point : points) {
        regression.x.push_back(std::log(point.intensity) - regression.mean);
        regression.sign.push_back(point.exceeds ? 1.0 : -1.0);
        squares += regression.x.back() * regression.x.back();
    }
    regression.deviation = std::sqrt(squares / count);
    for (double& x : regression.x) x /= regression.deviation;
    return regression;
}

double log_likelihood(const Regression& regression, double a, double b)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < regression.x.size(); ++k)
        sum += log_share(regression.sign[k] * (a + b * regression.x[k]));
    return sum;
}

/// Newton's step from (a, b). The likelihood of a probit is concave: the matrix is negative definite.
std::pair<double, double> newton_step(const Regression& regression, double a, double b)
{
    double g_a = 0.0, g_b = 0.0, h_aa = 0.0, h_ab = 0.0, h_bb = 0.0;
    for (std::size_t k = 0; k < regression.x.size(); ++k) {
        const double x = regression.x[k], sign = regression.sign[k], z = sign * (a + b * x);
        const double slope = density_over_share(z), curvature = slope * (slope + z);
        g_a += sign * slope;
        g_b += sign * slope * x;
        h_aa += curvature;
        h_ab += curvature * x;
        h_bb += curvature * x * x;
    }
    const double determinant = h_aa * h_bb - h_ab * h_ab;
    if (!(determinant > 0.0)) return {0.0, 0.0};
    return {(h_bb * g_a - h_ab * g_b) / determinant, (h_aa * g_b - h_ab * g_a) / determinant};
}

/// The largest likelihood, by Newton's steps that are halved until they gain.
std::pair<double, double> maximize(const Regression& regression)
{
    constexpr int most_steps = 100, most_halvings = 40;
    constexpr double close = 1e-12;
    double a = 0.0, b = 0.0, best = log_likelihood(regression, a, b);
    for (int step = 0; step < most_steps; ++step) {
        auto [da, db] = newton_step(regression, a, b);
        double gained = -1.0;
        for (int halving = 0; halving < most_halvings; ++halving, da *= 0.5, db *= 0.5) {
            gained = log_likelihood(regression, a + da, b + db) - best;
            if (gained >= 0.0) break;
        }
        if (!(gained >= 0.0)) break;
        a += da;
        b += db;
        best += gained;
        if (std::abs(da) + std::abs(db) < close * (1.0 + std::abs(a) + std::abs(b))) break;
    }
    return {a, b};
}

/// The least and largest intensity of the runs that exceed, or of the others.
struct Span {
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
};

Span span_of(const std::vector<FragilityPoint>& points, bool exceeds)
{
    Span span;
    for (const FragilityPoint& point : points) {
        if (point.exceeds != exceeds) continue;
        span.least = std::min(span.least, point.intensity);
        span.largest = std::max(span.largest, point.intensity);
    }
    return span;
}

/// Why the likelihood has no maximum with a finite beta; "" where it has one.
std::string why_without_maximum(const std::vector<FragilityPoint>& points)
{
    if (points.empty()) return "no run has a value";
    const Span exceeding = span_of(points, true), below = span_of(points, false);
    if (exceeding.largest == 0.0) return "no run exceeds the threshold";
    if (below.largest == 0.0) return "all runs exceed the threshold";
    if (below.largest <= exceeding.least)
        return fmt::format(
            "the runs up to {:.4g} do not exceed the threshold and those from {:.4g} on do: the "
            "median lies between, and beta needs runs that differ at an intensity",
            below.largest, exceeding.least);
    if (exceeding.largest <= below.least)
        return "the runs of small intensity exceed the threshold, the others not";
    return "";
}

} // namespace

double normal_share(double z)
{
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

double FragilityCurve::probability(double intensity) const
{
    return normal_share(std::log(intensity / median) / beta);
}

FragilityFit fit_fragility(const std::vector<FragilityPoint>& points)
{
    for (const FragilityPoint& point : points) ENSURE(point.intensity > 0.0);
    if (std::string why = why_without_maximum(points); !why.empty()) return {std::nullopt, std::move(why)};
    const Regression regression = regression_of(points);
    const auto [a, b] = maximize(regression);
    if (!(b > 0.0)) return {std::nullopt, "runs of larger intensity do not exceed the threshold more often"};
    const double beta = regression.deviation / b;
    return {FragilityCurve{std::exp(regression.mean - a * beta), beta}, ""};
}

} // namespace quicksand
