#include "geometry/geo_script.hpp"
#include "solver/failure.hpp"
#include "tests/unit/geometry/scratch_files.hpp"

namespace quicksand {
namespace {

TEST(GeoScript, BlanksCommentsAndStringsInPlace)
{
    EXPECT_EQ(blank_comments_and_strings("a // b\nc"), "a     \nc");
    EXPECT_EQ(blank_comments_and_strings("a /* b\nc */ d"), "a     \n     d");
    EXPECT_EQ(blank_comments_and_strings("f(\"// x\"); g"), "f(\"    \"); g");
}

TEST(GeoScript, ListsDeclaredParametersOfIncludedFilesToo)
{
    const ScratchFolder folder;
    folder.write("layers.geo", "If (!Exists(depth))\n depth = 3;\nEndIf\n");
    const auto file =
        folder.write("dike.geo", "DefineConstant[ width = {2, Min 1, Name \"a,b\"}, height = Max(1, 2) ];\n"
                                 "// DefineConstant[ hidden = 1 ];\nInclude \"layers.geo\";\n");
    EXPECT_EQ(declared_parameters(file), (std::vector<std::string>{"depth", "height", "width"}));
}

TEST(GeoScript, ListsDeclaredParametersWithoutCommasBetweenThem)
{
    const ScratchFolder folder;
    const auto file =
        folder.write("column.geo", "DefineConstant[\n  width = {1, Name \"a, m\"}\n  height = {2}\n"
                                   "  depth = {1} + 2, slope = 3\n];\n");
    EXPECT_EQ(declared_parameters(file), (std::vector<std::string>{"depth", "height", "slope", "width"}));
}

class Harmless : public testing::TestWithParam<const char*> {};

TEST_P(Harmless, IsNotRefused)
{
    const ScratchFolder folder;
    EXPECT_NO_THROW(refuse_side_effects(folder.write("section.geo", GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Texts, Harmless,
                         testing::Values("// SystemCall \"ls\";\n", "Printf(\"Save > Print\");\n",
                                         "Print.Text = 1;\n", "Mesh.SaveAll = 1;\n", "Save = 3;\n",
                                         "SystemCalls = 1;\n", "Printf(\"%g\", 3 > 2);\n"));

class Harmful : public testing::TestWithParam<const char*> {};

TEST_P(Harmful, IsRefusedWithItsLine)
{
    const ScratchFolder folder;
    try {
        refuse_side_effects(folder.write("section.geo", std::string("x = 1;\n") + GetParam()));
        FAIL() << GetParam();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("section.geo:2: "), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Texts, Harmful,
                         testing::Values("SystemCall \"ls\";", "NonBlockingSystemCall \"ls\";",
                                         "System \"ls\";", "Printf(\"x\") > \"file\";",
                                         "Printf(\"(%g\", 1) >> \"file\";", "Save \"a.msh\";",
                                         "Print \"a.png\";", "OnelabRun(\"a\", \"b\");", "Parse[\"x\"];",
                                         "Plugin(MathEval).Run;", "CreateDir \"a\";",
                                         "Include StrCat(\"a\", \".geo\");"));

TEST(GeoScript, RefusesWhatAnIncludedFileWouldDo)
{
    const ScratchFolder folder;
    folder.write("inner.geo", "SystemCall \"ls\";\n");
    EXPECT_THROW(refuse_side_effects(folder.write("outer.geo", "Include \"inner.geo\";\n")), InputError);
}

} // namespace
} // namespace quicksand
