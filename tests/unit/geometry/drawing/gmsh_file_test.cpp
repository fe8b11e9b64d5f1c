#include "geometry/drawing/gmsh_file.hpp"
#include "geometry/sampling/particle_sampler.hpp"
#include "geometry/section/region_locator.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <cmath>
#include <numbers>

namespace quicksand {
namespace {

const std::string rectangle_with_parameters = R"(
DefineConstant[ width = {2, Name "Parameters/Width"}, height = 1 ];
If (!Exists(depth)) depth = 0; EndIf
Point(1) = {0, -depth, 0}; Point(2) = {width, -depth, 0}; Point(3) = {width, height, 0}; Point(4) = {0, height, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {4, 3}; Line(4) = {4, 1};
Curve Loop(7) = {1, 2, -3, 4}; Plane Surface(9) = {7};
Physical Surface("sand") = {9}; Physical Curve("top") = {3}; Physical Curve("sides") = {2, -4};
Physical Point("corner") = {3};
)";

TEST(GmshFile, ReadsRegionsCurvesAndPointsByName)
{
    const Section section = read_geo(rectangle_with_parameters);
    ASSERT_EQ(section.regions.size(), 1u);
    EXPECT_EQ(section.regions[0].name, "sand");
    EXPECT_DOUBLE_EQ(area(section.regions[0]), 2.0);
    ASSERT_EQ(section.curves.size(), 2u);
    EXPECT_EQ(section.curves[0].name, "top");
    EXPECT_EQ(section.curves[1].segments.size(), 2u);
    ASSERT_EQ(section.points.size(), 1u);
    EXPECT_EQ(section.points[0].position, Vector2(2.0, 1.0));
    EXPECT_EQ(section.upper, Vector2(2.0, 1.0));
}

TEST(GmshFile, TellsWhichSurfacesNoRegionHas)
{
    EXPECT_TRUE(read_geo(rectangle_with_parameters).nameless.empty());
    const Section section = read_geo(rectangle_with_parameters + R"(
Point(5) = {4, 0, 0}; Point(6) = {4, 1, 0};
Line(5) = {2, 5}; Line(6) = {5, 6}; Line(7) = {6, 3}; Curve Loop(8) = {5, 6, 7, -2}; Plane Surface(10) = {8};
)");
    ASSERT_EQ(section.regions.size(), 1u);
    ASSERT_EQ(section.nameless.size(), 1u);
    EXPECT_LT((section.nameless[0].lower - Vector2(2.0, 0.0)).norm(), 1e-6);
    EXPECT_LT((section.nameless[0].upper - Vector2(4.0, 1.0)).norm(), 1e-6);
}

TEST(GmshFile, TurnsRimSegmentsSoThatTheSoilIsOnTheLeft)
{
    const Section section = read_geo(rectangle_with_parameters);
    for (const NamedCurve& curve : section.curves) {
        for (const Segment& segment : curve.segments) {
            const Vector2 along = segment.end - segment.start;
            const Vector2 left = 0.5 * (segment.start + segment.end) + 0.1 * Vector2(-along.y(), along.x());
            EXPECT_TRUE(contains(section.regions[0].polygons[0], left)) << curve.name;
        }
    }
}

TEST(GmshFile, ReplacesParametersOfEveryFormOfDeclaration)
{
    GmshRequest request;
    request.parameters = {{"width", 3.0}, {"height", 0.1}, {"depth", 0.25}};
    const Section section = read_geo(rectangle_with_parameters, request);
    EXPECT_EQ(section.lower, Vector2(0.0, -0.25));
    EXPECT_EQ(section.upper, Vector2(3.0, 0.1));
}

struct AreaCase {
    const char* name;
    const char* text;
    double area;
    std::size_t outer_vertices, holes;
};

class ExactAreas : public testing::TestWithParam<AreaCase> {};

TEST_P(ExactAreas, OfStraightOutlines)
{
    const Section section = read_geo(GetParam().text);
    ASSERT_EQ(section.regions.size(), 1u);
    const Region& region = section.regions[0];
    EXPECT_NEAR(area(region), GetParam().area, 1e-13 * GetParam().area);
    EXPECT_EQ(region.polygons[0].outer.size(), GetParam().outer_vertices);
    EXPECT_EQ(region.polygons[0].holes.size(), GetParam().holes);
}

INSTANTIATE_TEST_SUITE_P(Kernels, ExactAreas,
                         testing::Values(AreaCase{"clockwise_with_hole", R"(
Point(1) = {0,0,0}; Point(2) = {0,2,0}; Point(3) = {4,2,0}; Point(4) = {4,0,0};
Point(5) = {1,1,0}; Point(6) = {1.5,1,0}; Point(7) = {1.5,1.5,0};
Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1}; Line(5) = {5,6}; Line(6) = {6,7}; Line(7) = {7,5};
Curve Loop(1) = {1,2,3,4}; Curve Loop(2) = {5,6,7}; Plane Surface(1) = {1,2};
Physical Surface("sand") = {1};)",
                                                  8.0 - 0.125, 4, 1},
                                         AreaCase{"occ_difference", R"(
SetFactory("OpenCASCADE");
Rectangle(1) = {0,0,0, 4,2}; Rectangle(2) = {1,1,0, 1,0.5};
BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };
Physical Surface("sand") = {3};)",
                                                  7.5, 4, 1},
                                         AreaCase{"two_surfaces_one_region", R"(
SetFactory("OpenCASCADE");
Rectangle(1) = {0,0,0, 1,1}; Rectangle(2) = {1,0,0, 1,2};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }
Physical Surface("sand") = {1,2};)",
                                                  3.0, 4, 0}),
                         [](const auto& named) { return named.param.name; });

TEST(GmshFile, NeighboursShareTheVerticesOfACurvedInterface)
{
    const Section section = read_geo(R"(
Point(1) = {0,0,0}; Point(2) = {4,0,0}; Point(3) = {4,1,0}; Point(4) = {0,1,0}; Point(5) = {1,1.4,0}; Point(6) = {3,0.7,0};
Point(7) = {4,3,0}; Point(8) = {0,3,0};
Line(1) = {1,2}; Line(2) = {2,3}; Spline(3) = {3,6,5,4}; Line(4) = {4,1}; Line(5) = {3,7}; Line(6) = {7,8}; Line(7) = {8,4};
Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1}; Curve Loop(2) = {-3,5,6,7}; Plane Surface(2) = {2};
Physical Surface("lower") = {1}; Physical Surface("upper") = {2}; Physical Curve("interface") = {3};)");
    EXPECT_NEAR(area(section.regions.at(0)) + area(section.regions.at(1)), 12.0, 1e-12);
    EXPECT_GT(section.curves[0].segments.size(), 8u);
}

class CurvedOutlines : public testing::TestWithParam<const char*> {};

TEST_P(CurvedOutlines, ConvergeToTheDiscWithTheTolerance)
{
    double last_error = 1.0;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        GmshRequest request;
        request.curve_tolerance = tolerance;
        const double error = std::abs(area(read_geo(GetParam(), request).regions[0]) - std::numbers::pi);
        EXPECT_LT(error, 2.0 * std::numbers::pi * tolerance);
        EXPECT_LT(error, last_error);
        last_error = error;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, CurvedOutlines,
                         testing::Values(R"(
SetFactory("OpenCASCADE"); Disk(1) = {0, 0, 0, 1}; Physical Surface("disc") = {1};)",
                                         R"(
Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {0,1,0}; Point(4) = {-1,0,0}; Point(5) = {0,-1,0};
Circle(1) = {2,1,3}; Circle(2) = {3,1,4}; Circle(3) = {4,1,5}; Circle(4) = {5,1,2};
Curve Loop(1) = {1,2,3,4}; Plane Surface(1) = {1}; Physical Surface("disc") = {1};)"));

class MeshFiles : public testing::TestWithParam<const char*> {};

TEST_P(MeshFiles, GiveTheSameSectionInEveryFormat)
{
    GmshRequest request;
    request.file = fixture(GetParam());
    request.quad_size = 1.0;
    const Section section = read_gmsh_file(request);
    ASSERT_EQ(section.regions.size(), 2u);
    EXPECT_EQ(section.regions[0].name, "foundation");
    EXPECT_EQ(section.regions[1].name, "dike");
    EXPECT_NEAR(area(section.regions[0]), 4.0, 1e-14);
    EXPECT_NEAR(area(section.regions[1]), 4.0, 1e-14);
    ASSERT_EQ(section.curves.size(), 2u);
    EXPECT_EQ(section.curves[1].name, "slope");
    double length = 0.0;
    for (const Segment& segment : section.curves[1].segments) {
        EXPECT_GT(segment.start.x(), segment.end.x()); // the dike on the left, going down
        length += (segment.end - segment.start).norm();
    }
    EXPECT_NEAR(length, std::sqrt(5.0), 1e-14);
    EXPECT_EQ(section.points.at(0).position, Vector2(2.0, 2.0));
    EXPECT_EQ(section.quads.size(), 16u);
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFiles,
                         testing::Values("slope.geo", "slope_22.msh", "slope_41.msh", "slope_41_binary.msh"));

/// A mesh with the group "sand"; nodes and elements with their counts before them.
std::string mesh_of_sand(const std::string& nodes, const std::string& elements)
{
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 "
           "\"sand\"\n$EndPhysicalNames\n$Nodes\n" +
           nodes + "$EndNodes\n$Elements\n" + elements + "$EndElements\n";
}

TEST(GmshFile, SplitsTrianglesOfAMeshFileInThree)
{
    const ScratchFolder folder;
    GmshRequest request;
    request.file = folder.write("triangles.msh", mesh_of_sand(R"(4
1 0 0 0
2 2 0 0
3 2 1 0
4 0 1 0
)",
                                                              R"(2
1 2 2 1 1 1 2 3
2 2 2 1 1 1 4 3
)"));
    request.quad_size = 1.0;
    const Section section = read_gmsh_file(request);
    EXPECT_EQ(section.quads.size(), 6u);
    EXPECT_EQ(section.regions[0].polygons[0].outer.size(), 4u);
    double sum = 0.0;
    for (const ParticleDomain& domain : sample_mesh(section, make_grid(0, 0, 1, 2, 1)).domains)
        sum += domain.volume;
    EXPECT_NEAR(sum, 2.0, 1e-14);
}

// Elements of the physical number 0 belong to no group.
TEST(GmshFile, TellsWhichSurfacesOfAMeshNoRegionHas)
{
    const ScratchFolder folder;
    GmshRequest request;
    request.file = folder.write("nameless.msh", mesh_of_sand(R"(6
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 3 0 0
6 3 1 0
)",
                                                             R"(2
1 3 2 1 1 1 2 3 4
2 3 2 0 2 2 5 6 3
)"));
    const Section section = read_gmsh_file(request);
    ASSERT_EQ(section.regions.size(), 1u);
    ASSERT_EQ(section.nameless.size(), 1u);
    EXPECT_LT((section.nameless[0].lower - Vector2(1.0, 0.0)).norm(), 1e-6);
    EXPECT_LT((section.nameless[0].upper - Vector2(3.0, 1.0)).norm(), 1e-6);
}

TEST(GmshFile, SeparatesPartsOfAMeshThatTouchInOneNode)
{
    const ScratchFolder folder;
    GmshRequest request;
    request.file = folder.write("touching.msh", mesh_of_sand(R"(7
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 2 1 0
6 2 2 0
7 1 2 0
)",
                                                             R"(2
1 3 2 1 1 1 2 3 4
2 3 2 1 1 3 5 6 7
)"));
    const Section section = read_gmsh_file(request);
    ASSERT_EQ(section.regions[0].polygons.size(), 2u);
    EXPECT_DOUBLE_EQ(area(section.regions[0]), 2.0);
}

} // namespace
} // namespace quicksand
