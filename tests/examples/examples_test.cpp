// The examples and what users are shown: fixed file names, headers, counts, scenes made by `new`.
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace quicksand {

namespace {

using namespace testing_program;

/// The number that the pattern's first group finds, thousands separated or not; -1 when it finds nothing.
long number_in(const std::string& text, const std::string& pattern)
{
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(pattern))) return -1;
    std::string digits = match[1];
    std::erase(digits, ',');
    return std::stol(digits);
}

void expect_results(const std::filesystem::path& results, const std::string& probe)
{
    for (const char* name : {"fields.pvd", "fields/frame_000000.vtu", "grid.pvd", "grid/frame_000000.vtu",
                             "history.csv", "steps.csv", "run_manifest.json", "log.txt"}) {
        EXPECT_TRUE(std::filesystem::exists(results / name)) << name;
    }
    EXPECT_TRUE(header_of(results / ("probes/" + probe + ".csv")).starts_with("time_s,x_m,y_m,ux_m,uy_m"));
    EXPECT_NE(header_of(results / ("probes/" + probe + ".csv")).find("excess_pore_pressure_Pa,ru"),
              std::string::npos);
    EXPECT_TRUE(header_of(results / "history.csv").starts_with("time_s,"));
    EXPECT_NE(header_of(results / "history.csv").find("crest_settlement_m"), std::string::npos);
    EXPECT_TRUE(header_of(results / "steps.csv").starts_with("time_s,step,dt_s,dt_limiter"));
    EXPECT_NE(read_file(results / "run_manifest.json").find("\"status\": \"finished\""), std::string::npos);
}

TEST(Column, CheckCountsParticlesCellsAndSteps)
{
    const WorkFolder folder;
    const Outcome check =
        run_program("check " + example("column") + " --until 1e-3 -o " + (folder / "check").string());
    EXPECT_EQ(check.code, 0) << check.output;
    EXPECT_NE(check.output.find("3,429 particles in 9 x 52 = 468 cells"), std::string::npos) << check.output;
    EXPECT_NE(check.output.find("of the weight: the run starts in equilibrium"), std::string::npos)
        << check.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "check/fields.pvd"));
    EXPECT_TRUE(std::filesystem::exists(folder / "check/grid.pvd"));

    const Outcome run =
        run_program("run " + example("column") + " --until 1e-3 -o " + (folder / "run").string());
    EXPECT_EQ(run.code, 0) << run.output;
    const long predicted = number_in(check.output, "steps +([0-9,]+) of");
    const long taken = number_in(read_file(folder / "run/run_manifest.json"), "\"steps\": ([0-9]+)");
    EXPECT_NEAR(static_cast<double>(predicted), static_cast<double>(taken),
                0.05 * static_cast<double>(taken));
}

TEST(Column, RunWritesTheFixedNames)
{
    const WorkFolder folder;
    const Outcome run =
        run_program("run " + example("column") + " --until 6e-4 --set output.frame_interval=\"0.2 ms\" -o " +
                    (folder / "out").string());
    EXPECT_EQ(run.code, 0) << run.output;
    expect_results(folder / "out", "upper");
    EXPECT_TRUE(std::filesystem::exists(folder / "out/fields/frame_000003.vtu"));
    EXPECT_NE(run.output.find("fields.pvd"), std::string::npos);
    EXPECT_NE(run.output.find("crest settlement"), std::string::npos);

    const Outcome probe =
        run_program("probe " + (folder / "out").string() +
                    " --at 0.03,0.1 --fields excess_pore_pressure,ru -o " + (folder / "a.csv").string());
    EXPECT_EQ(probe.code, 0) << probe.output;
    EXPECT_EQ(header_of(folder / "a.csv"), "time_s,excess_pore_pressure_Pa,ru");
}

TEST(Dike, SettlesShakesAndDraws)
{
    const WorkFolder folder;
    const Outcome run =
        run_program("run " + example("dike") +
                    " --until 1e-4 --set relaxation.tolerance=0.02 --set output.frame_interval=5e-5 -o " +
                    (folder / "out").string());
    EXPECT_EQ(run.code, 0) << run.output;
    expect_results(folder / "out", "A");
    EXPECT_NE(run.output.find("Settled in"), std::string::npos);

    const Outcome picture = run_program("picture " + (folder / "out").string() + " --field displacement -o " +
                                        (folder / "picture.png").string());
    EXPECT_EQ(picture.code, 0) << picture.output;
    EXPECT_TRUE(read_file(folder / "picture.png").starts_with("\x89PNG"));
}

TEST(Bench, TellsWhatThePhasesOfAStepCost)
{
    const Outcome outcome = run_program("bench kernel " + example("column") + " --threads 1");
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    for (const char* row : {"\nscatter  ", "\npore_pressure  ", "\nstress  ", "\nwhole step  "})
        EXPECT_NE(outcome.output.find(row), std::string::npos) << row;
    // most virtual machines have no counter
    const bool counted = outcome.output.find("\ninstructions each, 1 thread\n") != std::string::npos;
    const bool excused =
        outcome.output.find("\ninstructions: not counted, this machine has no counter") != std::string::npos;
    EXPECT_NE(counted, excused) << outcome.output;
}

TEST(Bench, TakesTheColumnsOfFreeFieldsAlong)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("bench skip " + example("free_field") +
                                        " --threads 1 --set grid.cell_size=2 -o " + folder.string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    expect_mention(outcome, "100 %");
}

TEST(Bench, ComparesTheAnswersOfGrids)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("bench grid " + example("column") + " --until 2e-3 --threads 1 -o " +
                                        (folder / "bench").string());
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    // nine cells of 7.5 mm between tied sides are no whole number of larger ones
    EXPECT_NE(outcome.output.find("15 mm, 3 x 3\n  left out: "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("middle: excess pore pressure, late mean [kPa]"), std::string::npos);
    EXPECT_NE(outcome.output.find("mean square difference from 3.75 mm, 3 x 3"), std::string::npos);
    const std::string table = read_file(folder / "bench/column/grid.csv");
    for (const char* setting : {"7.5 mm, 3 x 3", "3.75 mm, 3 x 3", "7.5 mm, 2 x 2", "7.5 mm, 4 x 4"})
        EXPECT_NE(table.find(setting), std::string::npos) << setting;
    EXPECT_TRUE(read_file(folder / "bench/column/grid_settlement.png").starts_with("\x89PNG"));
}

TEST(Bench, TellsWhenNoGridReachesItsEnd)
{
    const WorkFolder folder;
    const Outcome outcome = run_program("bench grid " + example("dike") +
                                        " --set grid.cell_size=0.03 --set 'grid.cells=[16,11]'"
                                        " --set relaxation.max_steps=1 -o " +
                                        (folder / "bench").string());
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    EXPECT_NE(outcome.output.find("  left out: the run failed; see "), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find("none of the runs reached its end; see "), std::string::npos)
        << outcome.output;
}

TEST(New, TheColumnRunsUnchanged)
{
    const WorkFolder folder;
    const Outcome made = run_program("new column " + (folder / "mine").string());
    ASSERT_EQ(made.code, 0) << made.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "mine/mine.geo"));
    const Outcome run = run_shell("cd " + folder.string() + " && \"$QUICKSAND\" run mine --until 1e-5");
    EXPECT_EQ(run.code, 0) << run.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "results/mine/fields.pvd"));
}

TEST(New, EveryKindHasWhatItNeeds)
{
    const WorkFolder folder;
    const std::string in_folder = "cd " + folder.string() + " && \"$QUICKSAND\" ";
    for (const std::string kind : {"river_dike", "sea_dike", "level_site", "slope"}) {
        const Outcome made = run_shell(in_folder + "new " + kind + " my_" + kind);
        ASSERT_EQ(made.code, 0) << made.output;
        const std::string coarse =
            kind == "river_dike" ? " --set grid.cell_size=2 --set sampling.particles_per_cell=[1,1]" : "";
        const Outcome run =
            run_shell(in_folder + "run my_" + kind + " --until 1e-5 --set relaxation.tolerance=0.5" + coarse);
        EXPECT_EQ(run.code, 0) << run.output;
    }
}

TEST(New, TheDikeRunsUnchanged)
{
    const WorkFolder folder;
    const Outcome made = run_shell("cd " + folder.string() + " && \"$QUICKSAND\" new dike 'my dike'");
    ASSERT_EQ(made.code, 0) << made.output;
    const Outcome check =
        run_shell("cd " + folder.string() +
                  " && \"$QUICKSAND\" run 'my dike/scene.toml' --until 1e-5 --set relaxation.tolerance=0.1");
    EXPECT_EQ(check.code, 0) << check.output;
    EXPECT_TRUE(std::filesystem::exists(folder / "results/my dike/grid.pvd"));
}

TEST(Keys, TheReferencePageIsUpToDate)
{
    const Outcome outcome = run_program("keys --markdown");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_TRUE(outcome.output == read_file(in_checkout("io/SCENE.md")))
        << "make it anew: quicksand keys --markdown > io/SCENE.md";
    const Outcome results = run_program("keys --results --markdown");
    EXPECT_EQ(results.code, 0);
    EXPECT_TRUE(results.output == read_file(in_checkout("io/RESULTS.md")))
        << "make it anew: quicksand keys --results --markdown > io/RESULTS.md";
}

TEST(Keys, LookQuantitiesOfResultsUp)
{
    const Outcome found = run_program("keys --results settlement");
    EXPECT_EQ(found.code, 0);
    EXPECT_TRUE(found.output.starts_with("crest_settlement_m\n")) << found.output;
    const Outcome stress = run_program("keys --results vertical_effective_stress");
    EXPECT_NE(stress.output.find("\n    -sigma'_yy, compression positive"), std::string::npos)
        << stress.output;
}

/// Every file of a run has a row in io/RESULTS.md, and every row a file.
TEST(Results, AreThoseOfTheReference)
{
    const WorkFolder folder;
    const Outcome run =
        run_program("run " + example("column") + " --until 1e-5 -o " + (folder / "r").string());
    ASSERT_EQ(run.code, 0) << run.output;
    const std::string page = read_file(in_checkout("io/RESULTS.md"));
    std::set<std::string> written;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "r")) {
        if (!entry.is_regular_file()) continue;
        std::string name = std::filesystem::relative(entry.path(), folder / "r").string();
        if (name.ends_with(".vtu")) name = name.substr(0, name.find('/')) + "/*.vtu";
        if (name.starts_with("probes/")) name = "probes/NAME.csv";
        written.insert(name);
    }
    for (const std::string& name : written)
        EXPECT_TRUE(page.find("`" + name + "`") != std::string::npos ||
                    page.find(", " + name + "`") != std::string::npos ||
                    page.find("`" + name + ",") != std::string::npos)
            << name;
    for (const char* name : {"fields.pvd", "grid.pvd", "probes/NAME.csv", "history.csv", "steps.csv",
                             "checkpoint/state.h5", "run_manifest.json", "scene.toml", "log.txt"})
        EXPECT_TRUE(written.contains(name)) << name;
}

TEST(Check, SaysThatASlopeDoesNotStartInEquilibriumAndWhatLiesAboveTheWater)
{
    const WorkFolder folder;
    const std::string coarse = "check " + example("dike") + " --set grid.cell_size=0.03 --until 1e-4 -o ";
    const Outcome settled = run_program(coarse + (folder / "settled").string());
    EXPECT_EQ(settled.code, 0) << settled.output;
    EXPECT_NE(settled.output.find("of the weight: the soil settles before the run"), std::string::npos)
        << settled.output;
    std::string scene = read_file(in_checkout("examples/dike/scene.toml"));
    const auto table = scene.find("[relaxation]"), next = scene.find("[motion]");
    scene.erase(table, next - table);
    std::filesystem::create_directories(folder / "dike");
    std::filesystem::copy(in_checkout("examples/dike"), folder / "dike",
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    std::ofstream(folder / "dike/scene.toml") << scene;
    const Outcome open = run_program("check " + (folder / "dike").string() +
                                     " --set grid.cell_size=0.03 --set water.level=0.15 --until 1e-4 -o " +
                                     (folder / "open").string());
    EXPECT_EQ(open.code, 0) << open.output;
    EXPECT_NE(open.output.find("particles lie above the phreatic line and carry no pore water"),
              std::string::npos)
        << open.output;
    EXPECT_NE(
        open.output.find("the run does not start in equilibrium; a table [relaxation] lets the soil settle"),
        std::string::npos)
        << open.output;
}

} // namespace

} // namespace quicksand
