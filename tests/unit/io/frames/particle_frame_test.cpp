#include "io/frames/particle_frame.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

std::vector<std::string> names_of(const std::vector<FrameArray>& arrays)
{
    std::vector<std::string> names;
    for (const FrameArray& array : arrays) names.push_back(array.name);
    return names;
}

const FrameArray& find(const Frame& frame, const std::string& name)
{
    return *std::find_if(frame.cell_data.begin(), frame.cell_data.end(),
                         [&](const FrameArray& array) { return array.name == name; });
}

float single(const Frame& frame, const std::string& name, std::size_t index)
{
    return std::get<std::vector<float>>(find(frame, name).values).at(index);
}

} // namespace

TEST(ParticleFrame, HasTheFieldsOfASaturatedScene)
{
    const Problem problem = fixtures::small_problem(true);
    const Frame frame = particle_frame(problem, fixtures::small_state(problem));
    EXPECT_EQ(names_of(frame.cell_data),
              (std::vector<std::string>{
                  "displacement", "velocity_solid", "velocity_fluid", "pore_pressure", "excess_pore_pressure",
                  "ru", "mean_effective_stress", "vertical_effective_stress", "deviatoric_stress", "stress",
                  "shear_strain", "volumetric_strain", "porosity", "material", "region", "particle_id"}));
    EXPECT_EQ(find(frame, "stress").components, (std::vector<std::string>{"XX", "YY", "ZZ", "XY"}));
    EXPECT_EQ(find(frame, "velocity_fluid").unit, "m/s");
    EXPECT_EQ(frame.texts[0].lines, std::vector<std::string>{"sand"});
    EXPECT_EQ(frame.texts[1].lines, std::vector<std::string>{"ground"});
}

TEST(ParticleFrame, ShowsOfReducedFlowsWhatTheyHave)
{
    Problem problem = fixtures::small_problem(true);
    problem.water->flow = WaterFlow::drained;
    const State state = fixtures::small_state(problem);
    const Frame frame = particle_frame(problem, state);
    const auto names = names_of(frame.cell_data);
    EXPECT_EQ(std::count(names.begin(), names.end(), "velocity_fluid"), 0);
    EXPECT_EQ(single(frame, "excess_pore_pressure", 3), 0.0F);
    const double depth = 1.5 - state.particles.position.y[3];
    EXPECT_FLOAT_EQ(single(frame, "pore_pressure", 3), static_cast<float>(1000.0 * problem.gravity * depth));
    EXPECT_FLOAT_EQ(single(frame, "porosity", 3), 0.43F);
}

TEST(ParticleFrame, LeavesOutTheWaterOfADryScene)
{
    const Problem problem = fixtures::small_problem(false);
    const auto names = names_of(particle_frame(problem, fixtures::small_state(problem)).cell_data);
    for (const char* name : {"velocity_fluid", "pore_pressure", "excess_pore_pressure", "ru", "porosity"})
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 0) << name;
}

TEST(ParticleFrame, ShowsWhatSoilLawsRemember)
{
    Problem problem = fixtures::small_problem(true);
    problem.materials.push_back(problem.materials[0]);
    problem.materials[1].law = UbcSand();
    State state = fixtures::small_state(problem);
    state.particles.material[2] = 1;
    const LawMemory memory = memory_of(problem.materials[1].law);
    add_memory(state.particles, memory.size());
    state.particles.memory[column_of(memory, "half_cycles")][2] = 7.0;
    const Frame frame = particle_frame(problem, state);
    EXPECT_EQ(single(frame, "half_cycles", 2), 7.0F);
    EXPECT_TRUE(std::isnan(single(frame, "half_cycles", 3))); // of a law that counts none
    const auto names = names_of(frame.cell_data);
    EXPECT_EQ(std::count(names.begin(), names.end(), "waiting"), 0);
}

TEST(ParticleFrame, CarriesTheStateInItsSigns)
{
    const Problem problem = fixtures::small_problem(true);
    State state = fixtures::small_state(problem);
    Particles& particles = state.particles;
    state.time = 2.5;
    const std::size_t p = 5;
    const double initial = particles.initial_vertical_effective_stress[p];
    const double depth = 1.5 - particles.position.y[p];
    particles.pore_pressure[p] = 0.25 * initial;
    // simple shear by 0.02 about the centre, which moves up by 0.1 m
    particles.half_edge_2.x[p] += 0.02 * particles.half_edge_2.y[p];
    particles.position.y[p] += 0.1;

    const Frame frame = particle_frame(problem, state);
    EXPECT_EQ(frame.time, 2.5);
    EXPECT_FLOAT_EQ(single(frame, "displacement", 3 * p + 1), 0.1F);
    EXPECT_FLOAT_EQ(single(frame, "vertical_effective_stress", p), static_cast<float>(initial));
    EXPECT_FLOAT_EQ(single(frame, "stress", 4 * p + 1), static_cast<float>(-initial));
    EXPECT_FLOAT_EQ(single(frame, "ru", p), 0.25F);
    EXPECT_FLOAT_EQ(single(frame, "excess_pore_pressure", p), static_cast<float>(0.25 * initial));
    EXPECT_FLOAT_EQ(single(frame, "pore_pressure", p),
                    static_cast<float>(1000.0 * problem.gravity * (depth - 0.1) + 0.25 * initial));
    EXPECT_NEAR(single(frame, "shear_strain", p), 0.02F, 1e-8);
    EXPECT_NEAR(single(frame, "volumetric_strain", p), 0.0F, 1e-8);
    const auto corners = frame.cells[p];
    EXPECT_EQ(std::vector(corners.begin(), corners.end()), (std::vector<std::int64_t>{20, 21, 22, 23}));
}

} // namespace quicksand
