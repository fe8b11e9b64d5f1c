// One column of cells for all of them, and one particle for each of its rows: the same answer as the run of
// all, but for rounding.
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/motion/body_part.hpp"
#include "solver/motion/wrapping.hpp"
#include "solver/run/staged_run.hpp"
#include "solver/step/two_phase_step.hpp"
#include "tests/fixtures/sand_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {
namespace {

using namespace fixtures;

constexpr double body_cell = 0.02,
                 body_height = 12.0 * body_cell + body_cell / 3.0; // the last cell is filled in part [m]

/// Sand at 120 g between tied sides, four cells wide, shaken by 24 g.
Problem make_ground()
{
    Problem problem = centrifuge_column();
    problem.grid = {{-2.0 * body_cell, 0.0}, body_cell, 8, 15};
    Material& sand = problem.materials[0];
    sand.law = make_ubcsand(sand_of_runs());
    sand.hydraulic_conductivity = 5.8e-5;
    problem.region_names = {"sand"};
    problem.water = water_to(body_height);
    problem.boundaries =
        rectangle(0.0, 0.0, 4.0 * body_cell, body_height, FixedWall{}, TiedSide{}, FreeFace{});
    problem.tied_sides = TiedSides{"left", "right", 0.0, 4.0 * body_cell};
    problem.base_motion = SineMotion{24.0 * standard_gravity, 180.0, 50.0, 2.0};
    return problem;
}

State body_state(const Problem& problem)
{
    State state = fill(problem, 3, [](const Vector2& x) {
        return x.x() > 0.0 && x.x() < 4.0 * body_cell && x.y() < body_height;
    });
    set_level_ground_stress(problem, body_height, 0.5, state);
    return state;
}

/// The same ground with one particle as wide as a cell in each row: the sums of a column are those of all
/// columns to the last digits, so that not even sand in cycles tells them apart.
State state_of_wide_particles(const Problem& problem)
{
    State state = body_state(problem);
    const Particles& narrow = state.particles;
    std::vector<std::size_t> middle;
    for (std::size_t p = 0; p < narrow.size(); ++p)
        if (std::lround(3.0 * narrow.position.x[p] / body_cell - 0.5) % 3 == 1) middle.push_back(p);
    Particles wide = part_of(narrow, middle);
    for (Scalars* amounts :
         {&wide.half_edge_1.x, &wide.reference_edge_1.x, &wide.volume, &wide.mass_solid, &wide.water_volume})
        for (double& amount : *amounts) amount *= 3.0;
    state.particles = std::move(wide);
    return state;
}

/// The runs of all columns and of the one that stands for them.
struct Pair {
    StagedRun all, one;

    Pair(const Problem& body, const State& state, double end_time)
        : all(body, state, {end_time, ColumnsComputed::all, true}),
          one(body, state, {end_time, ColumnsComputed::one, true})
    {
    }
    void shake()
    {
        for (StagedRun* each : {&all, &one}) {
            each->begin_shaking();
            EXPECT_TRUE(each->shake({}));
        }
        EXPECT_EQ(all.state().step, one.state().step);
    }
};

/// The vector or tensor that a component belongs to: what is zero but for rounding is small beside the
/// others.
std::string whole_of(const std::string& name)
{
    if (name == "cycles_last_leg") return "cycles_leg"; // a strain as well, of nothing where none has ended
    const std::size_t end = name.rfind('_');
    const std::string component = end == std::string::npos ? "" : name.substr(end + 1);
    const bool is_component = !component.empty() && component.find_first_not_of("xyz") == std::string::npos;
    return is_component ? name.substr(0, end) : name;
}

/// Largest difference of two states of a body, relative to the largest size, by vector or tensor.
std::map<std::string, double> differences(const Particles& a, const Particles& b)
{
    std::vector<std::size_t> place(b.size());
    for (std::size_t p = 0; p < b.size(); ++p) place[static_cast<std::size_t>(b.identifier[p])] = p;
    std::vector<const Scalars*> arrays;
    for_each_array(b, [&](const char*, const Scalars& values) { arrays.push_back(&values); });
    std::map<std::string, double> difference, size;
    std::size_t k = 0;
    for_each_array(a, [&](const char* name, const Scalars& values) {
        const Scalars& others = *arrays[k++];
        const std::string whole = whole_of(name);
        for (std::size_t p = 0; p < values.size(); ++p) {
            const double other = others[place[static_cast<std::size_t>(a.identifier[p])]];
            size[whole] = std::max(size[whole], std::abs(other));
            difference[whole] = std::max(difference[whole], std::abs(values[p] - other));
        }
    });
    for (auto& [whole, value] : difference)
        if (size[whole] > 0.0) value /= size[whole];
    return difference;
}

void expect_same(const Particles& a, const Particles& b, double tolerance)
{
    for (const auto& [whole, difference] : differences(a, b)) EXPECT_LT(difference, tolerance) << whole;
}

TEST(SoilColumn, RunsAsAllColumnsDoExplicitly)
{
    const Problem body = make_ground();
    Pair runs(body, state_of_wide_particles(body), 2.0 / 180.0);
    const State& all = runs.all.state();
    ASSERT_NE(runs.one.column(), nullptr);
    EXPECT_EQ(runs.one.column()->columns, 4);
    EXPECT_EQ(4 * runs.one.state().particles.size(), all.particles.size());
    runs.shake();
    const State& wide = runs.one.state_of_body();
    expect_same(wide.particles, all.particles, 1e-10);
    EXPECT_GT(*std::max_element(all.particles.pore_pressure.begin(), all.particles.pore_pressure.end()), 5e3);

    std::vector<double> sums;
    for_each_number(*all.balance_terms, [&](const char*, double value) { sums.push_back(value); });
    const double size =
        std::max(std::abs(all.balance_terms->base_work), std::abs(all.balance_terms->skeleton_work));
    std::size_t k = 0;
    for_each_number(*wide.balance_terms, [&](const char* name, double value) {
        EXPECT_NEAR(value, sums[k], 1e-10 * std::max(size, std::abs(sums[k]))) << name;
        ++k;
    });
}

/// Steps of the semi-implicit scheme whose pressures are solved for to the last digits.
void step_exactly(const Problem& problem, double dt, int steps, State& state)
{
    SemiImplicitWorkspace work = make_semi_implicit_workspace(problem);
    work.controls.tolerance = 1e-12;
    for (int k = 0; k < steps; ++k) {
        advance_semi_implicit_step(problem, dt, state, work);
        wrap_particles(problem, state.particles);
    }
}

TEST(SoilColumn, RunsAsAllColumnsDoSemiImplicitly)
{
    Problem body = make_ground();
    body.scheme = TimeScheme::semi_implicit;
    State all = state_of_wide_particles(body);
    begin_shaking(body, all);
    SoilColumn column = *find_soil_column(body, all).column;
    const double dt = 0.8 * stable_time_step(body, all.particles).dt;
    const int steps = static_cast<int>(2.0 / 180.0 / dt);
    step_exactly(body, dt, steps, all);
    step_exactly(column.problem, dt, steps, column.state);
    State wide;
    widen(column, column.state, wide);
    expect_same(wide.particles, all.particles, 1e-10);
    EXPECT_GT(*std::max_element(all.particles.pore_pressure.begin(), all.particles.pore_pressure.end()), 5e3);
}

TEST(SoilColumn, RunsAsAllColumnsDoUnderALoadOnRock)
{
    Problem body = make_ground();
    body.boundaries[0].soil = ViscousFace{HalfSpace{2200.0, 760.0, 1500.0}};
    body.boundaries[2].soil = FreeFace{SurfaceLoad{{2e3, -2e4}, 0.0, {}}};
    State all = state_of_wide_particles(body);
    ASSERT_TRUE(attach_boundaries(body, all.particles).empty());
    Pair runs(body, all, 0.5 / 180.0);
    ASSERT_NE(runs.one.column(), nullptr);
    EXPECT_FALSE(runs.one.problem().boundaries[2].pieces.empty());
    runs.shake();
    expect_same(runs.one.state_of_body().particles, runs.all.state().particles, 1e-10);
}

TEST(SoilColumn, SettlesAsAllColumnsDo)
{
    Problem body = make_ground();
    body.materials[0].law = LinearElastic{20e6, 0.3};
    State drawn = state_of_wide_particles(body);
    for (Scalars* stress :
         {&drawn.particles.stress.xx, &drawn.particles.stress.yy, &drawn.particles.stress.zz})
        std::fill(stress->begin(), stress->end(), 0.0);
    Pair runs(body, drawn, 0.0);
    ASSERT_NE(runs.one.column(), nullptr);
    RelaxationControls controls;
    controls.tolerance = 1e-2; // nearer to rest the damping, by the sign of velocities, lets rounding grow
    EXPECT_EQ(runs.all.settle(controls).steps, runs.one.settle(controls).steps);
    const Particles& all = runs.all.state().particles;
    expect_same(runs.one.state_of_body().particles, all, 1e-10);
    EXPECT_LT(*std::min_element(all.stress.yy.begin(), all.stress.yy.end()), -1e5);
}

/// Elastic ground of 3 x 3 particles a cell on rock, loaded at once while it is shaken.
Problem elastic_ground(TimeScheme scheme)
{
    Problem body = make_ground();
    body.scheme = scheme;
    body.materials[0].law = LinearElastic{20e6, 0.3};
    body.boundaries[0].soil = ViscousFace{HalfSpace{2200.0, 760.0, 1500.0}};
    body.boundaries[2].soil = FreeFace{SurfaceLoad{{2e3, -2e4}, 0.0, {}}};
    return body;
}

/// The same soil, of regions that keep the particles of a row apart.
State state_of_single_particles(State state)
{
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.region[p] =
            static_cast<std::int32_t>(std::lround(3.0 * particles.position.x[p] / body_cell - 0.5) % 3);
    return state;
}

/// Elastic ground loaded while it is shaken, with one particle for each row and with all of them.
struct RowPair {
    Problem body;
    State single, rows;

    explicit RowPair(TimeScheme scheme) : body(elastic_ground(scheme))
    {
        body.region_names = {"left", "middle", "right"};
        rows = body_state(body);
        EXPECT_TRUE(attach_boundaries(body, rows.particles).empty());
        single = state_of_single_particles(rows);
    }
};

// Sums over a row of three are not those of one particle with three times the mass in the last digit. Water
// answers to that with its bulk modulus, and affine velocities are quotients of moments that nearly cancel.
void expect_same_but_for_rounding(const Problem& body, const Particles& rows, const Particles& single)
{
    const double most = *std::max_element(single.pore_pressure.begin(), single.pore_pressure.end());
    EXPECT_GT(most, 1e4);
    const std::map<std::string, double> tolerances = {
        {"pore_pressure", 1e-11 * body.water->bulk_modulus / most},
        {"pore_pressure_rate", 1e-6},
        {"affine_velocity_solid", 1e-6},
        {"affine_velocity_fluid", 1e-6},
    };
    for (const auto& [whole, difference] : differences(rows, single)) {
        const auto own = tolerances.find(whole);
        EXPECT_LT(difference, own == tolerances.end() ? 1e-10 : own->second) << whole;
    }
}

TEST(SoilColumn, RowsRunAsAllTheirParticlesDoExplicitly)
{
    const RowPair pair(TimeScheme::explicit_steps);
    const RunControls controls{0.5 / 180.0, ColumnsComputed::one, true};
    StagedRun single(pair.body, pair.single, controls), rows(pair.body, pair.rows, controls);
    for (StagedRun* run : {&single, &rows}) {
        ASSERT_NE(run->column(), nullptr);
        run->begin_shaking();
        EXPECT_TRUE(run->shake({}));
    }
    EXPECT_EQ(single.column()->row_length, 1);
    EXPECT_EQ(rows.column()->row_length, 3);
    EXPECT_EQ(3 * rows.state().particles.size(), single.state().particles.size());
    EXPECT_EQ(rows.state().step, single.state().step);
    expect_same_but_for_rounding(pair.body, rows.state_of_body().particles, single.state_of_body().particles);
}

TEST(SoilColumn, RowsRunAsAllTheirParticlesDoSemiImplicitly)
{
    const RowPair pair(TimeScheme::semi_implicit);
    SoilColumn single = *find_soil_column(pair.body, pair.single).column;
    SoilColumn rows = *find_soil_column(pair.body, pair.rows).column;
    EXPECT_EQ(3 * rows.state.particles.size(), single.state.particles.size());
    const double dt = 0.8 * stable_time_step(single.problem, single.state.particles).dt;
    State wide_of_single, wide_of_rows;
    for (const auto& [column, wide] :
         {std::pair{&single, &wide_of_single}, std::pair{&rows, &wide_of_rows}}) {
        step_exactly(column->problem, dt, 60, column->state);
        widen(*column, column->state, *wide);
    }
    expect_same_but_for_rounding(pair.body, wide_of_rows.particles, wide_of_single.particles);
}

// Soil that moves at one velocity is at rest beside itself: rows come in where they go out.
TEST(SoilColumn, RowsThatDriftCarryTheSame)
{
    Problem body = elastic_ground(TimeScheme::explicit_steps);
    body.base_motion = NoMotion{};
    body.boundaries[0].soil = RollerWall{};
    body.boundaries[2].soil = FreeFace{SurfaceLoad{{0.0, -2e4}, 0.0, {}}};
    State still = body_state(body);
    ASSERT_TRUE(attach_boundaries(body, still.particles).empty());
    State drifting = still;
    for (Scalars* velocity : {&drifting.particles.velocity_solid.x, &drifting.particles.velocity_fluid.x})
        std::fill(velocity->begin(), velocity->end(), 20.0);
    const double end = 2e-3;
    const RunControls controls{end, ColumnsComputed::one, true};
    StagedRun at_rest(body, still, controls), at_speed(body, drifting, controls);
    for (StagedRun* run : {&at_rest, &at_speed}) {
        ASSERT_NE(run->column(), nullptr);
        run->begin_shaking();
        run->shake({});
    }
    const double third = body_cell / 3.0;
    for (const double x : at_speed.state().particles.position.x)
        EXPECT_LE(std::abs(x - 0.5 * body_cell), 0.5 * third);
    const Particles& one = at_rest.state_of_body().particles;
    const Particles& other = at_speed.state_of_body().particles;
    for (std::size_t p = 0; p < one.size(); ++p)
        EXPECT_NEAR(other.position.x[p] - one.position.x[p], 20.0 * end, 1e-12);
    const auto difference = differences(one, other);
    for (const char* whole : {"stress", "porosity", "volume", "half_edge_1", "half_edge_2"})
        EXPECT_LT(difference.at(whole), 1e-10) << whole;
    EXPECT_GT(*std::max_element(one.pore_pressure.begin(), one.pore_pressure.end()), 1e4);
}

} // namespace
} // namespace quicksand
