// Names that refer to nothing, sides that are not tied to each other, files that are not there.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneReferences : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneReferences, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    folder.write("uneven.csv", "time,a\n0,0\n0.01,1\n0.03,0\n");
    const std::string text = fixtures::replaced(fixtures::column_scene, mistake.sound, mistake.mistaken);
    EXPECT_EQ(folder.message(text), mistake.message.substr(1)); // after the line break that opens it
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneReferences, testing::Values(
SceneMistake{"UnknownMaterial",
    "material = \"sand\"",
    "material = \"snad\"",
R"_(
scene.toml:28:12: error[unknown-material]: there is no material "snad"
   28 | material = "snad"
      |            ^~~~~~
expected: sand
hint: did you mean "sand"?
)_"},
SceneMistake{"UnusedMaterial",
    "[regions.sand]",
    "[materials.clay]\nmodel = \"linear_elastic\"\nshear_modulus = \"10 MPa\"\nporosity = 0.5\npoisson_ratio = 0.3\nhydraulic_conductivity = 1e-8\n\n[regions.sand]",
R"_(
scene.toml:27:1: warning[unused]: no region has the material "clay"
   27 | [materials.clay]
      | ^~~~~~~~~~~~~~~~
to accept it: accept = ["materials.clay"] at the top of the scene
)_"},
SceneMistake{"SolidOfSand",
    "model = \"linear_elastic\"\nshear_modulus = \"60 MPa\"\npoisson_ratio = 0.3\ngrain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n",
    "model = \"ubcsand\"\nn1_60 = 10\nwater = \"none\"\ndensity = 2400\n",
R"_(
scene.toml:22:9: error[combination]: materials.sand.water = "none" makes a solid without pores, and model = "ubcsand" is no law of solids
   22 | water = "none"
      |         ^~~~~~
expected: model = "linear_elastic" or "mohr_coulomb" with water = "none"
hint: remove water, or take the law of the solid
)_"},
SceneMistake{"SolidWithPores",
    "grain_density = 2670\nporosity = 0.405\nhydraulic_conductivity = 5.8e-5\n",
    "water = \"none\"\nporosity = 0.405\n",
R"_(
scene.toml:19:1: error[missing-key]: [materials.sand] has no density
   19 | [materials.sand]
      | ^~~~~~~~~~~~~~~~
expected: density [kg/m3]: Density of the solid, in the air: 2400 of concrete; buoyancy is added below the water.
scene.toml:24:1: error[unused-key]: materials.sand.porosity is not used with water = "none"
   24 | porosity = 0.405
      | ^~~~~~~~
hint: remove it, or set water = "pores"
)_"},
SceneMistake{"TiedToUnknown",
    "tied_to = \"right\"",
    "tied_to = \"rihgt\"",
R"_(
scene.toml:35:11: error[tied]: there is no boundary "rihgt"
   35 | tied_to = "rihgt"
      |           ^~~~~~~
expected: one of base, left, right, surface
hint: did you mean "right"?
)_"},
SceneMistake{"TiedToNothing",
    "tied_to = \"right\"\n",
    "",
R"_(
scene.toml:33:1: error[missing-key]: [boundaries.left] has no tied_to
   33 | [boundaries.left]
      | ^~~~~~~~~~~~~~~~~
expected: tied_to: The opposite curve, whose points of equal height move together with this one's.
)_"},
SceneMistake{"NotTiedBack",
    "soil = \"tied\"\ntied_to = \"left\"",
    "soil = \"free\"",
R"_(
scene.toml:35:11: error[tied]: "right" is free, not tied
   35 | tied_to = "right"
      |           ^~~~~~~
expected: two curves tied to each other
hint: write soil = "tied" and tied_to = "left" in [boundaries.right]
)_"},
SceneMistake{"TiedToItself",
    "tied_to = \"right\"",
    "tied_to = \"left\"",
R"_(
scene.toml:35:11: error[tied]: "left" is tied to itself
   35 | tied_to = "left"
      |           ^~~~~~
hint: name the opposite curve
)_"},
SceneMistake{"ThreeTiedCurves",
    "soil = \"free\"",
    "soil = \"tied\"\ntied_to = \"left\"",
R"_(
scene.toml:41:1: error[tied]: a scene has at most one pair of tied curves
   41 | [boundaries.surface]
      | ^~~~~~~~~~~~~~~~~~~~
expected: two boundaries with soil = "tied"
scene.toml:43:11: error[tied]: "left" is tied to "right", not to "surface"
   43 | tied_to = "left"
      |           ^~~~~~
expected: two curves tied to each other
hint: write soil = "tied" and tied_to = "surface" in [boundaries.left]
)_"},
SceneMistake{"MissingDrawing",
    "file = \"column.geo\"",
    "file = \"colunm.geo\"",
R"_(
scene.toml:5:8: error[file]: there is no file 'colunm.geo'
    5 | file = "colunm.geo"
      |        ^~~~~~~~~~~~
expected: a drawing; its path is relative to the scene file
hint: did you mean column.geo?
)_"},
SceneMistake{"FolderInsteadOfDrawing",
    "file = \"column.geo\"",
    "file = \".\"",
R"_(
scene.toml:5:8: error[file]: '.' is a folder
    5 | file = "."
      |        ^~~
expected: a drawing
hint: name the file in it
)_"},
SceneMistake{"FileThatIsNoDrawing",
    "file = \"column.geo\"",
    "file = \"scene.toml\"",
R"_(
scene.toml:5:8: error[file]: 'scene.toml' is not a drawing that can be read
    5 | file = "scene.toml"
      |        ^~~~~~~~~~~~
expected: a file .geo, .geo_unrolled or .msh
)_"},
SceneMistake{"RecordMissing",
    "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
    "kind = \"file\"\nfile = \"record.csv\"\nunit = \"g\"",
R"_(
scene.toml:46:8: error[file]: 'record.csv' does not exist
   46 | file = "record.csv"
      |        ^~~~~~~~~~~~
hint: the path is relative to the file that names it
)_"},
SceneMistake{"BoxesOnAMesh",
    "particles_per_cell = [3, 3]",
    "kind = \"mesh\"\n[analysis]\ninterpolation = \"cpgimp\"",
R"_(
scene.toml:13:17: error[combination]: interpolation = "cpgimp" gives every point a box along the axes, and boxes cannot tile a mesh
   13 | interpolation = "cpgimp"
      |                 ^~~~~~~~
expected: interpolation = "cpdi2", "cpdi" or "linear" with sampling.kind = "mesh"
hint: cpdi2 keeps the quadrilaterals as they are; or sample a lattice
)_"},
SceneMistake{"RecordUnevenlySpaced",
    "kind = \"sine\"\namplitude = \"24 g\"\nfrequency = 180",
    "kind = \"file\"\nfile = \"uneven.csv\"\nunit = \"m/s2\"",
R"_(
scene.toml:46:8: error[motion]: 'uneven.csv': its time steps are between 0.01 s (line 3) and 0.02 s (line 4)
   46 | file = "uneven.csv"
      |        ^~~~~~~~~~~~
expected: a record in PEER's AT2 form, or rows `time_s, acceleration` at equal intervals with at most one header line
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
