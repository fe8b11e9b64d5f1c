#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <vector>

namespace quicksand {
namespace {

constexpr std::size_t array_count = 25; // four of the motion, four of the stress, the memory, volume and mass

/// Points in arrays with random stress, memory and motion.
class RandomPoints {
public:
    RandomPoints(const UbcSand& law, std::size_t count, unsigned seed) : random_(seed)
    {
        for (std::vector<double>& array : arrays_) array.resize(count);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (std::size_t p = 0; p < count; ++p) {
            UbcSandState state;
            state.sigma_x = 80e3 * unit(random_);
            state.sigma_y = 100e3 * unit(random_);
            state.sigma_z = 50e3 * unit(random_);
            state.tau_xy = 10e3 * (unit(random_) - 0.5);
            begin_shaking(law, state);
            points().set(p, state);
            arrays_[23][p] = unit(random_);
            arrays_[24][p] = 1.0;
        }
    }

    double specific_volume(std::size_t p) const { return arrays_[23][p] / arrays_[24][p]; }

    /// A velocity gradient for every point, over a wide range of sizes, some of them zero.
    void move(double scale)
    {
        std::normal_distribution<double> normal;
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (std::size_t p = 0; p < arrays_[0].size(); ++p) {
            const double size = unit(random_) < 0.1 ? 0.0 : scale * std::pow(10.0, -4.0 * unit(random_));
            for (std::size_t component = 0; component < 4; ++component) {
                arrays_[component][p] = size * normal(random_);
            }
        }
    }

    UbcSandArrays points()
    {
        std::array<double*, array_count> a{};
        for (std::size_t k = 0; k < a.size(); ++k) a[k] = arrays_[k].data();
        return {a[0],  a[1],  a[2],  a[3],  a[4],  a[5],  a[6],  a[7],  a[8],  a[9],  a[10], a[11], a[12],
                a[13], a[14], a[15], a[16], a[17], a[18], a[19], a[20], a[21], a[22], a[23], a[24]};
    }

    UbcSandIncrement increment(std::size_t p, double dt) const
    {
        const double xx = arrays_[0][p], xy = arrays_[1][p], yx = arrays_[2][p], yy = arrays_[3][p];
        return {-dt * xx, -dt * yy, -dt * (xy + yx), 0.5 * dt * (yx - xy)};
    }

private:
    std::mt19937 random_;
    std::array<std::vector<double>, array_count> arrays_;
};

std::vector<UbcSandState> states(RandomPoints& points, std::size_t count)
{
    std::vector<UbcSandState> states(count);
    for (std::size_t p = 0; p < count; ++p) states[p] = points.points().state(p);
    return states;
}

bool same_bits(const UbcSandState& a, const UbcSandState& b)
{
    return std::memcmp(&a, &b, sizeof(UbcSandState)) == 0;
}

/// Turn the points by the spin of a step, as the motion does before the law.
void turn(RandomPoints& points, std::size_t count, double dt)
{
    for (std::size_t p = 0; p < count; ++p) {
        const Rotation rotation = rotation_of(points.increment(p, dt).spin);
        UbcSandState state = points.points().state(p);
        ubcsand::turn_memory(rotation, state);
        ubcsand::turn_stress(rotation, state);
        points.points().set(p, state);
    }
}

/// Run arrays and single points side by side; the number of points that ever differ.
int differences(const UbcSandParameters& parameters, std::size_t count, unsigned seed, int steps)
{
    const UbcSand law = make_ubcsand(parameters);
    RandomPoints points(law, count, seed);
    std::vector<UbcSandState> single = states(points, count);
    int different = 0;
    for (int step = 0; step < steps; ++step) {
        points.move(1.0);
        const double dt = 1e-4;
        turn(points, count, dt);
        update(law, dt, 0, count, points.points());
        for (std::size_t p = 0; p < count; ++p) {
            const bool loosest = points.specific_volume(p) > law.largest_specific_volume;
            const bool densest = points.specific_volume(p) < law.smallest_specific_volume;
            single[p].least_contraction = loosest ? 0.0 : -1.0;
            single[p].most_contraction = densest ? 0.0 : 1.0;
            update(law, points.increment(p, dt), single[p]);
            single[p].least_contraction = -1.0; // not remembered
            single[p].most_contraction = 1.0;
            if (!same_bits(single[p], points.points().state(p))) ++different;
        }
    }
    return different;
}

TEST(UbcSandArrays, HaveTheBitsOfSinglePoints)
{
    EXPECT_EQ(differences(nevada_sand_55(), 203, 1, 2000), 0);
    EXPECT_EQ(differences(ubcsand_from_blow_count(5.0), 64, 2, 2000), 0);
}

TEST(UbcSandArrays, HaveTheBitsOfSinglePointsWithTheSettingsOfRunsAndLoosestAndDensestSand)
{
    UbcSandParameters parameters = with(UbcSandRunSettings(), nevada_sand_55());
    parameters.largest_specific_volume = 0.7; // of points from 0 to 1
    parameters.smallest_specific_volume = 0.3;
    EXPECT_EQ(differences(parameters, 203, 8, 1000), 0);
}

TEST(UbcSandArrays, HaveTheBitsOfSinglePointsForAnyNumberOfPoints)
{
    for (std::size_t count = 1; count < 20; ++count) {
        EXPECT_EQ(differences(nevada_sand_55(), count, static_cast<unsigned>(count), 100), 0);
        EXPECT_EQ(differences(with(UbcSandRunSettings(), nevada_sand_55()), count,
                              static_cast<unsigned>(count), 100),
                  0);
    }
}

TEST(UbcSandArrays, HaveTheSameBitsInAnyCompany)
{
    // lanes are filled with the points of a range that need more substeps: cut it anywhere
    const UbcSand law = make_ubcsand(with(UbcSandRunSettings(), nevada_sand_55()));
    constexpr std::size_t count = 700;
    RandomPoints together(law, count, 9), apart(law, count, 9);
    std::mt19937 random(10);
    for (int step = 0; step < 200; ++step) {
        together.move(3.0);
        apart.move(3.0);
        update(law, 1e-3, 0, count, together.points());
        for (std::size_t first = 0; first < count;) {
            const std::size_t last = std::min(count, first + 1 + random() % 60);
            update(law, 1e-3, first, last, apart.points());
            first = last;
        }
    }
    const std::vector<UbcSandState> a = states(together, count), b = states(apart, count);
    for (std::size_t p = 0; p < count; ++p) EXPECT_TRUE(same_bits(a[p], b[p])) << p;
}

TEST(UbcSandArrays, HaveTheBitsOfSinglePointsForAnyExponentAndCohesion)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.elastic_shear_exponent = 0.45;
    parameters.elastic_bulk_exponent = 0.6;
    parameters.plastic_shear_exponent = 0.3;
    parameters.cohesion = 2e3;
    EXPECT_EQ(differences(parameters, 50, 3, 1000), 0);
}

TEST(UbcSandArrays, PowersOfOneHalfAreSquareRootsToRounding)
{
    UbcSandParameters parameters = nevada_sand_55();
    const UbcSand roots = make_ubcsand(parameters);
    UbcSand powers = roots;
    powers.elastic = ElasticForm::powers;
    RandomPoints points(roots, 1, 4);
    UbcSandState a = points.points().state(0), b = a;
    for (int step = 0; step < 200; ++step) {
        points.move(1.0);
        update(roots, points.increment(0, 1e-5), a);
        update(powers, points.increment(0, 1e-5), b);
    }
    EXPECT_NEAR(a.sigma_y, b.sigma_y, 1e-6);
    EXPECT_NEAR(a.tau_xy, b.tau_xy, 1e-6);
}

TEST(UbcSandArrays, LeaveTheTurningToTheCaller)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    RandomPoints points(law, 9, 5);
    const std::vector<UbcSandState> before = states(points, 9);
    points.move(1.0);
    update(law, 1e-4, 0, 9, points.points());
    for (std::size_t p = 0; p < 9; ++p) {
        UbcSandState expected = before[p];
        UbcSandIncrement increment = points.increment(p, 1e-4);
        increment.spin = 0.0;
        update(law, increment, expected);
        // a turn by nothing rounds the stress in its last digit
        EXPECT_NEAR(expected.sigma_x, points.points().state(p).sigma_x, 1e-6) << p;
        EXPECT_NEAR(expected.tau_xy, points.points().state(p).tau_xy, 1e-6) << p;
        EXPECT_NEAR(expected.peak_x, points.points().state(p).peak_x, 1e-11) << p;
        EXPECT_NEAR(expected.origin_y, points.points().state(p).origin_y, 1e-11) << p;
    }
}

TEST(UbcSandArrays, TouchOnlyTheirRange)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    RandomPoints points(law, 30, 6);
    const std::vector<UbcSandState> before = states(points, 30);
    points.move(1.0);
    update(law, 1e-4, 3, 14, points.points());
    const std::vector<UbcSandState> after = states(points, 30);
    for (std::size_t p = 0; p < 30; ++p) {
        if (p < 3 || p >= 14) {
            EXPECT_TRUE(same_bits(before[p], after[p])) << p;
        }
    }
    EXPECT_FALSE(same_bits(before[13], after[13]));
}

TEST(UbcSandArrays, ModuliFollowTheMeanStress)
{
    const UbcSand law = make_ubcsand(nevada_sand_55());
    RandomPoints points(law, 40, 7);
    std::vector<double> volumes;
    double stiffest = 0.0, sum = 0.0, whole = 0.0;
    for (const UbcSandState& state : states(points, 40)) {
        volumes.push_back(1.0 + 0.1 * static_cast<double>(volumes.size()));
        const double modulus = constrained_modulus(law, state);
        stiffest = std::max(stiffest, modulus);
        sum += volumes.back() * modulus;
        whole += volumes.back();
    }
    const UbcSandArrays arrays = points.points();
    const ParticleModuli moduli =
        particle_moduli(law, 0, 40, arrays.stress_xx, arrays.stress_yy, volumes.data());
    EXPECT_DOUBLE_EQ(moduli.stiffest, stiffest);
    EXPECT_NEAR(moduli.mean, sum / whole, 1e-12 * stiffest);
    EXPECT_LT(moduli.mean, 0.9 * stiffest) << "the points differ";
}

} // namespace
} // namespace quicksand
