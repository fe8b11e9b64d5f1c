// Moduli of cells, raised where their particles lie at a side.
#include "solver/inertia/cell_moduli.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace quicksand {
namespace {

constexpr int motions = 5; // constant strains e_xx, e_yy, g_xy and the coefficients of u_x, u_y = h x y
using Energy = Eigen::Matrix<double, motions, motions>;

/// Strain energy at a place [cells from the middle], by the motions.
Energy energy_at(double M, double G, double x, double y)
{
    Eigen::Matrix<double, 3, motions> strain;
    strain << 1, 0, 0, y, 0, //
        0, 1, 0, 0, x,       //
        0, 0, 1, x, y;
    Eigen::Matrix3d stiffness;
    stiffness << M, M - 2.0 * G, 0, M - 2.0 * G, M, 0, 0, 0, G;
    return strain.transpose() * stiffness * strain;
}

/// Its mean over the cell, by Gauss points.
Energy energy_of_cell(double M, double G)
{
    const double a = 0.5 / std::sqrt(3.0);
    return (energy_at(M, G, -a, -a) + energy_at(M, G, a, -a) + energy_at(M, G, -a, a) +
            energy_at(M, G, a, a)) /
           4.0;
}

double largest_ratio(const Energy& energy, const Energy& mean)
{
    return Eigen::GeneralizedSelfAdjointEigenSolver<Energy>(energy, mean, Eigen::EigenvaluesOnly)
        .eigenvalues()
        .maxCoeff();
}

TEST(CellModuli, BoundTheStiffnessOfParticlesWhereverTheyLie)
{
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> place(-0.5, 0.5), part(0.1, 1.0), log_ratio(std::log(1.01), 5.0);
    for (int k = 0; k < 2000; ++k) {
        const double G = 1.0, M = std::exp(log_ratio(generator));
        const int particles = 1 + k % 6;
        StiffnessSums sums{.constrained = M, .shear = G};
        Energy energy = Energy::Zero();
        std::vector<double> shares;
        for (int p = 0; p < particles; ++p) shares.push_back(part(generator));
        double sum = 0.0;
        for (const double share : shares) sum += share;
        for (const double share : shares) {
            const double x = place(generator), y = place(generator), w = share / sum;
            sums.x += w * M * x;
            sums.y += w * M * y;
            sums.xx += w * M * x * x;
            sums.xy += w * M * x * y;
            sums.yy += w * M * y * y;
            energy += w * energy_at(M, G, x, y);
        }
        const double ratio = std::max(1.0, largest_ratio(energy, energy_of_cell(M, G)));
        const double bound = eccentricity_factor(sums);
        EXPECT_GE(bound, ratio * (1.0 - 1e-9));
        EXPECT_LT(bound, 1.5 * ratio); // not needlessly large
        if (particles == 1) {
            EXPECT_NEAR(bound, ratio, 1e-6 * ratio);
        }
    }
}

/// A cell with G = 1 Pa whose particles lie around a place, by their mean second moments.
StiffnessSums all_at(double M, double x, double y, double xx, double yy)
{
    return {M, 1.0, M * x, M * y, M * xx, M * x * y, M * yy};
}

TEST(CellModuli, LeaveCellsThatAreFilledAsTheyAre)
{
    const double middle = 1.0 / 12.0, of_four = 1.0 / 16.0; // second moments of a whole cell and 2 x 2
    EXPECT_NEAR(eccentricity_factor(all_at(4.0, 0.0, 0.0, middle, middle)), 1.0, 1e-12);
    EXPECT_EQ(eccentricity_factor(all_at(4.0, 0.0, 0.0, of_four, of_four)), 1.0);
    // 1 + 12 M / (M + G) r^2: a quarter of a side is 1/4, that of a corner 1/2
    EXPECT_NEAR(eccentricity_factor(all_at(2.0, 0.5, 0.0, 0.25, 0.0)), 3.0, 1e-12);
    EXPECT_NEAR(eccentricity_factor(all_at(2.0, 0.5, 0.5, 0.25, 0.25)), 5.0, 1e-12);
}

TEST(CellModuli, AreThoseOfLongDomainsTimesTheirElongationWhereTheyAreAlone)
{
    const double of_five = 5.0 + 1.0 / 5.0 - 1.0;
    StiffnessSums cell{.constrained = 3.0, .shear = 1.0, .elongation = 3.0 * of_five};
    EXPECT_NEAR(elongation_factor(cell), of_five, 1e-12);
    cell.filled = 0.5;
    EXPECT_NEAR(elongation_factor(cell), 0.5 * (1.0 + of_five), 1e-12);
    for (const double filled : {0.75, 1.0, 1.3}) {
        cell.filled = filled;
        EXPECT_EQ(elongation_factor(cell), 1.0);
    }
    EXPECT_EQ(elongation_factor({.constrained = 3.0, .shear = 1.0, .elongation = 3.0}), 1.0); // a square
}

} // namespace
} // namespace quicksand
