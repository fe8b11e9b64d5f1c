#include "io/pictures/picture.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>

namespace quicksand {

using fixtures::TemporaryFolder;

namespace {

DomainCorners square(double x, double y, double size)
{
    return {Vector2(x, y), Vector2(x + size, y), Vector2(x + size, y + size), Vector2(x, y + size)};
}

/// Two unit squares side by side, the left one with the value 0, the right one with 8000.
FieldPicture two_particles()
{
    FieldPicture picture;
    picture.domains = {square(0.0, 0.0, 1.0), square(1.0, 0.0, 1.0)};
    picture.values = {0.0, 8000.0};
    picture.quantity = "Excess pore pressure";
    picture.unit = "Pa";
    picture.range = PlotRange{0.0, 8000.0};
    return picture;
}

/// A place on the sheet, from its upper left corner [pixel].
struct Pixel {
    double x = 0.0, y = 0.0;
};

Pixel place(const PictureLayout& layout, const Vector2& point)
{
    return {layout.axes.left + (point.x() - layout.x.low) / layout.x.width() * layout.axes.width,
            layout.axes.bottom() - (point.y() - layout.y.low) / layout.y.width() * layout.axes.height};
}

/// A PNG read back.
class Pixels {
public:
    explicit Pixels(const std::filesystem::path& file)
    {
        reader_->SetFileName(file.c_str());
        reader_->Update();
    }
    int width() const { return reader_->GetOutput()->GetDimensions()[0]; }
    int height() const { return reader_->GetOutput()->GetDimensions()[1]; }
    std::string at(const Pixel& pixel) const
    {
        const int column = static_cast<int>(pixel.x), row = height() - 1 - static_cast<int>(pixel.y);
        const auto part = [&](int component) {
            return reader_->GetOutput()->GetScalarComponentAsDouble(column, row, 0, component) / 255.0;
        };
        return hex_code({part(0), part(1), part(2)});
    }

private:
    vtkNew<vtkPNGReader> reader_;
};

Pixels drawn(const FieldPicture& picture, const TemporaryFolder& folder)
{
    draw_pictures({field_drawing(picture, folder / "field.png")});
    return Pixels(folder / "field.png");
}

} // namespace

TEST(FieldPicture, PutsTheExtremeColoursAtTheRightPlaces)
{
    const TemporaryFolder folder;
    const FieldPicture picture = two_particles();
    const Pixels pixels = drawn(picture, folder);
    const PictureLayout layout = lay_out_picture(picture);
    EXPECT_EQ(pixels.width(), layout.width);
    EXPECT_EQ(pixels.height(), layout.height);
    for (const double y : {0.02, 0.5, 0.98}) {
        EXPECT_EQ(pixels.at(place(layout, {0.02, y})), "#440154");
        EXPECT_EQ(pixels.at(place(layout, {0.98, y})), "#440154");
        EXPECT_EQ(pixels.at(place(layout, {1.02, y})), "#fde725");
        EXPECT_EQ(pixels.at(place(layout, {1.98, y})), "#fde725");
    }
    EXPECT_EQ(pixels.at(place(layout, {-0.03, 0.5})), "#ffffff");
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(FieldPicture, ShowsNoSeamBetweenNeighbours)
{
    const TemporaryFolder folder;
    FieldPicture picture = two_particles();
    // A gap of a thousandth of the domains, as volume corrections leave it.
    picture.domains[1] = square(1.001, 0.0, 1.0);
    picture.values = {8000.0, 8000.0};
    const Pixels pixels = drawn(picture, folder);
    const PictureLayout layout = lay_out_picture(picture);
    const Pixel seam = place(layout, {1.0005, 0.5});
    for (double x = seam.x - 4.0; x < seam.x + 4.0; x += 1.0) {
        const std::string colour = pixels.at({x, seam.y});
        EXPECT_TRUE(colour == "#fde725" || colour == "#fce725") << colour; // blending rounds
    }
}

TEST(FieldPicture, OutlinesTheInitialShapeAndGreysTheUndefined)
{
    const TemporaryFolder folder;
    FieldPicture picture = two_particles();
    picture.values[0] = std::nan("");
    picture.initial_domains = picture.domains;
    for (DomainCorners& domain : picture.domains)
        for (Vector2& corner : domain) corner.y() *= 0.8;
    const Pixels pixels = drawn(picture, folder);
    const PictureLayout layout = lay_out_picture(picture);
    EXPECT_EQ(pixels.at(place(layout, {0.5, 0.4})), hex_code(undefined_colour));
    EXPECT_EQ(pixels.at(place(layout, {0.5, 0.9})), "#ffffff");
    // Nothing is drawn where the two squares meet above the settled ones.
    EXPECT_EQ(pixels.at(place(layout, {1.0, 0.9})), "#ffffff");
    const Pixel top = place(layout, {0.5, 1.0});
    EXPECT_NE(pixels.at(top), "#ffffff");
}

TEST(FieldPicture, SizeFollowsTheSection)
{
    FieldPicture picture = two_particles();
    const PictureLayout flat = lay_out_picture(picture);
    EXPECT_EQ(flat.width, 1600);
    EXPECT_LE(flat.height, 900);
    picture.domains = {square(0.0, 0.0, 1.0), square(0.0, 9.0, 1.0)};
    const PictureLayout tall = lay_out_picture(picture);
    EXPECT_LT(tall.width, 900);
    EXPECT_EQ(tall.height, 900);
    // A metre is as long in x as in y.
    const Pixel origin = place(tall, {0.0, 0.0}), one = place(tall, {1.0, 1.0});
    EXPECT_NEAR(one.x - origin.x, origin.y - one.y, 1e-9);
}

TEST(ColourRange, IsRoundFromZeroSymmetricWhereSignedAndSparesStrays)
{
    FieldPicture picture = two_particles();
    picture.range.reset();
    picture.values = {10.0, 8937.0};
    EXPECT_DOUBLE_EQ(choose_colour_range(picture).limits.low, 0.0);
    EXPECT_DOUBLE_EQ(choose_colour_range(picture).limits.high, 9000.0);

    picture.colours = ColourMap::diverging;
    picture.values = {-0.031, 0.011};
    EXPECT_DOUBLE_EQ(choose_colour_range(picture).limits.low, -0.035);
    EXPECT_DOUBLE_EQ(choose_colour_range(picture).limits.high, 0.035);

    picture.colours = ColourMap::sequential;
    picture.values.assign(1000, 0.0);
    for (std::size_t k = 0; k < picture.values.size(); ++k)
        picture.values[k] = static_cast<double>(k) / 999.0;
    picture.values.back() = 1e6;
    const ColourRange range = choose_colour_range(picture);
    EXPECT_DOUBLE_EQ(range.limits.high, 1.0);
    EXPECT_TRUE(range.beyond_high);
    EXPECT_FALSE(range.beyond_low);
}

TEST(FieldPicture, HasAxesInMetresAndABarInTheUnitShown)
{
    FieldPicture picture = two_particles();
    picture.range = PlotRange{-2000.0, 8000.0};
    picture.values = {-3000.0, 9000.0};
    picture.title = "the dike's toe";
    picture.note = "displacements × 20";
    picture.time = 1.25;
    const std::string commands = field_drawing(picture, "field.png").commands;
    for (const char* words :
         {"'x [m]'", "'y [m]'", "'Excess pore pressure [kPa]'", "'Excess pore pressure'", "'t = 1.25 s'",
          "'the dike''s toe  ·  displacements × 20'", "set cbrange [-2:8]", "set cbtics 1 ", "set xtics 0.2 ",
          "set format x '%.1f'", "0 '#440154'", "32 '#fde725'"}) {
        EXPECT_NE(commands.find(words), std::string::npos) << words;
    }
    const auto ends = [](const std::string& text) {
        return text.find("object polygon") != std::string::npos;
    };
    EXPECT_TRUE(ends(commands)); // values lie beyond the bar
    EXPECT_FALSE(ends(field_drawing(two_particles(), "field.png").commands));
    EXPECT_EQ(commands.find("initial outline"), std::string::npos);
}

TEST(FieldPicture, CutsAHeadingThatIsTooLong)
{
    FieldPicture picture = two_particles();
    picture.domains = {square(0.0, 0.0, 1.0), square(0.0, 9.0, 1.0)};
    picture.title = std::string(30, 'a');
    for (int k = 0; k < 100; ++k) picture.title += "é";
    const std::string commands = field_drawing(picture, "field.png").commands;
    EXPECT_NE(commands.find("éé…'"), std::string::npos);
}

TEST(Exaggerate, MultipliesTheDisplacementOfEveryCorner)
{
    const std::vector<DomainCorners> initial{square(0.0, 0.0, 1.0)}, present{square(0.1, -0.2, 1.0)};
    const auto drawn = exaggerate(initial, present, 10.0);
    EXPECT_NEAR(drawn[0][0].x(), 1.0, 1e-12);
    EXPECT_NEAR(drawn[0][2].y(), -1.0, 1e-12);
}

} // namespace quicksand
