// What a user reads when a .geo or .msh file is wrong.
#include "solver/base/failure.hpp"
#include "tests/fixtures/scratch_files.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <optional>

namespace quicksand {
namespace {

const std::string square =
    R"(Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
)";
const std::string surface = "Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};\n";
const std::string named_sand = "Physical Surface(\"sand\") = {1};\n";

struct FileMistake {
    std::string name;
    std::string file; // its name in the scratch folder
    std::string text;
    std::vector<std::string> message; // parts of what must be said
    GmshRequest request = {};
};

std::string message_of(GmshRequest request)
{
    try {
        read_gmsh_file(request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "nothing";
}

void expect_parts(const std::string& message, const std::vector<std::string>& parts)
{
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "no " << part << " in\n" << message;
}

GmshRequest with_parameter(const std::string& name)
{
    GmshRequest request;
    request.parameters[name] = 2.0;
    return request;
}

GmshRequest with_limit(double seconds)
{
    GmshRequest request;
    request.time_limit = seconds;
    return request;
}

GmshRequest with_quads(double size, double time_limit = GmshRequest().time_limit)
{
    GmshRequest request = with_limit(time_limit);
    request.quad_size = size;
    return request;
}

const std::string mesh_2_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string two_nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n";
const std::string empty_groups = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 2 "base"
2 1 "sand"
$EndPhysicalNames
$Entities
2 1 1 0
1 0 0 0 0
2 1 0 0 0
1 0 0 0 1 0 0 1 2 2 1 -2
1 0 0 0 1 1 0 1 1 1 1
$EndEntities
$Nodes
1 2 1 2
2 1 0 2
1
2
0 0 0
1 0 0
$EndNodes
)";
const std::string sand_of_two_triangles = R"($PhysicalNames
1
2 1 "sand"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 1 1 0
$EndNodes
$Elements
2
1 2 2 1 1 1 2 3
2 2 2 1 1 1 2 4
$EndElements
)";

class FileMessages : public testing::TestWithParam<FileMistake> {};

TEST_P(FileMessages, SayWhatIsWrongAndWhere)
{
    const ScratchFolder folder;
    GmshRequest request = GetParam().request;
    request.file = folder.write(GetParam().file, GetParam().text);
    const std::string message = message_of(request);
    expect_parts(message, GetParam().message);
    expect_parts(message, {GetParam().file});
    if (std::getenv("QUICKSAND_SHOW_MESSAGES") != nullptr) std::cout << message << "\n";
}

INSTANTIATE_TEST_SUITE_P(
    Geo, FileMessages,
    testing::Values(
        FileMistake{"syntax",
                    "dike.geo",
                    square + "Plane Surface(1) = {1}\n" + named_sand,
                    {"'dike.geo', line 4: syntax error", "a ; missing in the line before"}},
        FileMistake{
            "unknown_variable",
            "dike.geo",
            "Point(1) = {0, hight, 0};\n",
            {"line 1: Unknown variable 'hight'", "hint: the first line is usually the cause of the others"}},
        FileMistake{"missing_curve",
                    "dike.geo",
                    square + "Curve Loop(1) = {1, 2, 4}; Plane Surface(1) = {1};\n" + named_sand,
                    {"Curve Loop 1 is wrong", "line 3"}},
        FileMistake{"unknown_curve",
                    "dike.geo",
                    square + "Curve Loop(1) = {1, 2, 3, 9}; Plane Surface(1) = {1};\n" + named_sand,
                    {"Unknown curve 9", "line 3"}},
        FileMistake{"repeated_name",
                    "dike.geo",
                    square + surface + named_sand +
                        "Physical Surface(\"sand\") += {1};\n"
                        "Physical Surface(\"sand\") = {1};\n",
                    {"already exists", "line 6"}},
        FileMistake{"empty", "dike.geo", "", {"the file is empty"}},
        FileMistake{"only_comments",
                    "dike.geo",
                    "// nothing\n",
                    {"it has no surface", "Physical Surface(\"sand\") = {1};"}},
        FileMistake{"no_physical_surface",
                    "dike.geo",
                    square + surface,
                    {"it has 1 surface(s) but no physical surface", "hint: name soil"}},
        FileMistake{"unnamed_group",
                    "dike.geo",
                    square + surface + "Physical Surface(7) = {1};\n",
                    {"Physical Surface(7) has no name", "Physical Surface(\"name\", 7) = {...};"}},
        FileMistake{"unnamed_curve",
                    "dike.geo",
                    square + surface + named_sand + "Physical Curve(3) = {1};\n",
                    {"Physical Curve(3) has no name"}},
        FileMistake{"many_unnamed_curves",
                    "dike.geo",
                    square + surface + named_sand + "For k In {1:9}\n Physical Curve(k) = {1};\nEndFor\n",
                    {"Physical Curve(6) has no name", "\n  and 3 more\nhint: name soil"}},
        FileMistake{"open_outline",
                    "dike.geo",
                    square + "Curve Loop(1) = {1, 2, 3}; Plane Surface(1) = {1};\n" + named_sand,
                    {"the outline of surface 1 is not closed: nothing goes on from (0.000000, 1.000000)"}},
        FileMistake{"group_of_nothing",
                    "dike.geo",
                    square + surface + named_sand + "Physical Curve(\"base\") = {17};\n",
                    {"Physical Curve(\"base\") is empty", "does not exist"}},
        FileMistake{"tag_too_large",
                    "dike.geo",
                    square + surface + "Physical Surface(\"sand\", 2000000000) = {1};\n",
                    {"Physical Surface(\"sand\", 2000000000) has a tag above 1000000; leave it out: "
                     "Physical Surface(\"sand\") = {...};"}},
        FileMistake{"largest_tag",
                    "dike.geo",
                    square + surface + "Physical Surface(\"sand\", 2147483647) = {1};\n",
                    {"Physical Surface(\"sand\", 2147483647) has a tag above 1000000"}},
        FileMistake{"includes_a_folder",
                    "dike.geo",
                    square + "Include \"..\";\n",
                    {"dike.geo:3: Include \"..\" is a folder or a device, not a file"}},
        FileMistake{"ends_gmsh",
                    "dike.geo",
                    "Exit;\n",
                    {"gmsh ended before the drawing was complete", "take Exit out"}},
        FileMistake{"out_of_plane",
                    "dike.geo",
                    "Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {1,0,1};\n"
                    "Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,1};\n"
                    "Curve Loop(1) = {1,2,3}; Plane Surface(1) = {1};\n" +
                        named_sand,
                    {"Physical Surface(\"sand\") leaves the plane z = 0 at (1, 0, 1)", "x and y, with y up"}},
        FileMistake{"rubbish",
                    "dike.geo",
                    std::string("\x7f"
                                "ELF\0\0\x01\x02\n",
                                9),
                    {"is not a text file"}},
        FileMistake{"starts_a_program",
                    "dike.geo",
                    square + "SystemCall \"rm -rf ~\";\n",
                    {"dike.geo:3: SystemCall starts another program", "hint: a section needs geometry only"}},
        FileMistake{"writes_a_file",
                    "dike.geo",
                    "Printf(\"x\") > \"notes.txt\";\n",
                    {"dike.geo:1: Printf with > writes a file"}},
        FileMistake{"no_line_end",
                    "dike.geo",
                    square + surface + "Physical Surface(\"sand\") = {1};",
                    {"dike.geo:4: the last line has no line end", "empty line"}},
        FileMistake{"endless_recursion",
                    "dike.geo",
                    "Macro deeper\n x = 1;\n Call deeper;\nReturn\nCall deeper;\n",
                    {"gmsh was stopped after 1 s", "loop or macro without end"},
                    with_limit(1.0)},
        FileMistake{"too_slow_when_meshed",
                    "dike.geo",
                    square + surface + named_sand,
                    {"gmsh was stopped after 1e-09 s", "loop or macro without end, or ask for larger quad"},
                    with_quads(0.1, 1e-9)},
        FileMistake{"misspelt_parameter",
                    "dike.geo",
                    "DefineConstant[ crest_width = 3, slope = 2 ];\n" + square + surface + named_sand,
                    {"declares no parameter \"crest_with\"", "did you mean \"crest_width\"?",
                     "declared: crest_width, slope"},
                    with_parameter("crest_with")},
        FileMistake{"parameter_of_none",
                    "dike.geo",
                    "width = 3;\n" + square + surface + named_sand,
                    {"declares no parameter \"width\"", "it declares none", "DefineConstant[ width = 1.0 ];"},
                    with_parameter("width")},
        FileMistake{"crossing_when_meshed",
                    "dike.geo",
                    "Point(1)={0,0,0}; Point(2)={1,0,0}; Point(3)={0,1,0}; Point(4)={1,1,0};\n"
                    "Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};\n" +
                        surface + named_sand,
                    {"cannot mesh the section", "meets itself at (0.5, 0.5)"},
                    with_quads(0.1)},
        FileMistake{"not_to_be_meshed",
                    "dike.geo",
                    square + surface + named_sand +
                        "Transfinite Curve{1} = 3; Transfinite Curve{3} = 5; Transfinite Surface{1};\n",
                    {"gmsh cannot mesh the section", "hint: try another size of the quadrilaterals"},
                    with_quads(0.3)},
        FileMistake{"hidden_when_meshed",
                    "dike.geo",
                    square + surface + named_sand + "Mesh.MeshOnlyVisible = 1; Hide { Surface{1}; }\n",
                    {"Physical Surface(\"sand\") was left without elements"},
                    with_quads(0.3)},
        FileMistake{"too_many_quads",
                    "dike.geo",
                    square + surface + named_sand,
                    {"quadrilaterals of 0.0001 m", "more than 4000000"},
                    with_quads(1e-4)}),
    [](const auto& one) { return one.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Msh, FileMessages,
    testing::Values(
        FileMistake{"not_a_mesh",
                    "dike.msh",
                    "Point(1) = {0, 0, 0};\n",
                    {"does not begin with $MeshFormat", "2.2 or 4.1"}},
        FileMistake{"rubbish", "dike.msh", std::string("\0\1\2\3", 4), {"is not a gmsh mesh"}},
        FileMistake{"truncated",
                    "dike.msh",
                    mesh_2_2 + "$Nodes\n3\n1 0 0 0\n2 1 0",
                    {"gmsh cannot read it", "is the file complete?"}},
        FileMistake{"without_elements", "dike.msh", mesh_2_2 + two_nodes, {"it has no surface"}},
        FileMistake{"without_names",
                    "dike.msh",
                    mesh_2_2 + two_nodes + "$Elements\n1\n1 2 2 5 1 1 2 3\n$EndElements\n",
                    {"Physical Surface(5) has no name"}},
        FileMistake{
            "groups_without_elements",
            "dike.msh",
            empty_groups,
            {"Physical Surface(\"sand\") has no elements",
             "Physical Curve(\"base\") has no line elements; save the mesh with its physical curves"}},
        FileMistake{"overlapping_elements",
                    "dike.msh",
                    mesh_2_2 + sand_of_two_triangles,
                    {"the elements of \"sand\" have no closed outline"}},
        FileMistake{
            "parameter", "dike.msh", mesh_2_2, {"declares no parameter \"width\""}, with_parameter("width")},
        FileMistake{
            "other_format", "dike.stl", "solid\n", {"a section is a .geo, .geo_unrolled or .msh file"}}),
    [](const auto& one) { return one.param.name; });

TEST(FileMessages, NameAMissingFile)
{
    GmshRequest request;
    request.file = "nowhere/dike.geo";
    expect_parts(message_of(request), {"nowhere/dike.geo: there is no such file"});
}

TEST(FileMessages, NameADevice)
{
    GmshRequest request;
    request.file = "/dev/null";
    expect_parts(message_of(request), {"/dev/null: is not a regular file"});
}

TEST(FileMessages, NameAFolder)
{
    const ScratchFolder folder;
    GmshRequest request;
    request.file = folder.path();
    expect_parts(message_of(request), {folder.path().string(), "is a folder, not a .geo or .msh file"});
}

/// While it lives, another folder takes the temporary files and none of them can grow beyond `bytes`.
class ScratchLimits {
public:
    ScratchLimits(const std::string& folder, rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        getrlimit(RLIMIT_FSIZE, &former_);
        const rlimit limit{bytes, former_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
        if (const char* former = std::getenv("TMPDIR")) former_folder_ = former;
        setenv("TMPDIR", folder.c_str(), 1);
    }
    ~ScratchLimits()
    {
        if (former_folder_) {
            setenv("TMPDIR", former_folder_->c_str(), 1);
        } else {
            unsetenv("TMPDIR");
        }
        setrlimit(RLIMIT_FSIZE, &former_);
        std::signal(SIGXFSZ, handler_);
    }
    ScratchLimits(const ScratchLimits&) = delete;
    ScratchLimits& operator=(const ScratchLimits&) = delete;

private:
    void (*handler_)(int);
    rlimit former_{};
    std::optional<std::string> former_folder_;
};

/// What is said of a good drawing in `folder` when the temporary folder is at fault.
std::string message_of_disk(const ScratchFolder& folder, const std::string& temporary_folder, rlim_t bytes)
{
    GmshRequest request;
    request.file = folder.write("dike.geo", square + surface + named_sand);
    const ScratchLimits limits(temporary_folder, bytes);
    try {
        read_gmsh_file(request);
    } catch (const FileError& error) {
        return error.what();
    }
    return "nothing";
}

TEST(FileMessages, TakeAFullTemporaryFolderForADiskFault)
{
    const ScratchFolder folder;
    const std::string path = folder.path().string();
    expect_parts(message_of_disk(folder, path, 16),
                 {path + "/quicksand-gmsh-",
                  "gmsh gave no result for " + path + "/dike.geo (exit code 1): is " + path + " full?"});
}

TEST(FileMessages, TakeATemporaryFolderThatCannotBeWrittenForADiskFault)
{
    const ScratchFolder folder;
    expect_parts(message_of_disk(folder, "/proc", RLIM_INFINITY),
                 {"/proc: no scratch file can be made here: "});
}

TEST(FileMessages, NameATruncatedFixture)
{
    const ScratchFolder folder;
    for (const char* name : {"slope_22.msh", "slope_41.msh", "slope_41_binary.msh"}) {
        std::ifstream stream(fixture(name), std::ios::binary);
        const std::string whole(std::istreambuf_iterator<char>(stream), {});
        for (const double fraction : {0.3, 0.6, 0.9}) {
            GmshRequest request;
            const auto length = static_cast<std::size_t>(fraction * static_cast<double>(whole.size()));
            request.file = folder.write(name, whole.substr(0, length));
            expect_parts(message_of(request), {name, "hint: "});
        }
    }
}

} // namespace
} // namespace quicksand
