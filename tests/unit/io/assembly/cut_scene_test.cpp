// Scenes whose outline cuts particles, from the drawing to what acts on the nodes.
#include "io/assembly/probe_places.hpp"
#include "io/frames/particle_frame.hpp"
#include "io/frames/vtk_frame.hpp"
#include "io/results/result_reader.hpp"
#include "solver/boundaries/boundary_pieces.hpp"
#include "solver/boundaries/surface_loads.hpp"
#include "solver/measure/nodal_fields.hpp"
#include "solver/motion/particle_to_grid.hpp"
#include "solver/particles/cell_lists.hpp"
#include "tests/fixtures/cut_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace quicksand {
namespace {

using fixtures::assemble_cut_dike;

/// sum_p V_p grad phi_ip at all nodes [m].
std::vector<Vector2> nodal_normals(const Problem& problem, const Particles& particles)
{
    std::vector<Vector2> normals(problem.grid.node_count(), Vector2::Zero());
    CellLists lists = make_cell_lists(problem.grid);
    update_cell_lists(problem.grid, particles, lists);
    for (const Tile& tile : lists.tiles) {
        StencilStore store;
        evaluate_weights(problem, particles, lists, tile, store);
        for (std::size_t k = lists.first_entry(tile); k < lists.last_entry(tile); ++k) {
            const double V = particles.volume[static_cast<std::size_t>(lists.order[k])];
            for_each_node(store.stencils[k - lists.first_entry(tile)], store, problem.grid.nodes_x(),
                          [&](std::size_t i, const NodeWeight& w) {
                              normals[i] += V * Vector2(w.gradient_x, w.gradient_y);
                          });
        }
    }
    return normals;
}

/// The forces of all loads on the nodes [N/m].
std::vector<Vector2> nodal_loads(const Problem& problem, const Particles& particles)
{
    std::vector<NodalForce> loads;
    ParticlePlaces places;
    add_surface_loads(problem, 0.0, particles, places, loads);
    std::vector<Vector2> forces(problem.grid.node_count(), Vector2::Zero());
    for (const NodalForce& load : loads) forces[load.node] += load.grains;
    return forces;
}

} // namespace

TEST(CutScene, EqualPressuresInsideAndOutsideBalanceAtEveryNode)
{
    for (const StrainForm strain : {StrainForm::large, StrainForm::small}) {
        AssembledCase dike = assemble_cut_dike();
        Problem& problem = dike.problem;
        problem.strain = strain;
        EXPECT_GT(problem.cut_domains.shapes.size(), 10u);
        constexpr double pressure = 1000.0; // [Pa]
        for (Boundary& boundary : problem.boundaries)
            boundary.soil = FreeFace{SurfaceLoad{Vector2::Zero(), pressure, {}}};
        EXPECT_TRUE(attach_boundaries(problem, dike.state.particles).empty());
        const std::vector<Vector2> normals = nodal_normals(problem, dike.state.particles),
                                   loads = nodal_loads(problem, dike.state.particles);
        double largest = 0.0;
        for (std::size_t i = 0; i < loads.size(); ++i) {
            largest = std::max(largest, loads[i].norm());
            EXPECT_LT((loads[i] + pressure * normals[i]).norm(), 1e-8) << i;
        }
        EXPECT_GT(largest, 100.0);
    }
}

TEST(CutScene, AConstantStressIsInEquilibriumAcrossABentInterface)
{
    const Vector2 bends[] = {{2, 0.55}, {1.13, 0.31}, {0.47, 0.62}, {0, 0.41}};
    Section section = fixtures::rectangular_section(0.0, 0.0, 2.0, 1.0);
    section.regions = {{"sand", {{{{0, 0}, {2, 0}, bends[0], bends[1], bends[2], bends[3]}, {}}}},
                       {"clay", {{{bends[3], bends[2], bends[1], bends[0], {2, 1}, {0, 1}}, {}}}}};
    section.curves = {section.curves[0]};
    const std::string text = fixtures::replaced(
        fixtures::replaced(fixtures::cut_dike_scene, "[boundaries.slope]\nsoil = \"free\"\n", ""),
        "[regions.sand]", "[regions.clay]\nmaterial = \"sand\"\n[regions.sand]");
    const AssembledCase layers = assemble_case(fixtures::SceneFolder().read(text), section);
    const BackgroundGrid& grid = layers.problem.grid;
    EXPECT_GT(layers.problem.cut_domains.shapes.size(), 40u);
    const std::vector<Vector2> normals = nodal_normals(layers.problem, layers.state.particles);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vector2 place = grid.node_position(i);
        const bool inside = place.x() > 0.1 && place.x() < 1.9 && place.y() > 0.1 && place.y() < 0.9;
        if (inside) {
            EXPECT_LT(normals[i].norm(), 1e-14) << place.transpose();
        }
    }
}

TEST(CutScene, ATractionGoesToTheCornersOfTheEdgesThatItActsOn)
{
    AssembledCase dike = assemble_cut_dike();
    Problem& problem = dike.problem;
    const Particles& particles = dike.state.particles;
    const auto slope = std::find_if(problem.boundaries.begin(), problem.boundaries.end(),
                                    [](const Boundary& boundary) { return boundary.name == "slope"; });
    const Vector2 traction(30.0, -70.0);
    slope->soil = FreeFace{SurfaceLoad{traction, 0.0, {}}};
    attach_boundaries(problem, particles);

    // every edge of a polygon on the slope is one piece from corner to corner
    double length = 0.0;
    std::map<std::int32_t, int> pieces_of;
    for (const BoundaryPiece& piece : slope->pieces) {
        const auto p = static_cast<std::size_t>(piece.identifier);
        length += piece.length;
        ++pieces_of[piece.identifier];
        if (problem.cut_domains.find(piece.identifier) == nullptr) continue;
        const std::vector<Vector2> corners = domain_polygon(problem.cut_domains, particles, p);
        const auto c = static_cast<std::size_t>(piece.edge);
        const PresentPiece present = present_piece(problem, particles, piece, p);
        EXPECT_LT((present.start - corners[c]).norm(), 1e-12);
        EXPECT_LT((present.end - corners[(c + 1) % corners.size()]).norm(), 1e-12);
        EXPECT_NEAR(present.fractions[0], 0.5, 1e-9);
        EXPECT_NEAR(present.fractions[1], 0.5, 1e-9);
    }
    EXPECT_NEAR(length, std::hypot(0.87, 0.4), 1e-12);
    EXPECT_TRUE(
        std::all_of(pieces_of.begin(), pieces_of.end(), [](const auto& one) { return one.second == 1; }));

    Vector2 sum = Vector2::Zero();
    double moment = 0.0, expected = 0.0;
    const std::vector<Vector2> loads = nodal_loads(problem, particles);
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const Vector2 place = problem.grid.node_position(i);
        sum += loads[i];
        moment += place.x() * loads[i].y() - place.y() * loads[i].x();
    }
    const Segment& drawn = slope->segments.front();
    const Vector2 middle = 0.5 * (drawn.start + drawn.end);
    expected = length * (middle.x() * traction.y() - middle.y() * traction.x());
    EXPECT_LT((sum - length * traction).norm(), 1e-11);
    EXPECT_NEAR(moment, expected, 1e-11);
}

TEST(CutScene, FramesHoldThePolygonsAndReadThemBack)
{
    const AssembledCase dike = assemble_cut_dike();
    const fixtures::TemporaryFolder folder;
    write_frame(folder / "a.vtu", particle_frame(dike.problem, dike.state));
    const ParticleFrame read = read_particle_frame(folder / "a.vtu");
    const Particles& particles = dike.state.particles;
    ASSERT_EQ(read.domains.size(), particles.size());
    double area = 0.0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        EXPECT_EQ(read.domains[p], domain_polygon(dike.problem.cut_domains, particles, p));
        area += quicksand::area(Region{"", {{read.domains[p], {}}}});
    }
    EXPECT_NEAR(area, quicksand::area(dike.section.regions[0]), 1e-12);
    for (const auto& [name, values] : read.scalars) EXPECT_EQ(values.size(), particles.size()) << name;
}

TEST(CutScene, SurfacesLieOnTheSlopeAsDrawn)
{
    const AssembledCase dike = assemble_cut_dike();
    for (int k = 0; k <= 100; ++k) {
        const double x = 0.6 + 0.87 * k / 100;
        const SurfacePoint surface = surface_point(dike.problem, dike.state.particles, x);
        ASSERT_TRUE(surface.found);
        EXPECT_NEAR(surface.height, 0.75 - 0.4 / 0.87 * (x - 0.6), 1e-8) << x;
    }
    EXPECT_NEAR(surface_point(dike.problem, dike.state.particles, 0.3).height, 0.75, 1e-12);
}

TEST(CutScene, NodalAveragesTakeTheVolumesOfThePolygons)
{
    const AssembledCase dike = assemble_cut_dike();
    const Scalars volume = nodal_fields(dike.problem, dike.state.particles).volume;
    const double drawn = quicksand::area(dike.section.regions[0]);
    EXPECT_NEAR(std::accumulate(volume.begin(), volume.end(), 0.0), drawn, 1e-12);
    for (std::size_t i = 0; i < volume.size(); ++i) {
        // nodes farther than a cell from the outline, above it and to the right
        const Vector2 place = dike.problem.grid.node_position(i);
        if (place.y() > 0.96 || place.x() > 2.21) {
            EXPECT_EQ(volume[i], 0.0);
        }
    }
}

TEST(CutScene, NodalAveragesLeaveOutAPolygonThatIsNoNumber)
{
    AssembledCase dike = assemble_cut_dike();
    Particles& particles = dike.state.particles;
    std::size_t cut = 0;
    while (dike.problem.cut_domains.find(particles.identifier[cut]) == nullptr) ++cut;
    particles.half_edge_2.y[cut] = std::nan("");
    const Scalars volume = nodal_fields(dike.problem, particles).volume;
    const double drawn = quicksand::area(dike.section.regions[0]) - particles.volume[cut];
    EXPECT_NEAR(std::accumulate(volume.begin(), volume.end(), 0.0), drawn, 1e-12);
}

} // namespace quicksand
