#include "io/files/file_error.hpp"
#include "io/pictures/picture.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>

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

/// A PNG read back.
class Pixels {
public:
    explicit Pixels(const std::filesystem::path& file)
        : surface_(cairo_image_surface_create_from_png(file.c_str()), cairo_surface_destroy)
    {
    }
    int width() const { return cairo_image_surface_get_width(surface_.get()); }
    int height() const { return cairo_image_surface_get_height(surface_.get()); }
    std::string at(const PixelPoint& point) const
    {
        const auto* row =
            cairo_image_surface_get_data(surface_.get()) +
            static_cast<std::ptrdiff_t>(point.y) * cairo_image_surface_get_stride(surface_.get());
        const auto code = reinterpret_cast<const std::uint32_t*>(row)[static_cast<std::ptrdiff_t>(point.x)];
        const auto part = [code](int shift) { return static_cast<double>((code >> shift) & 0xffu) / 255.0; };
        return hex_code({part(16), part(8), part(0)});
    }

private:
    std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
};

} // namespace

TEST(FieldPicture, PutsTheExtremeColoursAtTheRightPlaces)
{
    const TemporaryFolder folder;
    const FieldPicture picture = two_particles();
    draw_field_picture(picture, folder / "two.png");
    const Pixels pixels(folder / "two.png");
    const PictureLayout layout = lay_out_picture(picture);
    EXPECT_EQ(pixels.width(), layout.width);
    EXPECT_EQ(pixels.height(), layout.height);
    for (const double y : {0.02, 0.5, 0.98}) {
        EXPECT_EQ(pixels.at(layout.place({0.02, y})), "#440154");
        EXPECT_EQ(pixels.at(layout.place({0.98, y})), "#440154");
        EXPECT_EQ(pixels.at(layout.place({1.02, y})), "#fde725");
        EXPECT_EQ(pixels.at(layout.place({1.98, y})), "#fde725");
    }
    EXPECT_EQ(pixels.at(layout.place({-0.03, 0.5})), "#ffffff");
    EXPECT_FALSE(fixtures::any_temporary_file(folder.path()));
}

TEST(FieldPicture, ShowsNoSeamBetweenNeighbours)
{
    const TemporaryFolder folder;
    FieldPicture picture = two_particles();
    // A gap of a thousandth of the domains, as volume corrections leave it.
    picture.domains[1] = square(1.001, 0.0, 1.0);
    picture.values = {8000.0, 8000.0};
    draw_field_picture(picture, folder / "seam.png");
    const Pixels pixels(folder / "seam.png");
    const PictureLayout layout = lay_out_picture(picture);
    const PixelPoint seam = layout.place({1.0005, 0.5});
    for (double x = seam.x - 4.0; x < seam.x + 4.0; x += 1.0) EXPECT_EQ(pixels.at({x, seam.y}), "#fde725");
}

TEST(FieldPicture, OutlinesTheInitialShapeAndGreysTheUndefined)
{
    const TemporaryFolder folder;
    FieldPicture picture = two_particles();
    picture.values[0] = std::nan("");
    picture.initial_domains = picture.domains;
    for (DomainCorners& domain : picture.domains)
        for (Vector2& corner : domain) corner.y() *= 0.8;
    draw_field_picture(picture, folder / "settled.png");
    const Pixels pixels(folder / "settled.png");
    const PictureLayout layout = lay_out_picture(picture);
    EXPECT_EQ(pixels.at(layout.place({0.5, 0.4})), hex_code(undefined_colour));
    EXPECT_EQ(pixels.at(layout.place({0.5, 0.9})), "#ffffff");
    // Nothing is drawn where the two squares meet above the settled ones.
    EXPECT_EQ(pixels.at(layout.place({1.0, 0.9})), "#ffffff");
    const PixelPoint top = layout.place({0.5, 1.0});
    EXPECT_NE(pixels.at({top.x, top.y - 1.0}), "#ffffff");
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
    const PixelPoint origin = tall.place({0.0, 0.0}), one = tall.place({1.0, 1.0});
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

TEST(FieldPicture, CannotBeWrittenIntoAMissingFolder)
{
    const TemporaryFolder folder;
    EXPECT_THROW(draw_field_picture(two_particles(), folder / "missing/two.png"), FileError);
}

TEST(Exaggerate, MultipliesTheDisplacementOfEveryCorner)
{
    const std::vector<DomainCorners> initial{square(0.0, 0.0, 1.0)}, present{square(0.1, -0.2, 1.0)};
    const auto drawn = exaggerate(initial, present, 10.0);
    EXPECT_NEAR(drawn[0][0].x(), 1.0, 1e-12);
    EXPECT_NEAR(drawn[0][2].y(), -1.0, 1e-12);
}

} // namespace quicksand
