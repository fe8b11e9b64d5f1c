// A wall drawn as a thin elastic region bends as a beam of its stiffness, but for a factor that the cells and
// the particles across it give: GUIDE.md, "Structures".
#include "tests/fixtures/drawn_section.hpp"

#include <gtest/gtest.h>

#include <map>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double pile_thickness = 0.5, pile_height = 5.0, pile_shear_modulus = 10e9; // [m], [Pa]
constexpr double pile_density = 2400.0, pile_push = 0.01;                            // [kg/m3], [m/s2]

struct Resolution {
    int cells = 1, per_cell = 2; // across the thickness; particles along an edge of a cell
    std::string member = "cpdi";
    double shift = 0.0;   // of the wall against the grid's lines [cells]
    double poisson = 0.0; // [-]
};

/// A wall that stands on its foot without weight. `tip_pressure` acts at its back over the highest cell [Pa].
AssembledCase cantilever(const Resolution& of, double tip_pressure)
{
    const double h = pile_thickness / of.cells;
    const Section section = polygon_section({{{0.0, 0.0}, "base"},
                                             {{pile_thickness, 0.0}, ""},
                                             {{pile_thickness, pile_height - h}, "tip"},
                                             {{pile_thickness, pile_height}, ""},
                                             {{0.0, pile_height}, ""}});
    const std::string count = std::to_string(of.per_cell);
    std::string tables =
        "[sampling]\nparticles_per_cell = [" + count + ", " + count + "]\n[analysis]\ninterpolation = \"" +
        of.member +
        "\"\n[gravity]\nacceleration = 0.0\n[boundaries.base]\nsoil = \"fixed\"\n[regions.soil]\n"
        "material = \"steel\"\n[materials.steel]\nmodel = \"linear_elastic\"\nwater = \"none\"\n"
        "density = 2400.0\nshear_modulus = 10e9\npoisson_ratio = " +
        std::to_string(of.poisson) + "\n";
    if (tip_pressure > 0.0)
        tables += "[boundaries.tip]\nsoil = \"free\"\npressure = " + std::to_string(tip_pressure) + "\n";
    const int cells = static_cast<int>(pile_height / h) + 8;
    return assemble(scene_with(h, {-(3.0 + of.shift) * h, -4.0 * h}, of.cells + 7, cells, tables), section);
}

/// Deflection of the end of a settled cantilever [m].
double deflection(AssembledCase assembled, const Resolution& of)
{
    std::map<std::int32_t, Vector2> before;
    const Particles& particles = assembled.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        before[particles.identifier[p]] = particles.position[p];
    RelaxationControls controls;
    controls.tolerance = 5e-5;
    EXPECT_TRUE(relax(assembled.problem, controls, assembled.state).settled);
    double n = 0.0, y = 0.0, u = 0.0, yy = 0.0, yu = 0.0; // of the straight line through the end
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const Vector2 start = before.at(particles.identifier[p]), now = particles.position[p];
        if (start.y() < pile_height - 2.0 * pile_thickness / of.cells) continue;
        const double over = start.y() - pile_height, moved = start.x() - now.x();
        n += 1.0, y += over, u += moved, yy += over * over, yu += over * moved;
    }
    return (u * yy - y * yu) / (n * yy - y * y);
}

/// Deflection of a wall under a load at its tip and under one that grows linearly to its foot, over that of a
/// beam with the stiffness E t^3 / (12 (1 - nu^2)) in plane strain and 5/6 G t against shear.
struct Ratios {
    double tip = 0.0, triangle = 0.0;
};

Ratios deflections(const Resolution& of)
{
    const double nu = of.poisson, E = 2.0 * pile_shear_modulus * (1.0 + nu), h = pile_thickness / of.cells,
                 pressure = 1e3;
    const double bending = E * pile_thickness * pile_thickness * pile_thickness / 12.0 / (1.0 - nu * nu),
                 shear = 5.0 / 6.0 * pile_shear_modulus * pile_thickness;
    const double load = pressure * h, arm = pile_height - 0.5 * h,
                 weight = pile_density * pile_thickness * pile_push;
    const double of_tip = load * arm * arm * (arm / 3.0 + 0.25 * h) / bending + load * arm / shear;
    const double of_triangle = weight * std::pow(pile_height, 4) / (30.0 * bending) +
                               weight * pile_height * pile_height / (6.0 * shear);
    AssembledCase pushed = cantilever(of, 0.0);
    pushed.problem.body_acceleration = [](const Vector2& x, double) {
        return Vector2(-pile_push * (1.0 - x.y() / pile_height), 0.0);
    };
    return {deflection(cantilever(of, pressure), of) / of_tip, deflection(pushed, of) / of_triangle};
}

// The factors of the table in GUIDE.md.
TEST(SheetPile, BendsAsABeamButForAFactor)
{
    struct Row {
        int cells, per_cell;
        double factor;
    };
    for (const Row& row : {Row{1, 2, 0.89}, Row{1, 3, 0.75}, Row{1, 4, 0.71}, Row{2, 2, 0.97},
                           Row{2, 3, 0.92}, Row{2, 4, 0.91}, Row{4, 2, 0.99}}) {
        const Ratios ratios = deflections({.cells = row.cells, .per_cell = row.per_cell});
        EXPECT_NEAR(ratios.tip, row.factor, 0.01) << row.cells << ' ' << row.per_cell;
        EXPECT_NEAR(ratios.triangle, row.factor, 0.01) << row.cells << ' ' << row.per_cell;
    }
}

TEST(SheetPile, BendsAlikeWithEveryMemberOfTheFamilyAndBetweenTheLines)
{
    for (const std::string member : {"cpdi2", "linear"})
        EXPECT_NEAR(deflections({.member = member}).tip, 0.89, 0.01) << member;
    EXPECT_NEAR(deflections({.shift = 0.5}).tip, 0.89, 0.01);
    EXPECT_NEAR(deflections({.cells = 2, .shift = 0.5}).tip, 0.97, 0.01);
}

} // namespace
} // namespace quicksand
