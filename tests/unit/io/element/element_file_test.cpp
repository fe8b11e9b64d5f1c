#include "io/element/element_keys.hpp"
#include "io/laws/soil_laws.hpp"
#include "tests/fixtures/element_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace quicksand {
namespace {

using fixtures::ElementFolder;
using fixtures::sound_tests;

const UbcSand& sand_of(const ElementSpecimen& specimen)
{
    return std::get<UbcSand>(specimen.soil.law);
}

ElementTest first_test(const std::string& keys)
{
    const ElementFolder folder;
    folder.write("points.csv", "# mine\nCSR,N,n1_60\n0.12,15,10\n 0.2 , 15 , 20 \n");
    return folder
        .read("test_version = 1\n[materials.sand]\nmodel = \"ubcsand\"\nn1_60 = 13.9\n[tests.a]\n" + keys)
        .programme.tests.at(0);
}

TEST(ElementFile, NamesEveryKeyOnceBelowATable)
{
    std::set<std::string_view> seen;
    for (const SceneKey& key : element_key_table().keys) {
        EXPECT_TRUE(seen.insert(key.pattern).second) << key.pattern;
        const std::string_view table = table_part(key.pattern);
        EXPECT_TRUE(table.empty() || seen.contains(table)) << key.pattern;
        EXPECT_TRUE(key.doc.ends_with('.')) << key.pattern;
        if (!key.default_value || !std::holds_alternative<double>(*key.default_value)) continue;
        EXPECT_TRUE(key.allowed.contains(std::get<double>(*key.default_value))) << key.pattern;
        EXPECT_TRUE(key.plausible.contains(std::get<double>(*key.default_value))) << key.pattern;
    }
}

TEST(ElementFile, ReadsStressCycles)
{
    const ElementFolder folder;
    const ElementReading reading = folder.read(sound_tests);
    EXPECT_EQ(reading.programme.title, "sand");
    ASSERT_EQ(reading.programme.tests.size(), 1u);
    const ElementTest& test = reading.programme.tests[0];
    EXPECT_EQ(test.name, "strength");
    EXPECT_EQ(test.material, "sand");
    ASSERT_EQ(test.specimens.size(), 1u);
    EXPECT_EQ(test.specimens[0].start.vertical_stress, 100e3);
    EXPECT_EQ(test.specimens[0].start.k0, 0.5);
    EXPECT_DOUBLE_EQ(sand_of(test.specimens[0]).eta_f, make_ubcsand(ubcsand_from_blow_count(13.9)).eta_f);
    ASSERT_EQ(test.loadings.size(), 3u);
    const auto& loading = std::get<StressCycles>(test.loadings[1]);
    EXPECT_EQ(loading.csr, 0.2);
    EXPECT_EQ(loading.cycles, 30.0);
    EXPECT_EQ(loading.largest_gamma, 0.1);
    EXPECT_EQ(loading.cycles_after, 5.0);
    EXPECT_TRUE(reading.warnings.empty());
}

TEST(ElementFile, ReadsEveryKindOfTest)
{
    const auto loading = [](const std::string& keys) { return first_test(keys).loadings.at(0); };
    const auto strain = std::get<StrainCycles>(
        loading("kind = \"cyclic_shear_strain_controlled\"\nshear_strains = [\"0.1 %\"]\ncycles = 7"));
    EXPECT_EQ(strain.gamma, 0.001);
    EXPECT_EQ(strain.cycles, 7.0);
    const auto shear = std::get<MonotonicShear>(
        loading("kind = \"monotonic_shear\"\ndrainage = \"drained\"\nlargest_shear_strain = \"5 %\""));
    EXPECT_EQ(shear.drainage, Drainage::drained);
    EXPECT_EQ(shear.largest_gamma, 0.05);
    const auto biaxial = std::get<BiaxialCompression>(
        loading("kind = \"biaxial_compression\"\nlargest_vertical_strain = 0.02"));
    EXPECT_EQ(biaxial.drainage, Drainage::undrained);
    EXPECT_EQ(biaxial.largest_strain, 0.02);
    const auto oedometer =
        std::get<OedometerLoading>(loading("kind = \"oedometer\"\nstresses = [\"400 kPa\", 100e3]"));
    EXPECT_EQ(oedometer.vertical_stresses, (std::vector<double>{400e3, 100e3}));
    const ElementTest isotropic = first_test("kind = \"isotropic_compression\"\nstresses = [200e3]");
    EXPECT_EQ(std::get<IsotropicLoading>(isotropic.loadings[0]).mean_stresses, std::vector<double>{200e3});
    EXPECT_EQ(isotropic.specimens[0].start.k0, 1.0);
}

TEST(ElementFile, StaticShearIsARatioOfTheVerticalStress)
{
    const ElementTest test = first_test("kind = \"cyclic_shear_stress_controlled\"\ncsr = [0.1]\n"
                                        "vertical_stress = \"200 kPa\"\nstatic_shear_ratio = 0.15");
    EXPECT_DOUBLE_EQ(test.specimens[0].start.static_shear, 30e3);
}

TEST(ElementFile, VariesANumberOfTheMaterial)
{
    const ElementTest test = first_test("kind = \"monotonic_shear\"\nvary = \"n1_60\"\nvalues = [5, 10.5]");
    ASSERT_EQ(test.specimens.size(), 2u);
    EXPECT_EQ(test.varied, "n1_60");
    EXPECT_EQ(test.specimens[0].label, "n1_60 = 5");
    EXPECT_EQ(test.specimens[1].label, "n1_60 = 10.5");
    EXPECT_EQ(test.specimens[1].value, 10.5);
    EXPECT_EQ(sand_of(test.specimens[1]).Gp_atm, make_ubcsand(ubcsand_from_blow_count(10.5)).Gp_atm);
}

TEST(ElementFile, VariesANumberOfTheTestThatTheFileLeavesAtItsDefault)
{
    const ElementTest test =
        first_test("kind = \"monotonic_shear\"\nvary = \"vertical_stress\"\nvalues = [\"50 kPa\", 200e3]");
    ASSERT_EQ(test.specimens.size(), 2u);
    EXPECT_EQ(test.specimens[0].label, "vertical_stress = 50 kPa");
    EXPECT_EQ(test.specimens[0].start.vertical_stress, 50e3);
    EXPECT_EQ(test.specimens[1].start.vertical_stress, 200e3);
}

TEST(ElementFile, ReadsTheUsersPoints)
{
    const ElementTest test =
        first_test("kind = \"cyclic_shear_stress_controlled\"\ncsr = [0.1]\nvary = \"n1_60\"\n"
                   "values = [10, 20]\ndata = \"points.csv\"\ndata_label = \"laboratory\"");
    ASSERT_TRUE(test.data);
    EXPECT_EQ(test.data->label, "laboratory");
    ASSERT_EQ(test.data->points.size(), 2u);
    EXPECT_EQ(test.data->points[1].csr, 0.2);
    EXPECT_EQ(test.data->points[1].cycles, 15.0);
    EXPECT_EQ(test.data->points[1].value, 20.0);
}

TEST(ElementFile, OverridesReplaceKeys)
{
    const ElementFolder folder;
    const ElementReading reading =
        folder.read(sound_tests, {"materials.sand.n1_60=20", "tests.strength.csr=[0.25]"});
    EXPECT_EQ(reading.programme.tests[0].loadings.size(), 1u);
    EXPECT_DOUBLE_EQ(sand_of(reading.programme.tests[0].specimens[0]).eta_f,
                     make_ubcsand(ubcsand_from_blow_count(20.0)).eta_f);
}

/// A material of the law as a user writes it, of the law's usual numbers.
std::string material_of(const SoilLaw& law)
{
    std::string text = "[materials.soil]\nmodel = \"" + std::string(law.word) + "\"\n";
    const SkeletonLaw example = example_of(law);
    const std::vector<LawKeyText> keys = keys_of(example);
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (!keys[k].standard && keys[k].absent.empty())
            text += std::string(keys[k].name) + " = " + std::to_string(value_of(example, k)) +
                    (keys[k].unit == "deg" ? "e0\n" : "\n");
    const bool has_density = keys.empty() || std::any_of(keys.begin(), keys.end(), [](const LawKeyText& key) {
                                 return key.name == "n1_60";
                             });
    return has_density ? text + "n1_60 = 13.9\n" : text; // one of the keys of a density is needed
}

TEST(ElementFile, EveryLawOfScenesGoesThroughEveryTest)
{
    const std::string tests = R"(
[tests.stress]
kind = "cyclic_shear_stress_controlled"
csr = [0.1]
cycles = 2
[tests.strain]
kind = "cyclic_shear_strain_controlled"
shear_strains = [1e-4]
cycles = 2
[tests.shear]
kind = "monotonic_shear"
largest_shear_strain = 0.002
[tests.drained_shear]
kind = "monotonic_shear"
drainage = "drained"
largest_shear_strain = 0.002
[tests.biaxial]
kind = "biaxial_compression"
largest_vertical_strain = 0.002
[tests.drained_biaxial]
kind = "biaxial_compression"
drainage = "drained"
largest_vertical_strain = 0.002
[tests.oedometer]
kind = "oedometer"
stresses = ["150 kPa", "100 kPa"]
[tests.isotropic]
kind = "isotropic_compression"
stresses = ["150 kPa", "100 kPa"]
)";
    const ElementFolder folder;
    for (const SoilLaw& law : soil_laws()) {
        const ElementReading reading = folder.read("test_version = 1\n" + material_of(law) + tests);
        ASSERT_EQ(reading.programme.tests.size(), 8u);
        for (const ElementTest& test : reading.programme.tests) {
            const ElementSpecimen& specimen = test.specimens.at(0);
            EXPECT_EQ(specimen.soil.law.index(), law.form.index());
            EXPECT_FALSE(specimen.soil.numbers.empty()) << law.word;
            const ElementPath path = perform(specimen.soil.law, specimen.start, test.loadings.at(0)).path;
            ASSERT_GT(path.size(), 10u) << law.word << " " << test.name;
            for (const ElementPoint& point : path)
                ASSERT_TRUE(std::isfinite(point.tau + point.sigma_x + point.sigma_y + point.sigma_z))
                    << law.word << " " << test.name;
        }
    }
}

TEST(ElementFile, ALawIsToldWithItsNumbers)
{
    const ElementFolder folder;
    const ElementReading reading = folder.read(
        "test_version = 1\n[materials.clay]\nmodel = \"mohr_coulomb\"\nshear_modulus = \"5 MPa\"\n"
        "poisson_ratio = 0.3\nfriction_angle = \"30 deg\"\ncohesion = \"8 kPa\"\n"
        "[tests.a]\nkind = \"monotonic_shear\"\n");
    const DescribedLaw& soil = reading.programme.tests.at(0).soil;
    EXPECT_EQ(soil.title, "mohr_coulomb");
    EXPECT_EQ(soil.density, "");
    EXPECT_EQ(soil.numbers,
              "shear_modulus = 5e6 Pa, poisson_ratio = 0.3, cohesion = 8000 Pa, friction_angle = 30 deg, "
              "dilation_angle = 0 deg");
}

TEST(ElementFile, AnAcceptedWarningIsSilent)
{
    const ElementFolder folder;
    const std::string odd = fixtures::replaced(sound_tests, "k0 = 0.5", "k0 = 2.5");
    EXPECT_NE(folder.message(odd), "");
    EXPECT_EQ(folder.message(fixtures::replaced(odd, "title = \"sand\"", "accept = [\"tests.strength.k0\"]")),
              "");
}

} // namespace
} // namespace quicksand
