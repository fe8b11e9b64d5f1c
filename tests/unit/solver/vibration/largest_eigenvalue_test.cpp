#include "solver/vibration/largest_eigenvalue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

/// A chain of n equal masses between springs, held at both ends:
/// lambda = 4 (k/m) sin^2(pi n / (2 (n+1))) is the largest eigenvalue.
class Chain : public NodalEquations {
public:
    Chain(std::size_t n, double mass, double stiffness) : n_(n), mass_(mass), stiffness_(stiffness) {}

    Scalars root_masses() const override { return Scalars(n_, std::sqrt(mass_)); }
    void deform(const Scalars& v, Scalars& f) override
    {
        for (std::size_t i = 0; i < n_; ++i)
            f[i] = stiffness_ * (2.0 * v[i] - (i > 0 ? v[i - 1] : 0.0) - (i + 1 < n_ ? v[i + 1] : 0.0));
    }
    void respond(const Scalars& f, Scalars& v) override
    {
        for (std::size_t i = 0; i < n_; ++i) v[i] = f[i] / mass_;
    }

private:
    std::size_t n_;
    double mass_, stiffness_;
};

double exact(std::size_t n, double mass, double stiffness)
{
    const auto count = static_cast<double>(n);
    return 4.0 * stiffness / mass * std::pow(std::sin(0.5 * std::numbers::pi * count / (count + 1.0)), 2);
}

TEST(LargestEigenvalue, OfAChainIsExactWithAsManyIterationsAsMasses)
{
    Chain chain(6, 3.0, 50.0);
    const LargestEigenvalue found = find_largest_eigenvalue(chain, 0.0, 6);
    EXPECT_NEAR(found.value, exact(6, 3.0, 50.0), 1e-10 * found.value);
    Scalars force(6), answer(6);
    chain.deform(found.eigenvector, force);
    chain.respond(force, answer);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(answer[i], found.value * found.eigenvector[i], 1e-9 * found.value);
}

TEST(LargestEigenvalue, OfALongChainIsApproachedFromBelowInFewIterations)
{
    Chain chain(2000, 1.0, 1.0);
    const LargestEigenvalue found = find_largest_eigenvalue(chain, 0.01, 24);
    EXPECT_LT(found.value, exact(2000, 1.0, 1.0));
    EXPECT_GT(found.value, 0.97 * exact(2000, 1.0, 1.0));
    EXPECT_LT(found.iterations, 16);
}

TEST(LargestEigenvalue, IsZeroWhereNothingCanMove)
{
    class Held : public NodalEquations {
    public:
        Scalars root_masses() const override { return {0.0, 0.0}; }
        void deform(const Scalars&, Scalars& f) override { f.assign(2, 0.0); }
        void respond(const Scalars&, Scalars& v) override { v.assign(2, 0.0); }
    };
    Held held;
    const LargestEigenvalue found = find_largest_eigenvalue(held, 0.01, 24);
    EXPECT_EQ(found.value, 0.0);
    EXPECT_EQ(found.iterations, 0);
}

} // namespace
} // namespace quicksand
