#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/columns/soil_column.hpp"
#include "solver/measure/balances.hpp"
#include "solver/motion/wrapping.hpp"
#include "solver/run/column_observer.hpp"
#include "tests/fixtures/soil_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace quicksand {

using namespace fixtures;

namespace {

std::string column_obstacle(const Problem& problem, const State& state)
{
    const ColumnSearch search = find_soil_column(problem, state);
    EXPECT_FALSE(search.column.has_value());
    return search.obstacle;
}

constexpr const char* soil_differs = "the soil does not repeat from cell to cell";

} // namespace

TEST(SoilColumn, IsOneCellWideWithTheCurvesOfTheBody)
{
    const Problem body = tied_ground();
    const ColumnSearch search = find_soil_column(body, level_state(body));
    ASSERT_TRUE(search.column.has_value());
    EXPECT_EQ(search.obstacle, "");
    const SoilColumn& column = *search.column;
    EXPECT_EQ(column.columns, 5);
    EXPECT_EQ(column.row_length, 2);
    EXPECT_EQ(column.state.particles.size(), 6u);
    EXPECT_EQ(column.problem.grid.cells_x, 1);
    EXPECT_EQ(column.problem.grid.cells_y, 5);
    EXPECT_EQ(column.problem.grid.origin, Vector2(0.0, 0.0));
    EXPECT_EQ(column.problem.tied_sides->x_right, 1.0);
    const std::vector<Boundary>& curves = column.problem.boundaries;
    EXPECT_EQ(curves[0].segments[0].start, Vector2(0.0, 0.0)); // base
    EXPECT_EQ(curves[0].segments[0].end, Vector2(1.0, 0.0));
    EXPECT_EQ(curves[1].segments[0].start, Vector2(1.0, 0.0)); // right
    EXPECT_EQ(curves[2].segments[0].start, Vector2(1.0, 3.0)); // top, the soil to its left
    EXPECT_EQ(curves[2].segments[0].end, Vector2(0.0, 3.0));
    EXPECT_EQ(curves[3].segments[0].start, Vector2(0.0, 3.0)); // left
}

TEST(SoilColumn, WidensToTheBodyItWasFoundIn)
{
    const Problem body = tied_ground();
    State state = level_state(body);
    open_balances(body, state);
    SoilColumn column = *find_soil_column(body, state).column;
    column.state.balance_terms.reset();
    open_balances(column.problem, column.state);
    State wide;
    widen(column, column.state, wide);
    EXPECT_EQ(wide.particles.identifier, state.particles.identifier);
    EXPECT_EQ(wide.particles.material, state.particles.material);
    std::vector<Scalars> arrays;
    for_each_array(state.particles, [&](const char*, const Scalars& values) { arrays.push_back(values); });
    std::size_t k = 0;
    for_each_array(wide.particles, [&](const char* name, const Scalars& values) {
        ASSERT_EQ(values.size(), arrays[k].size()) << name;
        for (std::size_t p = 0; p < values.size(); ++p) EXPECT_NEAR(values[p], arrays[k][p], 1e-12) << name;
        ++k;
    });
    EXPECT_NEAR(wide.balance_terms->opening_water_content, state.balance_terms->opening_water_content, 1e-12);
}

TEST(SoilColumn, OneParticleStandsForARowOfEqualOnes)
{
    const Problem body = tied_ground();
    State state = level_state(body);
    const SoilColumn column = *find_soil_column(body, state).column;
    for (std::size_t p = 0; p < 6; ++p) {
        EXPECT_EQ(column.state.particles.position.x[p], 0.5);
        EXPECT_EQ(column.state.particles.reference_position.x[p], 0.5);
        EXPECT_EQ(column.state.particles.volume[p], 0.5);
        EXPECT_EQ(column.state.particles.half_edge_1.x[p], 0.25);
        EXPECT_EQ(column.state.particles.mass_solid[p], 2.0 * state.particles.mass_solid[0]);
    }
    Particles& particles = state.particles;
    for (std::size_t p = 0; p < particles.size(); ++p) // left of the middle of cells
        if (particles.position.x[p] - std::floor(particles.position.x[p]) < 0.5) particles.stress.xy[p] = 1e3;
    const SoilColumn uneven = *find_soil_column(body, state).column;
    EXPECT_EQ(uneven.row_length, 1);
    EXPECT_EQ(uneven.state.particles.size(), 12u);
    State wide;
    widen(uneven, uneven.state, wide);
    EXPECT_EQ(wide.particles.stress.xy, particles.stress.xy);
}

TEST(SoilColumn, KeepsBodiesWhoseColumnsDiffer)
{
    const Problem body = tied_ground();
    State state = level_state(body);
    state.particles.stress.xy[17] += 1.0;
    EXPECT_EQ(column_obstacle(body, state), soil_differs);
    state = level_state(body);
    state.particles.material[17] = 1;
    EXPECT_EQ(column_obstacle(body, state), soil_differs);
    state = level_state(body);
    state.particles.position.x[17] += 0.01;
    EXPECT_EQ(column_obstacle(body, state), soil_differs);
    State hollow = fill(body, 2, [](const Vector2& x) {
        return x.x() > 0.0 && x.x() < 5.0 && x.y() < (x.x() > 3.0 ? 2.0 : 3.0);
    });
    EXPECT_EQ(column_obstacle(body, hollow), soil_differs);
}

TEST(SoilColumn, KeepsBodiesOnWhichUnevenThingsAct)
{
    const Problem body = tied_ground();
    const State state = level_state(body);
    Problem other = body;
    other.body_acceleration = [](const Vector2&, double) { return Vector2(0.0, 0.0); };
    EXPECT_EQ(column_obstacle(other, state), "the body force varies from place to place");
    other = body;
    other.boundaries[0].segments[0].end.x() = 3.0;
    EXPECT_EQ(column_obstacle(other, state), "the curve \"base\" is no level line from side to side");
    other = body;
    other.boundaries[2].segments[0].end.y() = 2.5;
    EXPECT_EQ(column_obstacle(other, state), "the curve \"top\" is no level line from side to side");
    other = body;
    other.boundaries[2].soil = MovingWall{};
    EXPECT_EQ(column_obstacle(other, state), "the curve \"top\" moves");
    other = body;
    other.boundaries[2].soil = FreeFace{SurfaceLoad{}};
    State loaded = state;
    attach_boundaries(other, loaded.particles);
    EXPECT_TRUE(find_soil_column(other, loaded).column.has_value());
    other.boundaries[2].pieces.pop_back();
    EXPECT_EQ(column_obstacle(other, loaded), "what acts on the curve \"top\" differs from cell to cell");
    other = body;
    other.tied_sides.reset();
    EXPECT_EQ(column_obstacle(other, state), ""); // and nobody asks
}

TEST(SoilColumn, LetsSoilInByTheOtherSide)
{
    const Problem body = tied_ground();
    SoilColumn column = *find_soil_column(body, level_state(body)).column;
    Particles& particles = column.state.particles;
    const Particles drawn = particles;
    for (const double drift : {2.625, -3.5}) {
        particles = drawn;
        for (double& x : particles.position.x) x += drift;
        wrap_particles(column.problem, particles);
        State wide;
        widen(column, column.state, wide);
        for (std::size_t p = 0; p < particles.size(); ++p) {
            EXPECT_GE(particles.position.x[p], 0.25); // two of a row stand half a cell apart
            EXPECT_LT(particles.position.x[p], 0.75);
            EXPECT_EQ(particles.position.x[p] - particles.reference_position.x[p], drift);
        }
        const State body_state = level_state(body);
        for (std::size_t p = 0; p < wide.particles.size(); ++p) {
            EXPECT_NEAR(wide.particles.position.x[p], body_state.particles.position.x[p] + drift, 1e-12);
            EXPECT_NEAR(wide.particles.reference_position.x[p], body_state.particles.position.x[p], 1e-12);
        }
    }
}

namespace {

/// Remembers what it is shown.
class ColumnWitness : public Observer {
public:
    double next_time() const override { return next; }
    void observe(const Problem& problem, const State& state, const StepReport& report) override
    {
        cells_x = problem.grid.cells_x;
        particles = state.particles.size();
        limited_domains = report.limited_domains;
        next = std::numeric_limits<double>::infinity();
    }
    void after_step(const StepReport&) override { ++steps; }
    void finish() override { ++finished; }

    double next = 0.0;
    int cells_x = 0, steps = 0, finished = 0;
    std::size_t particles = 0;
    std::int64_t limited_domains = 0;
};

} // namespace

TEST(SoilColumn, ObserversAreShownTheWholeBody)
{
    const Problem body = tied_ground();
    SoilColumn column = *find_soil_column(body, level_state(body)).column;
    ColumnWitness due, later;
    later.next = 1.0;
    ColumnObserver observer(column, body, {&later, &due});
    EXPECT_EQ(observer.next_time(), 0.0);
    StepReport report;
    report.limited_domains = 2;
    observer.observe(column.problem, column.state, report);
    observer.after_step(report);
    observer.finish();
    EXPECT_EQ(due.cells_x, 9);
    EXPECT_EQ(due.particles, 60u);
    EXPECT_EQ(due.limited_domains, 20);
    EXPECT_EQ(later.particles, 0u);
    EXPECT_EQ(later.steps, 1);
    EXPECT_EQ(later.finished, 1);
    EXPECT_EQ(observer.next_time(), 1.0);
}

} // namespace quicksand
