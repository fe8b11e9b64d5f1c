// Liquefied sand of one cell: what approaches, and what stays.
#include "solver/reconsolidation/cell_reconsolidation.hpp"
#include "solver/ubcsand/ubcsand_parameters.hpp"
#include "solver/ubcsand/ubcsand_particles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace quicksand {
namespace {

/// Four particles of a cell whose stresses and lines differ; the last one has not liquefied.
struct Cell {
    UbcSand law = make_ubcsand(calibrated(ubcsand_from_blow_count(10.0)));
    Particles particles;
    std::vector<std::int32_t> points = {0, 1, 2, 3};

    Cell()
    {
        particles.identifier = points;
        particles.volume = {0.02, 0.03, 0.025, 0.02};
        particles.stress.xx = {-8e3, -20e3, -15e3, -30e3};
        particles.stress.yy = {-14e3, -42e3, -33e3, -60e3};
        particles.stress.zz = {-7e3, -18e3, -16e3, -30e3};
        particles.stress.xy = {3e3, -4e3, 9e3, 5e3};
        particles.memory.assign(memory_of(law).size(), Scalars(4, 0.0));
        column("start_mean") = {36e3, 38e3, 40e3, 42e3};
        column("liquefied_shear") = {0.02, 0.03, 0.1, 0.0};
        column("compaction") = {0.006, 0.004, 0.02, 0.0};
        set_rates(-1e-3, 0.0);
    }
    Scalars& column(std::string_view name) { return particles.memory[column_of(memory_of(law), name)]; }
    void set_rates(double volume, double shear)
    {
        Gradients& L = particles.velocity_gradient_solid;
        L.xx = L.xy = Scalars(4, 0.0);
        L.yy = Scalars(4, volume);
        L.yx = Scalars(4, shear);
    }
    void even_out(double dt) { even_out_cell(law, dt, points, particles); }
    double sum(const Scalars& values, std::size_t count) const
    {
        return std::inner_product(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count),
                                  particles.volume.begin(), 0.0);
    }
    double ratio(std::size_t p) const
    {
        const SymmetricTensors& s = particles.stress;
        return std::hypot(0.5 * (s.xx[p] - s.yy[p]), s.xy[p]) / (-0.5 * (s.xx[p] + s.yy[p]));
    }
};

TEST(CellReconsolidation, KeepsTheSumsOfStressAndCompaction)
{
    const Cell before;
    Cell cell;
    cell.even_out(0.01);
    EXPECT_NE(cell.particles.stress.yy, before.particles.stress.yy);
    for (const auto component :
         {&SymmetricTensors::xx, &SymmetricTensors::yy, &SymmetricTensors::zz, &SymmetricTensors::xy}) {
        const double expected = before.sum(before.particles.stress.*component, 3);
        EXPECT_NEAR(cell.sum(cell.particles.stress.*component, 3), expected, 1e-12 * std::abs(expected));
        EXPECT_EQ((cell.particles.stress.*component)[3], (before.particles.stress.*component)[3]);
    }
    const double compaction = Cell().sum(Cell().column("compaction"), 3);
    EXPECT_NEAR(cell.sum(cell.column("compaction"), 3), compaction, 1e-12 * compaction);
    EXPECT_EQ(cell.column("compaction")[3], 0.0);
}

TEST(CellReconsolidation, LeadsToStressesInProportionToThoseOfTheStart)
{
    Cell cell;
    double largest = 0.0;
    for (std::size_t p = 0; p < 3; ++p) largest = std::max(largest, cell.ratio(p));
    for (int step = 0; step < 200; ++step) {
        cell.even_out(0.01);
        for (std::size_t p = 0; p < 3; ++p) EXPECT_LT(cell.ratio(p), largest * (1.0 + 1e-12));
    }
    const Scalars start = cell.column("start_mean"), shear = cell.column("liquefied_shear");
    for (std::size_t p = 1; p < 3; ++p) {
        EXPECT_NEAR(cell.particles.stress.yy[p] / start[p], cell.particles.stress.yy[0] / start[0], 1e-6);
        const double line = std::min(shear[p], 0.08);
        EXPECT_NEAR(cell.column("compaction")[p] / line, cell.column("compaction")[0] / shear[0], 1e-6);
    }
}

/// What comes on top of s_0 is carried by all of them alike.
TEST(CellReconsolidation, SharesALaterLoadEvenly)
{
    Cell cell;
    for (Scalars* stress : {&cell.particles.stress.xx, &cell.particles.stress.yy})
        for (double& value : *stress) value -= 80e3;
    for (int step = 0; step < 400; ++step) cell.even_out(0.01);
    const SymmetricTensors& stress = cell.particles.stress;
    const auto mean = [&](std::size_t p) { return -0.5 * (stress.xx[p] + stress.yy[p]); };
    const Scalars start = cell.column("start_mean");
    for (std::size_t p = 1; p < 3; ++p) EXPECT_NEAR(mean(p) - mean(0), start[p] - start[0], 1.0) << p;
}

TEST(CellReconsolidation, RestsInSoilThatExpandsOrIsSheared)
{
    const Scalars before = Cell().particles.stress.yy;
    Cell expands;
    expands.set_rates(1e-3, 0.0);
    expands.even_out(0.01);
    EXPECT_EQ(expands.particles.stress.yy, before);
    Cell sheared; // with a hundredth of the shear rate as volume change, as much as water gives way
    sheared.set_rates(-1e-3, 0.1);
    sheared.even_out(0.01);
    Cell settles;
    settles.even_out(0.01);
    for (std::size_t p = 0; p < 3; ++p) {
        const double moved = std::abs(sheared.particles.stress.yy[p] - before[p]);
        EXPECT_LT(moved, 0.02 * std::abs(settles.particles.stress.yy[p] - before[p]));
    }
}

TEST(CellReconsolidation, IsThatOfTheMirroredCell)
{
    Cell cell, mirrored;
    for (double& stress : mirrored.particles.stress.xy) stress = -stress;
    cell.set_rates(-1e-3, 1e-3);
    mirrored.set_rates(-1e-3, -1e-3);
    cell.even_out(0.01);
    mirrored.even_out(0.01);
    EXPECT_EQ(mirrored.particles.stress.yy, cell.particles.stress.yy);
    for (std::size_t p = 0; p < 4; ++p)
        EXPECT_EQ(mirrored.particles.stress.xy[p], -cell.particles.stress.xy[p]);
}

/// In a hundred steps as in one.
TEST(CellReconsolidation, DependsOnTheStrainAloneNotOnTheSteps)
{
    Cell fine, coarse;
    for (int step = 0; step < 100; ++step) fine.even_out(1e-6);
    coarse.even_out(1e-4);
    for (std::size_t p = 0; p < 3; ++p)
        EXPECT_NEAR(fine.particles.stress.yy[p], coarse.particles.stress.yy[p],
                    1e-4 * std::abs(coarse.particles.stress.yy[p]));
}

} // namespace
} // namespace quicksand
