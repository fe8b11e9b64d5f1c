// Figures that a scene asks for and its run could not give.
#include "tests/fixtures/scene_mistake.hpp"

namespace quicksand {
namespace {

using fixtures::SceneMistake;

class SceneFigures : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneFigures, AreReportedWithPlaceAndCure)
{
    const SceneMistake& mistake = GetParam();
    const fixtures::SceneFolder folder;
    EXPECT_EQ(folder.message(fixtures::column_scene + mistake.mistaken), mistake.message.substr(1));
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Mistakes, SceneFigures, testing::Values(
SceneMistake{"UnknownProbe", "",
    "[figures.a]\nprobes = [\"crset\"]\nquantity = \"settlement\"\n",
R"_(
scene.toml:56:10: error[figure]: there is no probe "crset" that has a history
   56 | probes = ["crset"]
      |          ^~~~~~~~~
expected: crest
hint: did you mean "crest"?
)_"},
SceneMistake{"NoProfile", "",
    "[figures.a]\nkind = \"isochrones\"\nprobes = [\"crest\"]\nquantity = \"ru\"\n[probes.line]\nkind = \"profile\"\nat = [0.03, 0]\nto = [0.03, 0.3]\n",
R"_(
scene.toml:57:10: error[figure]: there is no probe "crest" that is a profile
   57 | probes = ["crest"]
      |          ^~~~~~~~~
expected: line
)_"},
SceneMistake{"NoProbeAtAll", "",
    "[figures.a]\nprobes = []\nquantity = \"ru\"\n",
R"_(
scene.toml:56:10: error[figure]: the figure is of 0 probes
   56 | probes = []
      |          ^~
expected: one probe or more
)_"},
SceneMistake{"TwoProfiles", "",
    "[probes.a]\nkind = \"profile\"\nat = [0.03, 0]\nto = [0.03, 0.3]\n[probes.b]\nkind = \"profile\"\nat = [0.03, 0]\nto = [0.03, 0.3]\n[figures.a]\nkind = \"isochrones\"\nprobes = [\"a\", \"b\"]\nquantity = \"ru\"\n",
R"_(
scene.toml:65:10: error[figure]: the figure is of 2 probes
   65 | probes = ["a", "b"]
      |          ^~~~~~~~~~
expected: one profile
)_"},
SceneMistake{"UnknownField", "",
    "[figures.a]\nkind = \"field\"\nfield = \"displacment\"\n",
R"_(
scene.toml:57:9: error[figure]: no results have a field "displacment"
   57 | field = "displacment"
      |         ^~~~~~~~~~~~~
expected: one of velocity, velocity_x, velocity_y, material, region, displacement, displacement_x, displacement_y, total_displacement, total_displacement_x, total_displacement_y, velocity_solid, velocity_solid_x, velocity_solid_y, velocity_fluid, velocity_fluid_x, velocity_fluid_y, pore_pressure, excess_pore_pressure, ru, mean_effective_stress, vertical_effective_stress, deviatoric_stress, stress_xx, stress_yy, stress_zz, stress_xy, shear_strain, volumetric_strain, porosity, eta_max, branch, half_cycles, dilation, largest_shear, liquefied_shear, compaction, alpha_x, alpha_y, alpha_in_x, alpha_in_y, fabric_x, fabric_y, fabric_path, fabric_peak, peak_stress, void_ratio
hint: did you mean "displacement"?
)_"},
SceneMistake{"RangeUpsideDown", "",
    "[figures.a]\nkind = \"field\"\nfield = \"displacement\"\nrange = [1.0, 0.0]\n",
R"_(
scene.toml:58:9: error[figure]: this is no range of colours
   58 | range = [1.0, 0.0]
      |         ^~~~~~~~~~
expected: [low, high] in the SI unit of the field
)_"},
SceneMistake{"NameOfNoFile", "",
    "[figures.\"a/b\"]\nprobes = [\"crest\"]\nquantity = \"settlement\"\n",
R"_(
scene.toml:55:1: error[name]: the figure's name cannot be that of a file
   55 | [figures."a/b"]
      | ^~~~~~~~~~~~~~~
expected: none of / \ : * ? " < > |, no leading dot
)_"}), fixtures::name_of);
// clang-format on

} // namespace
} // namespace quicksand
