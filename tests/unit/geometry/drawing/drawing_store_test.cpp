// What is kept of a drawing is what gmsh makes of it, and nothing is taken for a drawing that differs.
#include "geometry/drawing/gmsh_file.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace quicksand {
namespace {

namespace fs = std::filesystem;

const std::string square = R"(
DefineConstant[ width = 2 ];
Point(1) = {0, 0, 0}; Point(2) = {width, 0, 0}; Point(3) = {width, 1.1, 0}; Point(4) = {0.1, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Surface("sand") = {1}; Physical Curve("top") = {3};
)";

class DrawingStored : public ::testing::Test {
protected:
    DrawingStored() { setenv(drawing_store_variable, store.c_str(), 1); }
    ~DrawingStored() override { unsetenv(drawing_store_variable); }

    Section read(const std::string& text, GmshRequest request = {})
    {
        request.file = folder / "drawing.geo";
        std::ofstream(request.file) << text;
        return read_gmsh_file(request);
    }
    long kept() const
    {
        return fs::exists(store) ? std::distance(fs::directory_iterator(store), fs::directory_iterator()) : 0;
    }
    /// Put another height into all that is kept, so that its use shows.
    void mark()
    {
        for (const fs::directory_entry& entry : fs::directory_iterator(store)) {
            std::ifstream stream(entry.path());
            std::string text(std::istreambuf_iterator<char>(stream), {});
            const std::size_t result = text.find("\"result\"");
            for (std::size_t at = text.find("1.1", result); at != std::string::npos;
                 at = text.find("1.1", at))
                text.replace(at, 3, "5.5");
            std::ofstream(entry.path()) << text;
        }
    }

    fixtures::TemporaryFolder folder;
    fs::path store = folder / "drawings";
};

TEST_F(DrawingStored, IsTakenInPlaceOfGmsh)
{
    const Section first = read(square);
    EXPECT_EQ(kept(), 1);
    const Section second = read(square);
    EXPECT_EQ(kept(), 1);
    ASSERT_EQ(second.regions.size(), 1u);
    EXPECT_EQ(second.regions[0].polygons[0].outer, first.regions[0].polygons[0].outer) << "to the last bit";
    EXPECT_EQ(second.curves[0].name, "top");
    mark();
    EXPECT_EQ(read(square).upper.y(), 5.5) << "gmsh was not asked";
}

TEST_F(DrawingStored, IsThatOfThisTextAndTheseSettingsAlone)
{
    read(square);
    mark();
    EXPECT_EQ(read("\n" + square).upper.y(), 1.1) << "another text";
    GmshRequest wider;
    wider.parameters = {{"width", 3.0}};
    EXPECT_EQ(read(square, wider).upper.y(), 1.1) << "another parameter";
    GmshRequest finer;
    finer.curve_tolerance = 1e-3;
    EXPECT_EQ(read(square, finer).upper.y(), 1.1) << "another tolerance";
    EXPECT_EQ(kept(), 4);
}

TEST_F(DrawingStored, FollowsIncludedFiles)
{
    const fs::path included = folder / "numbers.geo";
    std::ofstream(included) << "height = 1.1;\n";
    std::string text = square;
    text.replace(text.find("1.1"), 3, "height");
    text = "Include \"numbers.geo\";\n" + text;
    EXPECT_EQ(read(text).upper.y(), 1.1);
    std::ofstream(included) << "height = 1.2;\n";
    EXPECT_EQ(read(text).upper.y(), 1.2);
}

TEST_F(DrawingStored, IsNotKeptWhereItMayDiffer)
{
    read("angle = Rand(1);\n" + square);
    read("// \xe9\n" + square); // bytes that are not UTF-8
    EXPECT_THROW(read(square + "Physical Curve(\"none\") = {9};\n"), std::exception);
    EXPECT_EQ(kept(), 0);
}

TEST_F(DrawingStored, ToleratesAFolderThatIsBroken)
{
    std::ofstream(store) << "a file in its place\n";
    EXPECT_EQ(read(square).upper.y(), 1.1);
    fs::remove(store);
    read(square);
    for (const fs::directory_entry& entry : fs::directory_iterator(store)) std::ofstream(entry.path()) << "{";
    EXPECT_EQ(read(square).upper.y(), 1.1);
    EXPECT_EQ(kept(), 1);
}

} // namespace
} // namespace quicksand
