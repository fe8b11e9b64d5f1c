#include "solver/interpolation/cpdi2.hpp"
#include "tests/fixtures/checkout.hpp"
#include "tests/fixtures/scene_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace quicksand {
namespace {

using fixtures::column_scene;
using fixtures::column_section;
using fixtures::rectangular_section;
using fixtures::replaced;
using fixtures::SceneFolder;

double sum(const Scalars& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

AssembledCase assemble_column()
{
    return assemble_case(SceneFolder().read(column_scene), column_section());
}

TEST(Assembly, FillsTheColumn)
{
    const AssembledCase column = assemble_column();
    const Particles& particles = column.state.particles;
    ASSERT_EQ(particles.size(), 3429U);
    EXPECT_TRUE(particles.has_fluid());
    const double area = 0.0675 * 0.3175;
    EXPECT_NEAR(sum(particles.volume), area, 1e-14);
    EXPECT_NEAR(sum(particles.mass_solid), area * 0.595 * 2670.0, 1e-9);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        ASSERT_EQ(particles.identifier[p], static_cast<std::int32_t>(p));
        ASSERT_EQ(particles.porosity[p], 0.405);
        ASSERT_EQ(particles.pore_pressure[p], 0.0);
        ASSERT_EQ(particles.velocity_fluid[p], Vector2::Zero());
        ASSERT_EQ(particles.reference_position[p], particles.position[p]);
        ASSERT_EQ(particles.reference_edge_1[p], particles.half_edge_1[p]);
    }
}

TEST(Assembly, SetsAStressLinearInDepth)
{
    const AssembledCase column = assemble_column();
    const Particles& particles = column.state.particles;
    const double unit_weight = 0.595 * (2670.0 - 1000.0) * 120 * 9.81;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double vertical = unit_weight * (0.3175 - particles.position.y[p]);
        ASSERT_NEAR(particles.stress.yy[p], -vertical, 1e-10 * unit_weight);
        ASSERT_EQ(particles.stress.xx[p], 0.5 * particles.stress.yy[p]);
        ASSERT_EQ(particles.stress.zz[p], 0.5 * particles.stress.yy[p]);
        ASSERT_EQ(particles.stress.xy[p], 0.0);
    }
}

TEST(Assembly, LeavesNeoHookeanSoilFreeOfStress)
{
    // its law would forget the stress in the first step; the sand above it rests as ever
    Section section = rectangular_section(0.0, 0.0, 0.0675, 0.15);
    const Section upper = rectangular_section(0.0, 0.15, 0.0675, 0.3);
    section.regions.push_back({"rubber", section.regions[0].polygons});
    section.regions[0].polygons = upper.regions[0].polygons;
    section.curves = {section.curves[0]};
    section.upper = upper.upper;
    std::string text = column_scene.substr(0, column_scene.find("[boundaries.left]"));
    text += "[regions.rubber]\nmaterial = \"rubber\"\n[materials.rubber]\nmodel = \"neo_hookean\"\n"
            "shear_modulus = 1e6\npoisson_ratio = 0.3\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n"
            "grain_density = 2670\n[run]\nend_time = 1\n";
    const AssembledCase layers = assemble_case(SceneFolder().read(text), section);
    const Particles& particles = layers.state.particles;
    const double unit_weight = 0.595 * (2670.0 - 1000.0) * 120 * 9.81;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double vertical = y > 0.15 ? unit_weight * (0.3 - y) : 0.0;
        ASSERT_NEAR(particles.stress.yy[p], -vertical, 1e-10 * unit_weight);
        ASSERT_EQ(particles.stress.xx[p], 0.5 * particles.stress.yy[p]);
        ASSERT_EQ(particles.stress.zz[p], 0.5 * particles.stress.yy[p]);
    }
}

TEST(Assembly, SetsTheExcessPorePressureAndLeavesTheEffectiveStress)
{
    const AssembledCase plain = assemble_column();
    const AssembledCase loaded = assemble_case(
        SceneFolder().read(column_scene + "[initial]\nexcess_pore_pressure = \"3 kPa\"\n"), column_section());
    for (const double pressure : loaded.state.particles.pore_pressure) ASSERT_EQ(pressure, 3000.0);
    EXPECT_EQ(loaded.state.particles.stress.yy, plain.state.particles.stress.yy);
}

TEST(Assembly, GivesADrySceneItsFullWeightAndNoWater)
{
    std::string text = replaced(column_scene, "[water]\nlevel = 0.3175\n", "");
    text = replaced(text, "hydraulic_conductivity = 5.8e-5\n", "");
    const AssembledCase column = assemble_case(SceneFolder().read(text), column_section());
    const Particles& particles = column.state.particles;
    EXPECT_FALSE(particles.has_fluid());
    const double unit_weight = 0.595 * 2670.0 * 120 * 9.81;
    EXPECT_NEAR(particles.stress.yy[7], -unit_weight * (0.3175 - particles.position.y[7]),
                1e-10 * unit_weight);
}

TEST(Assembly, KeepsTheCornersOfTheMeshForCpdi2)
{
    Section section = rectangular_section(0.0, 0.0, 0.0675, 0.3175);
    const Vector2 a(0.0, 0.0), b(0.0675, 0.0), c(0.0675, 0.3175), d(0.0, 0.3175), low(0.03, 0.0),
        high(0.05, 0.3175);
    section.quads = {{{a, low, high, d}, 0}, {{low, b, c, high}, 0}};
    const std::string mesh = replaced(column_scene, "particles_per_cell = [3, 3]",
                                      "kind = \"mesh\"\n[analysis]\ninterpolation = \"cpdi2\"");
    const AssembledCase column = assemble_case(SceneFolder().read(mesh), section);
    const Particles& particles = column.state.particles;
    ASSERT_EQ(particles.size(), 2U);
    EXPECT_EQ(column.problem.interpolation, Interpolation::cpdi2);
    const auto corners = quadrilateral_corners(particles, 0);
    const Vector2 expected[4] = {a, low, high, d};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_LT((corners[k] - expected[k]).norm(), 1e-15) << k;
    EXPECT_NEAR(sum(particles.volume), 0.0675 * 0.3175, 1e-16);
    const std::string lattice = replaced(
        column_scene, "[gravity]", "[analysis]\ninterpolation = \"cpdi2\"\nstrain = \"small\"\n[gravity]");
    const AssembledCase rectangles = assemble_case(SceneFolder().read(lattice), column_section());
    EXPECT_EQ(rectangles.problem.strain, StrainForm::small);
    EXPECT_EQ(rectangles.state.particles.twist.x, Scalars(3429, 0.0));
    EXPECT_TRUE(assemble_column().state.particles.twist.x.empty());
}

TEST(Assembly, CarriesOnlyTheWaterThatTheFlowNeeds)
{
    const auto with = [](const std::string& keys) {
        const std::string text = replaced(column_scene, "level = 0.3175", "level = 0.3175\n" + keys);
        return assemble_case(SceneFolder().read(text), column_section());
    };
    const AssembledCase undrained = with("flow = \"undrained\""), drained = with("flow = \"drained\"");
    EXPECT_EQ(carried_flow(undrained.state.particles), WaterFlow::undrained);
    EXPECT_EQ(carried_flow(drained.state.particles), WaterFlow::drained);
    EXPECT_EQ(undrained.state.particles.stress.yy, assemble_column().state.particles.stress.yy);
    EXPECT_EQ(drained.state.particles.porosity[5], 0.405);
    EXPECT_TRUE(drained.state.particles.pore_pressure.empty());

    // drained, but its line rises above the level: pressures that stay
    const std::string line =
        replaced(column_scene, "level = 0.3175",
                 "level = 0.1\nflow = \"drained\"\nphreatic_line = [[0, 0.25], [0.05, 0.15], [0.06, 0.15]]");
    const AssembledCase risen = assemble_case(SceneFolder().read(line), column_section());
    EXPECT_EQ(carried_flow(risen.state.particles), WaterFlow::drained);
    EXPECT_EQ(risen.state.particles.pore_pressure.size(), risen.state.particles.size());

    const AssembledCase bubbly = with("saturation = 0.99\nair_pressure = \"300 kPa\"");
    const double with_air = 1.0 / (0.99 / 2.2e9 + 0.01 / 300e3);
    EXPECT_NEAR(bubbly.problem.water->bulk_modulus, with_air, 1e-14 * with_air);
    EXPECT_EQ(assemble_column().problem.water->bulk_modulus, 2.2e9);
    EXPECT_FALSE(bubbly.problem.water->cavitation_pressure);
    EXPECT_TRUE(bubbly.state.particles.tension_deficit.empty());
    const AssembledCase cavitating = with("cavitation_pressure = \"2.3 kPa\"");
    EXPECT_EQ(cavitating.problem.water->cavitation_pressure, 2300.0);
    EXPECT_EQ(cavitating.state.particles.tension_deficit.size(), 3429U);
}

TEST(Assembly, ReadsHowTheConductivityFollowsThePorosity)
{
    const std::string text =
        replaced(column_scene, "hydraulic_conductivity = 5.8e-5",
                 "hydraulic_conductivity = 5.8e-5\npermeability_law = \"kozeny_carman\"");
    const AssembledCase column = assemble_case(SceneFolder().read(text), column_section());
    EXPECT_EQ(column.problem.materials[0].permeability_law, PermeabilityLaw::kozeny_carman);
    EXPECT_EQ(assemble_column().problem.materials[0].permeability_law, PermeabilityLaw::constant);
}

TEST(Assembly, CoversTheSectionWithRoomAbove)
{
    const BackgroundGrid grid = assemble_column().problem.grid;
    EXPECT_EQ(grid.origin, Vector2::Zero());
    EXPECT_EQ(grid.cells_x, 9);
    EXPECT_EQ(grid.cells_y, 43 + 7);
    const std::string coarse = replaced(column_scene, "\"7.5 mm\"", "67.5e-3");
    EXPECT_EQ(assemble_case(SceneFolder().read(coarse), column_section()).problem.grid.cells_y, 5 + 2);
}

TEST(Assembly, TiesTheSides)
{
    const AssembledCase column = assemble_column();
    ASSERT_TRUE(column.problem.tied_sides);
    EXPECT_EQ(column.problem.tied_sides->left, "left");
    EXPECT_EQ(column.problem.tied_sides->right, "right");
    EXPECT_EQ(column.problem.tied_sides->x_left, 0.0);
    EXPECT_EQ(column.problem.tied_sides->x_right, 0.0675);
    ASSERT_EQ(column.problem.boundaries.size(), 4U);
    EXPECT_EQ(column.problem.boundaries[0].name, "base");
    EXPECT_TRUE(std::holds_alternative<FixedWall>(column.problem.boundaries[0].soil));
    EXPECT_EQ(column.problem.boundaries[0].segments.size(), 1U);
}

TEST(Assembly, AddsTheWeightOfTheLayersAbove)
{
    Section section = rectangular_section(0.0, 0.0, 0.0675, 0.15);
    const Section upper = rectangular_section(0.0, 0.15, 0.0675, 0.3);
    section.regions.push_back({"clay", upper.regions[0].polygons});
    section.curves = {section.curves[0]};
    section.upper = upper.upper;
    std::string text = column_scene.substr(0, column_scene.find("[boundaries.left]"));
    text += "[regions.clay]\nmaterial = \"clay\"\n[materials.clay]\nmodel = \"linear_elastic\"\n"
            "shear_modulus = 1e6\npoisson_ratio = 0.3\nporosity = 0.6\nhydraulic_conductivity = 1e-8\n"
            "grain_density = 2500\n[run]\nend_time = 1\n";
    const AssembledCase layers = assemble_case(SceneFolder().read(text), section);
    const Particles& particles = layers.state.particles;
    const double gravity = 120 * 9.81, sand = 0.595 * 1670.0 * gravity, clay = 0.4 * 1500.0 * gravity;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double vertical = y > 0.15 ? clay * (0.3 - y) : clay * 0.15 + sand * (0.15 - y);
        ASSERT_NEAR(particles.stress.yy[p], -vertical, 1e-9 * sand);
        ASSERT_EQ(particles.material[p], y > 0.15 ? 1 : 0);
        ASSERT_EQ(particles.region[p], y > 0.15 ? 1 : 0);
    }
}

TEST(Assembly, DividesTheSoilAtTheWaterLevel)
{
    std::string text = replaced(column_scene, "level = 0.3175", "level = 0.15");
    text = replaced(text, "porosity = 0.405", "porosity = 0.405\nsaturation_above_water = 0.4");
    const AssembledCase column = assemble_case(SceneFolder().read(text), column_section());
    const Problem& problem = column.problem;
    ASSERT_EQ(problem.materials.size(), 2U);
    EXPECT_TRUE(problem.materials[0].saturated);
    EXPECT_FALSE(problem.materials[1].saturated);
    EXPECT_EQ(problem.materials[1].name, "sand above the water");
    EXPECT_FALSE(problem.water->rises_above_level);
    const double gravity = 120 * 9.81, buoyant = 0.595 * 1670.0 * gravity,
                 moist = (0.595 * 2670.0 + 0.4 * 0.405 * 1000.0) * gravity;
    const Particles& particles = column.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p];
        const double vertical = y > 0.15 ? moist * (0.3175 - y) : moist * 0.1675 + buoyant * (0.15 - y);
        ASSERT_NEAR(particles.stress.yy[p], -vertical, 1e-9 * buoyant);
        ASSERT_EQ(particles.material[p], y > 0.15 ? 1 : 0);
        ASSERT_EQ(particles.pore_pressure[p], 0.0);
        const double density = (y > 0.15 ? moist : 0.595 * 2670.0 * gravity) / gravity;
        ASSERT_NEAR(particles.mass_solid[p], density * particles.volume[p], 1e-12);
    }
}

TEST(Assembly, WetsExactlyTheSoilBelowTheLevelBetweenRowsOfParticles)
{
    for (const std::string keys :
         {"level = 0.1512", "level = 0.1\nphreatic_line = [[0, 0.1512], [1, 0.1512]]"}) {
        const AssembledCase column = assemble_case(
            SceneFolder().read(replaced(column_scene, "level = 0.3175", keys)), column_section());
        const Particles& particles = column.state.particles;
        double wet = 0.0, width = 0.0;
        for (std::size_t p = 0; p < particles.size(); ++p) {
            const bool is_saturated =
                column.problem.materials[static_cast<std::size_t>(particles.material[p])].saturated;
            if (is_saturated) wet += particles.volume[p];
            width += particles.volume[p] / 0.3175;
        }
        EXPECT_NEAR(wet / width, 0.1512, 1e-12) << keys;
    }
}

TEST(Assembly, MoistSandIsLoosestAndDensestAtTheSamePorosityAsSaturatedSand)
{
    std::string text = replaced(column_scene, "level = 0.3175", "level = 0.15");
    text = replaced(text, "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3",
                    "model = \"ubcsand\"\nn1_60 = 13.9\nsaturation_above_water = 0.8");
    const AssembledCase column = assemble_case(SceneFolder().read(text), column_section());
    ASSERT_EQ(column.problem.materials.size(), 2U);
    const Material &wet = column.problem.materials[0], &moist = column.problem.materials[1];
    const UbcSand &sand = std::get<UbcSand>(wet.law), &above = std::get<UbcSand>(moist.law);
    // V_p = v m_s with the mass that the particles of each carry
    EXPECT_GT(moist.grain_density, 1.1 * wet.grain_density);
    EXPECT_NEAR(above.largest_specific_volume * moist.grain_density,
                sand.largest_specific_volume * wet.grain_density, 1e-12);
    EXPECT_NEAR(above.smallest_specific_volume * moist.grain_density,
                sand.smallest_specific_volume * wet.grain_density, 1e-12);
}

TEST(Assembly, GivesPorePressuresByTheDepthBelowAnInclinedPhreaticLine)
{
    const std::string text = replaced(column_scene, "level = 0.3175",
                                      "level = 0.1\nphreatic_line = [[0, 0.25], [0.05, 0.15], [0.06, 0.15]]");
    const AssembledCase column = assemble_case(SceneFolder().read(text), column_section());
    EXPECT_TRUE(column.problem.water->rises_above_level);
    const double gravity = 120 * 9.81, buoyant = 0.595 * 1670.0 * gravity, dry = 0.595 * 2670.0 * gravity;
    const Particles& particles = column.state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double y = particles.position.y[p], line = std::max(0.15, 0.25 - 2.0 * particles.position.x[p]);
        const double head = std::max(0.0, line - y);
        const double vertical = dry * (0.3175 - std::max(line, y)) + buoyant * head;
        ASSERT_NEAR(particles.stress.yy[p], -vertical, 1e-9 * buoyant);
        ASSERT_NEAR(static_water_pressure(column.problem, y) + particles.pore_pressure[p],
                    y > line ? 0.0 : 1000.0 * gravity * head, 1e-6);
    }
}

TEST(Assembly, PutsAProbeAtThePhysicalPointOfItsName)
{
    Section section = column_section();
    section.points = {{"crest", {0.02, 0.3}}};
    const std::string text = replaced(column_scene, "at = [0.03, 0.3]\n", "");
    const AssembledCase column = assemble_case(SceneFolder().read(text), section);
    EXPECT_EQ(column.scene.probes.at(0).at, Vector2(0.02, 0.3));
}

TEST(Assembly, ReadsTheColumnOfTheExamples)
{
    const std::filesystem::path file = in_checkout("examples/column/scene.toml");
    const AssembledCase column = assemble_case(read_scene_file(file, {}));
    EXPECT_EQ(column.state.particles.size(), 3429U);
    EXPECT_TRUE(column.warnings.empty()) << column.warnings.render(column.scene.text);
}

} // namespace
} // namespace quicksand
