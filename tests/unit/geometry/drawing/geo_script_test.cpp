#include "geometry/drawing/geo_script.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/scratch_files.hpp"

namespace quicksand {
namespace {

TEST(GeoScript, BlanksCommentsAndStringsInPlace)
{
    EXPECT_EQ(blank_comments_and_strings("a // b\nc"), "a     \nc");
    EXPECT_EQ(blank_comments_and_strings("a /* b\nc */ d"), "a     \n     d");
    EXPECT_EQ(blank_comments_and_strings("f(\"// x\"); g"), "f(\"    \"); g");
    EXPECT_EQ(blank_comments_and_strings("a = '\"'; b = \"'\"; c"), "a = ' '; b = \" \"; c");
}

std::string message_of(const std::filesystem::path& file)
{
    try {
        refuse_side_effects(file);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing";
}

std::string refusal(const std::filesystem::path& file, const std::string& what)
{
    return file.string() + ":" + what +
           "; Quicksand refuses to open the file\nhint: a section needs geometry only; take the line out";
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
                                         "SystemCalls = 1;\n", "Printf(\"%g\", 3 > 2);\n",
                                         "a = 'SystemCall';\n", "ExternalProcess = 3;\n",
                                         "Merge \"nowhere.geo\";\n"));

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
                                         "Include StrCat(\"a\", \".geo\");", "a = '\"'; SystemCall \"ls\";",
                                         "a = \"'\"; SystemCall 'ls';", "Field[1] = ExternalProcess;",
                                         "Include \"/dev\";", "Merge '/dev/null';"));

TEST(GeoScript, RefusesWhatAnIncludedFileWouldDo)
{
    const ScratchFolder folder;
    folder.write("inner.geo", "SystemCall \"ls\";\n");
    EXPECT_THROW(refuse_side_effects(folder.write("outer.geo", "Include \"inner.geo\";\n")), InputError);
    EXPECT_THROW(refuse_side_effects(folder.write("quoted.geo", "Include 'inner.geo';\n")), InputError);
}

TEST(GeoScript, SaysWhatACommandWouldDo)
{
    const ScratchFolder folder;
    const std::pair<const char*, const char*> commands[] = {
        {"Plugin(MathEval).Run;\n", "1: Plugin may write files"},
        {"Parse[\"x\"];\n", "1: Parse runs text that cannot be looked at beforehand"},
        {"Save \"a.msh\";\n", "1: Save writes a file"},
        {"CreateDir \"a\";\n", "1: CreateDir makes a folder"}};
    for (const auto& [text, what] : commands) {
        const auto file = folder.write("dike.geo", text);
        EXPECT_EQ(message_of(file), refusal(file, what));
    }
}

TEST(GeoScript, CannotFollowAFileNamedByAnExpression)
{
    const ScratchFolder folder;
    const auto file = folder.write("dike.geo", "Include StrCat(\"a\", \".geo\");\n");
    EXPECT_EQ(message_of(file), file.string() +
                                    ":1: Include names its file by an expression, which cannot be followed\n"
                                    "hint: write the file's name itself: Include \"layers.geo\";");
}

TEST(GeoScript, KnowsStringsInSingleQuotes)
{
    const ScratchFolder folder;
    const auto file = folder.write("dike.geo", "a = '\"';\nSystemCall \"ls\";\n");
    EXPECT_EQ(message_of(file), refusal(file, "2: SystemCall starts another program"));
}

TEST(GeoScript, RefusesAFieldThatStartsAProgram)
{
    const ScratchFolder folder;
    const auto file =
        folder.write("dike.geo", "Field[1] = ExternalProcess;\nField[1].CommandLine = \"ls\";\n");
    EXPECT_EQ(message_of(file), refusal(file, "1: ExternalProcess starts another program"));
}

TEST(GeoScript, TakesAnIncludedFileForAScriptWhateverItLooksLike)
{
    const ScratchFolder folder;
    const auto mesh = folder.write("mesh.geo", "$MeshFormat\n;SystemCall \"ls\";\n");
    const auto drawing = folder.write("part.step", "SystemCall \"ls\";\n");
    EXPECT_EQ(message_of(folder.write("merging.geo", "Merge \"mesh.geo\";\nMerge \"part.step\";\n")),
              "nothing");
    EXPECT_EQ(message_of(folder.write("outer.geo", "Merge \"mesh.geo\";\nInclude \"mesh.geo\";\n")),
              refusal(mesh, "2: SystemCall starts another program"));
    EXPECT_EQ(message_of(folder.write("cad.geo", "Include \"part.step\";\n")),
              refusal(drawing, "1: SystemCall starts another program"));
}

TEST(GeoScript, TakesAMergedFileForAScriptUnlessGmshKnowsItsExtension)
{
    const ScratchFolder folder;
    const auto drawing = folder.write("part.StEp", "SystemCall \"ls\";\n");
    EXPECT_EQ(message_of(folder.write("outer.geo", "Merge \"part.StEp\";\n")),
              refusal(drawing, "1: SystemCall starts another program"));
}

TEST(GeoScript, LooksAtTheOptionsThatGmshRunsWithAFile)
{
    const ScratchFolder folder;
    for (const char* name : {"dike.geo", "dike.msh"}) {
        const auto file = folder.write(name, name == std::string("dike.msh") ? "$MeshFormat\n" : "x = 1;\n");
        EXPECT_EQ(message_of(file), "nothing");
        const auto options =
            folder.write(std::string(name) + ".opt", "Print.Text = 1;\nSystemCall \"ls\";\n");
        EXPECT_EQ(message_of(file), refusal(options, "2: SystemCall starts another program"));
    }
}

TEST(GeoScript, RefusesStringsThatGmshWouldCutOff)
{
    const ScratchFolder folder;
    const auto with_string = [&](const std::string& text) {
        return folder.write("dike.geo", "x = 1;\na = \"" + text + "\";\n");
    };
    EXPECT_EQ(message_of(with_string(std::string(1023, 'x'))), "nothing");
    const auto file = with_string(std::string(1024, 'x') + "; SystemCall 'ls'; ");
    EXPECT_EQ(message_of(file), file.string() + ":2: the string is longer than the 1023 characters of gmsh\n"
                                                "hint: is its closing quote missing?");
    EXPECT_EQ(message_of(with_string(std::string("x\0; SystemCall 'ls'; ", 21))),
              file.string() + ": is not a text file");
}

TEST(GeoScript, RefusesAFolderInPlaceOfAFile)
{
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "parts");
    const auto file = folder.write("dike.geo", "x = 1;\nInclude \"parts\";\n");
    EXPECT_EQ(message_of(file), file.string() + ":2: Include \"parts\" is a folder or a device, not a file\n"
                                                "hint: name a file, such as \"layers.geo\"");
}

} // namespace
} // namespace quicksand
