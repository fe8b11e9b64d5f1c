#include "io/pictures/picture_canvas.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"

#include <cairo/cairo.h>

#include <numbers>
#include <span>

namespace quicksand {
namespace {

constexpr const char* typeface = "DejaVu Sans";

void use_colour(cairo_t* context, const Colour& colour)
{
    cairo_set_source_rgb(context, colour.red, colour.green, colour.blue);
}

void use_font(cairo_t* context, const TextStyle& style)
{
    cairo_select_font_face(context, typeface, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, style.size);
}

void trace(cairo_t* context, std::span<const PixelPoint> corners)
{
    cairo_move_to(context, corners[0].x, corners[0].y);
    for (const PixelPoint& corner : corners.subspan(1)) cairo_line_to(context, corner.x, corner.y);
    cairo_close_path(context);
}

double shift_across(AlignX align, double width)
{
    if (align == AlignX::left) return 0.0;
    return align == AlignX::centre ? -0.5 * width : -width;
}

double shift_along(AlignY align, const cairo_font_extents_t& font)
{
    // Digits and capitals reach up to about three quarters of the font's ascent.
    const double capital_height = 0.77 * font.ascent;
    switch (align) {
    case AlignY::top:
        return capital_height;
    case AlignY::centre:
        return 0.5 * capital_height;
    case AlignY::bottom:
        return -font.descent;
    case AlignY::baseline:
        break;
    }
    return 0.0;
}

} // namespace

void Canvas::Release::operator()(cairo_t* context) const
{
    cairo_destroy(context);
}
void Canvas::Release::operator()(cairo_surface_t* surface) const
{
    cairo_surface_destroy(surface);
}

Canvas::Canvas(int width, int height)
    : width_(width), height_(height), surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_.get()))
{
    const cairo_status_t status = cairo_status(context_.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw FileError({}, "cannot draw a picture", cairo_status_to_string(status), "");
    use_colour(context_.get(), {1.0, 1.0, 1.0});
    cairo_paint(context_.get());
    cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Canvas::fill_seamless(const PixelPolygon& polygon, const Colour& colour)
{
    cairo_t* context = context_.get();
    cairo_set_antialias(context, CAIRO_ANTIALIAS_NONE);
    use_colour(context, colour);
    trace(context, polygon);
    cairo_fill_preserve(context);
    cairo_set_line_width(context, 1.0);
    cairo_stroke(context);
    cairo_set_antialias(context, CAIRO_ANTIALIAS_DEFAULT);
}

void Canvas::draw_union_outline(const std::vector<PixelPolygon>& polygons, const Colour& colour,
                                double line_width)
{
    // Every polygon is outlined broadly on a transparent sheet; then all insides are wiped out again. What is
    // left is a band around the union, whether or not neighbours share whole edges. The sheet is finer than
    // the picture and unsmoothed: smoothed strokes would add up where they meet.
    const double fineness = 3.0;
    const double gap = 1.0; // hairline gaps between neighbours are closed by the wiping [pixel]
    const std::unique_ptr<cairo_surface_t, Release> sheet(cairo_image_surface_create(
        CAIRO_FORMAT_A8, static_cast<int>(fineness) * width_, static_cast<int>(fineness) * height_));
    const std::unique_ptr<cairo_t, Release> pen(cairo_create(sheet.get()));
    cairo_scale(pen.get(), fineness, fineness);
    cairo_set_antialias(pen.get(), CAIRO_ANTIALIAS_NONE);
    cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(pen.get(), gap + 2.0 * line_width);
    for (const PixelPolygon& polygon : polygons) {
        trace(pen.get(), polygon);
        cairo_stroke(pen.get());
    }
    cairo_set_operator(pen.get(), CAIRO_OPERATOR_DEST_OUT);
    cairo_set_line_width(pen.get(), gap);
    for (const PixelPolygon& polygon : polygons) {
        trace(pen.get(), polygon);
        cairo_fill_preserve(pen.get());
        cairo_stroke(pen.get());
    }
    cairo_save(context_.get());
    cairo_scale(context_.get(), 1.0 / fineness, 1.0 / fineness);
    use_colour(context_.get(), colour);
    cairo_mask_surface(context_.get(), sheet.get(), 0.0, 0.0);
    cairo_restore(context_.get());
}

void Canvas::fill_box(const PixelBox& box, const Colour& colour)
{
    use_colour(context_.get(), colour);
    cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
    cairo_fill(context_.get());
}

void Canvas::stroke_box(const PixelBox& box, const Colour& colour, double line_width)
{
    use_colour(context_.get(), colour);
    cairo_set_line_width(context_.get(), line_width);
    cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
    cairo_stroke(context_.get());
}

void Canvas::fill_triangle(const std::array<PixelPoint, 3>& corners, const Colour& colour)
{
    use_colour(context_.get(), colour);
    trace(context_.get(), corners);
    cairo_fill(context_.get());
}

void Canvas::draw_line(const PixelPoint& from, const PixelPoint& to, const Colour& colour, double line_width)
{
    use_colour(context_.get(), colour);
    cairo_set_line_width(context_.get(), line_width);
    cairo_move_to(context_.get(), from.x, from.y);
    cairo_line_to(context_.get(), to.x, to.y);
    cairo_stroke(context_.get());
}

void Canvas::write(const std::string& text, const PixelPoint& at, const TextStyle& style)
{
    cairo_t* context = context_.get();
    use_font(context, style);
    cairo_font_extents_t font;
    cairo_font_extents(context, &font);
    cairo_save(context);
    cairo_translate(context, at.x, at.y);
    if (style.upwards) cairo_rotate(context, -0.5 * std::numbers::pi);
    cairo_move_to(context, shift_across(style.across, text_width(text, style)),
                  shift_along(style.along, font));
    use_colour(context, style.colour);
    cairo_show_text(context, text.c_str());
    cairo_restore(context);
    cairo_new_path(context);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) const
{
    use_font(context_.get(), style);
    cairo_text_extents_t extents;
    cairo_text_extents(context_.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::clip(const PixelBox& box)
{
    cairo_save(context_.get());
    cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
    cairo_clip(context_.get());
}

void Canvas::unclip()
{
    cairo_restore(context_.get());
}

void Canvas::save(const std::filesystem::path& file) const
{
    const std::filesystem::path temporary = temporary_name(file);
    const cairo_status_t status = cairo_surface_write_to_png(surface_.get(), temporary.c_str());
    if (status != CAIRO_STATUS_SUCCESS) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw FileError(file, "cannot write the picture", cairo_status_to_string(status), "");
    }
    replace_file(file);
}

} // namespace quicksand
