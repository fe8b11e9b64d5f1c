// The manual pages name all there is and are clean; the shells are offered what can stand at the cursor.
#include "io/element/element_keys.hpp"
#include "io/keys/scene_schema.hpp"
#include "tests/examples/program.hpp"
#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

using namespace testing_program;

using Words = std::vector<std::string>;

/// As troff writes it: a minus instead of a hyphen.
std::string in_troff(const std::string& word)
{
    std::string text;
    for (const char letter : word) text += letter == '-' ? "\\-" : std::string(1, letter);
    return text;
}

/// The words that a shell is offered behind `line`; the first names the files that it adds itself.
Words offered(const std::string& line)
{
    std::istringstream answer(run_program("complete " + line).output);
    Words words;
    for (std::string text; std::getline(answer, text);) words.push_back(text.substr(0, text.find('\t')));
    return words;
}

/// What bash puts in the place of the word at the end of `line`, one a line; `word` is the part that it
/// replaces.
std::string offered_in_bash(const std::string& line, const std::string& word)
{
    const std::string script = "source " + in_checkout("app/completion/quicksand.bash") +
                               "\n"
                               "compopt() { :; }\n"
                               "COMP_LINE='" +
                               line + "' COMP_POINT=" + std::to_string(line.size()) +
                               "\n_quicksand \"$QUICKSAND\" '" + word +
                               "'\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    return run_shell("QUICKSAND=\"$QUICKSAND\" bash <<'END'\n" + script + "END").output;
}

bool has(const Words& words, const std::string& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(ManualPages, NameEveryCommandAndOption)
{
    const std::string page = run_program("manual").output;
    const Words commands = offered("''");
    ASSERT_GT(commands.size(), 10U);
    for (std::size_t k = 1; k < commands.size(); ++k) {
        const std::size_t begin = page.find(".SS \\fB" + commands[k] + "\\fR");
        ASSERT_NE(begin, std::string::npos) << commands[k];
        const std::string part = page.substr(begin, page.find("\n.S", begin + 1) - begin);
        const Words options = offered(commands[k] + " --");
        for (std::size_t n = 1; n < options.size(); ++n) {
            if (options[n] == "--help") continue; // said once for all
            EXPECT_NE(part.find("\\fB" + in_troff(options[n]) + "\\fR"), std::string::npos)
                << commands[k] << " " << options[n];
        }
    }
    for (const char* text :
         {"\\-\\-help", "\\-\\-version", ".SH EXIT STATUS", ".SH ENVIRONMENT", ".SH FILES"}) {
        EXPECT_NE(page.find(text), std::string::npos) << text;
    }
}

TEST(ManualPages, NameEveryKey)
{
    for (const auto& [name, table] : {std::pair{"quicksand-scene", &scene_key_table()},
                                      std::pair{"quicksand-element", &element_key_table()}}) {
        const std::string page = run_program(std::string("manual ") + name).output;
        std::size_t place = page.find(".SH KEYS");
        ASSERT_NE(place, std::string::npos);
        for (const SceneKey& key : table->keys) { // in the order of the table
            const std::string entry = is_table(key)
                                          ? ".SS [" + shown_path(key.pattern) + "]\n"
                                          : ".TP\n\\fB" + std::string(last_part(key.pattern)) + "\\fR\n";
            place = page.find(entry, place);
            ASSERT_NE(place, std::string::npos) << key.pattern;
        }
    }
}

TEST(ManualPages, AreWithoutWarnings)
{
    const bool has_man = run_shell("command -v man && command -v groff").code == 0;
    const bool has_mandoc = run_shell("command -v mandoc").code == 0;
    if (!has_man && !has_mandoc) GTEST_SKIP() << "neither man nor mandoc is here";
    for (const std::string page : {"quicksand", "quicksand-scene", "quicksand-element"}) {
        const std::string print = "\"$QUICKSAND\" manual " + page;
        if (has_man) {
            EXPECT_EQ(
                run_shell(print + " | LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l - >/dev/null").output, "");
        }
        if (has_mandoc) {
            EXPECT_EQ(run_shell(print + " | mandoc -T lint -W warning").output, "");
        }
    }
}

TEST(Completion, OffersCommandsAndOptions)
{
    EXPECT_EQ(offered("ru"), (Words{"none", "run"}));
    EXPECT_EQ(offered("run --o"), (Words{"none", "--output", "--overwrite"}));
    EXPECT_EQ(offered("--v"), (Words{"none", "--version"}));
    EXPECT_EQ(offered("frobnicate x"), (Words{"none"}));
    const Words options = offered("run scene.toml --overwrite --set a=1 --");
    EXPECT_FALSE(has(options, "--overwrite")) << "it is there already";
    EXPECT_TRUE(has(options, "--set")) << "it may be given again";
}

TEST(Completion, OffersWhatAnOptionTakes)
{
    EXPECT_EQ(offered("probe results --kind m"), (Words{"none", "material"}));
    EXPECT_EQ(offered("probe --kind=m"), (Words{"none", "--kind=material"}));
    EXPECT_EQ(offered("bench s"), (Words{"none", "scale", "skip"}));
    EXPECT_EQ(offered("new d"), (Words{"none", "dike"}));
    EXPECT_EQ(offered("manual quicksand-s"), (Words{"none", "quicksand-scene"}));
    EXPECT_TRUE(has(offered("verify ''"), "terzaghi"));
    EXPECT_EQ(offered("run ''"), (Words{"scenes"}));
    EXPECT_EQ(offered("run a.toml --output ''"), (Words{"folders"}));
    EXPECT_EQ(offered("probe results -o ''"), (Words{"all"}));
    EXPECT_EQ(offered("run --threads ''"), (Words{"none"}));
}

TEST(Completion, OffersKeysAfterSet)
{
    const Words grid = offered("run --set grid.");
    EXPECT_EQ(grid, (Words{"none", "grid.cell_size=", "grid.origin=", "grid.cells="}));
    EXPECT_TRUE(has(offered("run --set ''"), "materials."));
    EXPECT_EQ(offered("run --set analysis.scheme="),
              (Words{"none", "analysis.scheme=explicit", "analysis.scheme=semi_implicit",
                     "analysis.scheme=implicit", "analysis.scheme=auto"}));
    EXPECT_TRUE(has(offered("run --set materials.sand."), "materials.sand.porosity="));
    EXPECT_EQ(offered("run --set no.such."), (Words{"none"}));
    EXPECT_TRUE(has(offered("element --set tests.strength."), "tests.strength.csr="));
}

TEST(Completion, OffersTheNamesOfTheSceneAfterSet)
{
    EXPECT_EQ(offered("run " + example("dike") + " --set materials."), (Words{"none", "materials.sand."}));
    EXPECT_EQ(offered("run " + example("sea_dike") + "/drained.toml --set regions."),
              offered("run " + example("sea_dike") + " --set regions."))
        << "a variant has the names of its base";
    EXPECT_EQ(offered("run /no/such/scene --set materials."), (Words{"none"}));
}

TEST(Completion, WorksInBash)
{
    EXPECT_EQ(run_shell("bash -n " + in_checkout("app/completion/quicksand.bash")).output, "");
    EXPECT_EQ(offered_in_bash("quicksand ru", "ru"), "run\n");
    EXPECT_EQ(offered_in_bash("quicksand run --o", "--o"), "--output\n--overwrite\n");
    EXPECT_EQ(offered_in_bash("quicksand run --set grid.c", "grid.c"), "grid.cell_size=\ngrid.cells=\n");
    EXPECT_EQ(offered_in_bash("quicksand run --set analysis.scheme=s", "s"), "semi_implicit\n")
        << "bash replaces only what follows the equals sign";
    const std::string folder = example("column") + "/";
    EXPECT_EQ(offered_in_bash("quicksand run " + folder, folder), folder + "scene.toml\n");
}

} // namespace

} // namespace quicksand
