#include "io/element/element_results.hpp"
#include "io/element/element_sheet.hpp"
#include "io/element/element_table.hpp"
#include "io/pictures/picture_table.hpp"
#include "tests/fixtures/element_example.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::ElementFolder;
using fixtures::TemporaryFolder;

const std::string two_sands = R"(test_version = 1
title = "sand"
[materials.sand]
model = "ubcsand"
n1_60 = 10
[tests.strength]
kind = "cyclic_shear_stress_controlled"
vary = "n1_60"
values = [5, 10]
csr = [0.15, 0.25]
cycles = 20
cycles_after_liquefaction = 1
data = "points.csv"
data_label = "laboratory"
)";

ElementReading read(const std::string& text)
{
    const ElementFolder folder;
    folder.write("points.csv", "CSR,N,n1_60\n0.12,15,10\n");
    return folder.read(text);
}

ElementOutcome perform_all(const ElementTest& test)
{
    ElementOutcome outcome{test, {}, {}};
    for (std::size_t k = 0; k < test.specimens.size(); ++k) {
        for (std::size_t j = 0; j < test.loadings.size(); ++j) {
            const ElementSpecimen& specimen = test.specimens[k];
            outcome.runs.push_back({k, j, perform(specimen.soil.law, specimen.start, test.loadings[j])});
        }
        outcome.strengths.emplace_back(CyclicStrength{0.1 + 0.05 * static_cast<double>(k), 0.3});
    }
    return outcome;
}

ElementOutcome strength_of_two_sands()
{
    return perform_all(read(two_sands).programme.tests[0]);
}

ElementOutcome other_test(const std::string& keys)
{
    ElementOutcome outcome = perform_all(
        read("test_version = 1\n[materials.sand]\nmodel = \"ubcsand\"\nn1_60 = 10\n[tests.a]\n" + keys)
            .programme.tests[0]);
    outcome.strengths.clear();
    return outcome;
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(ElementResults, ASeriesThatNeverLiquefiesIsDrawn)
{
    const TemporaryFolder folder;
    const ElementReading reading =
        read("test_version = 1\n[materials.rock]\nmodel = \"linear_elastic\"\n"
             "shear_modulus = 1e8\npoisson_ratio = 0.2\n[tests.a]\n"
             "kind = \"cyclic_shear_stress_controlled\"\ncsr = [0.1, 0.2]\ncycles = 2\n");
    ElementOutcome outcome = perform_all(reading.programme.tests[0]);
    outcome.strengths = {std::nullopt};
    ElementResults results(folder / "out", reading.programme);
    draw_element_pictures(outcome, "", results);
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / "a" / "csr_n.png"));
    EXPECT_EQ(describe_conditions(outcome)[0],
              "Material   rock: linear_elastic; shear_modulus = 1e8 Pa, poisson_ratio = 0.2");
}

TEST(ElementResults, TheTableOfCyclesHoldsEveryRun)
{
    const TemporaryFolder folder;
    const ElementOutcome outcome = strength_of_two_sands();
    ElementResults results(folder / "out", read(two_sands).programme);
    write_element_csv(outcome, results);
    const PictureTable table = read_picture_table(folder / "out/strength/csr_n.csv");
    EXPECT_EQ(table.columns,
              (std::vector<std::string>{"n1_60", "csr", "cycles_to_ru_0.95", "cycles_to_3_percent_strain",
                                        "cycles_to_3.75_percent_strain", "cycles_to_7.5_percent_double",
                                        "cycles_run", "largest_ru", "largest_shear_strain"}));
    EXPECT_EQ(*table.find("n1_60"), (std::vector<double>{5.0, 5.0, 10.0, 10.0}));
    EXPECT_EQ(*table.find("csr"), (std::vector<double>{0.15, 0.25, 0.15, 0.25}));
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ((*table.find("cycles_to_ru_0.95"))[k], outcome.runs[k].result.cycles_to_ru_95);
    }
    const PictureTable strength = read_picture_table(folder / "out/strength/strength.csv");
    EXPECT_EQ(*strength.find("csr_15"), (std::vector<double>{0.1, 0.15}));
}

TEST(ElementResults, APathHasUnitsAndItsStressesBelongTogether)
{
    const TemporaryFolder folder;
    const ElementOutcome outcome = strength_of_two_sands();
    ElementResults results(folder / "out", read(two_sands).programme);
    write_element_csv(outcome, results);
    const PictureTable path = read_picture_table(folder / "out/strength/path_n1_60_10_CSR_0.25.csv");
    EXPECT_EQ(path.columns.size(), 14u);
    const auto& tau = *path.find("shear_stress_Pa");
    ASSERT_EQ(tau.size(), outcome.runs[3].result.path.size());
    for (std::size_t k = 0; k < tau.size(); ++k) {
        const double x = (*path.find("horizontal_effective_stress_Pa"))[k];
        const double y = (*path.find("vertical_effective_stress_Pa"))[k];
        const double z = (*path.find("out_of_plane_effective_stress_Pa"))[k];
        // the file has seven digits of each
        EXPECT_NEAR((*path.find("mean_effective_stress_Pa"))[k], (x + y + z) / 3.0, 0.02);
        const double q2 =
            0.5 * ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) + 3.0 * tau[k] * tau[k];
        EXPECT_NEAR((*path.find("deviator_stress_Pa"))[k], std::sqrt(q2), 0.03);
        EXPECT_NEAR((*path.find("excess_pore_pressure_Pa"))[k], 100e3 - y, 0.02);
        EXPECT_NEAR((*path.find("volumetric_strain"))[k], 0.0, 1e-15);
    }
}

TEST(ElementResults, OfStrainCyclesHoldModulusAndDamping)
{
    const TemporaryFolder folder;
    const ElementOutcome outcome =
        other_test("kind = \"cyclic_shear_strain_controlled\"\nshear_strains = [1e-4]\ncycles = 3");
    ElementResults results(folder / "out", read(two_sands).programme);
    write_element_csv(outcome, results);
    const PictureTable table = read_picture_table(folder / "out/a/cycles.csv");
    EXPECT_EQ(*table.find("cycle"), (std::vector<double>{1.0, 2.0}));
    EXPECT_GT((*table.find("damping_ratio"))[0], 0.0);
    EXPECT_GT((*table.find("secant_shear_modulus_Pa"))[0], 1e7);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/a/path_gamma_0.01_percent.csv"));
}

TEST(ElementResults, ReplaceThoseOfAFormerRunAndNothingElse)
{
    const TemporaryFolder folder;
    const ElementReading reading = read(two_sands);
    {
        ElementResults former(folder / "out", reading.programme);
        std::ofstream(former.add("strength", "old.csv")) << "1\n";
        former.finish();
    }
    std::ofstream(folder / "out/mine.txt") << "keep\n";
    ElementResults results(folder / "out", reading.programme);
    EXPECT_FALSE(std::filesystem::exists(folder / "out/strength"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/mine.txt"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/test.toml"));
}

TEST(ElementResults, LeaveAFolderOfOtherThingsAlone)
{
    const TemporaryFolder folder;
    const ElementReading reading = read(two_sands);
    std::filesystem::create_directory(folder / "run");
    std::ofstream(folder / "run/run_manifest.json") << "{}\n";
    EXPECT_THROW(ElementResults(folder / "run", reading.programme), InputError);
    EXPECT_THROW(ElementResults(folder / "run/run_manifest.json", reading.programme), InputError);
    EXPECT_TRUE(std::filesystem::exists(folder / "run/run_manifest.json"));
}

TEST(ElementSheet, OfCyclicStrengthShowsAllFourPicturesAndThePoints)
{
    const LaboratorySheet sheet = report_sheet(strength_of_two_sands(), "sand");
    ASSERT_EQ(sheet.panels.size(), 5u);
    const std::string script = sheet_drawing(sheet, "out.png").commands;
    for (const char* label :
         {"'Shear strain γ [%]'", "'Shear stress τ [kPa]'", "'Vertical effective stress σ''v [kPa]'",
          "'Excess pore pressure ratio ru'", "'Number of cycles N'", "'Cyclic stress ratio CSR'",
          "title 'n1_60 = 5'", "title 'laboratory'", "set logscale x 10"}) {
        EXPECT_TRUE(contains(script, label)) << label;
    }
    EXPECT_TRUE(contains(script, "\n15 0.12\nend_of_data"));
    EXPECT_TRUE(contains(joined(sheet.details), "σ'v0 = 100 kPa, K0 = 0.5"));
    EXPECT_TRUE(contains(joined(sheet.table), "n1_60 = 5          0.1000    0.300")) << joined(sheet.table);
}

TEST(ElementSheet, EveryKindOfTestHasItsPage)
{
    for (const char* keys :
         {"kind = \"cyclic_shear_strain_controlled\"\nshear_strains = [1e-4, 1e-3]\ncycles = 3",
          "kind = \"monotonic_shear\"\nlargest_shear_strain = 0.02",
          "kind = \"monotonic_shear\"\ndrainage = \"drained\"\nlargest_shear_strain = 0.01",
          "kind = \"biaxial_compression\"\nlargest_vertical_strain = 0.01",
          "kind = \"biaxial_compression\"\ndrainage = \"drained\"\nlargest_vertical_strain = 0.01",
          "kind = \"oedometer\"\nstresses = [2e5, 1e5]",
          "kind = \"isotropic_compression\"\nstresses = [2e5]"}) {
        const LaboratorySheet sheet = report_sheet(other_test(keys), "");
        EXPECT_EQ(sheet.title, "Element test a");
        EXPECT_GE(sheet.panels.size(), 1u) << keys;
        EXPECT_GE(sheet.table.size(), 2u) << keys;
        for (const PlotPanel& panel : sheet.panels) {
            EXPECT_FALSE(panel.heading.empty());
            ASSERT_FALSE(panel.curves.empty());
            EXPECT_GE(panel.curves[0].x.size(), 2u) << keys;
        }
    }
}

TEST(ElementSheet, GnuplotDrawsIt)
{
    const TemporaryFolder folder;
    draw_pictures({sheet_drawing(report_sheet(strength_of_two_sands(), "it's sand"), folder / "report.png")});
    std::ifstream stream(folder / "report.png", std::ios::binary);
    std::string head(4, ' ');
    stream.read(head.data(), 4);
    EXPECT_EQ(head, "\x89PNG");
}

TEST(ElementTable, LongOnesAreCut)
{
    ElementOutcome outcome = strength_of_two_sands();
    ElementRun run = outcome.runs[0];
    for (int k = 0; k < 40; ++k) {
        run.loading = outcome.test.loadings.size();
        outcome.test.loadings.push_back(outcome.test.loadings[0]);
        outcome.runs.push_back(run);
    }
    const std::vector<std::string> lines = result_table(outcome, 18);
    EXPECT_LE(lines.size(), 18u);
    EXPECT_TRUE(contains(joined(lines), "more rows in the CSV file"));
}

} // namespace
} // namespace quicksand
