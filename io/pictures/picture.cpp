#include "io/pictures/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

constexpr Colour ink{0.1, 0.1, 0.1};
constexpr Colour faint_ink{0.38, 0.38, 0.38};
constexpr Colour outline_grey{0.45, 0.45, 0.45};
constexpr double tick_length = 7.0; // [pixel]
constexpr double frame_line = 1.2;  // [pixel]

constexpr TextStyle small_text{.size = 17.0};
constexpr TextStyle axis_text{.size = 19.0};

PixelPolygon to_pixels(const PictureLayout& layout, const DomainCorners& domain)
{
    PixelPolygon polygon;
    polygon.reserve(domain.size());
    for (const Vector2& corner : domain) polygon.push_back(layout.place(corner));
    return polygon;
}

std::vector<PixelPolygon> to_pixels(const PictureLayout& layout, const std::vector<DomainCorners>& domains)
{
    std::vector<PixelPolygon> polygons;
    polygons.reserve(domains.size());
    for (const DomainCorners& domain : domains) polygons.push_back(to_pixels(layout, domain));
    return polygons;
}

void draw_section(const FieldPicture& picture, const PictureLayout& layout, const PlotRange& limits,
                  Canvas& canvas)
{
    canvas.clip(layout.axes);
    for (std::size_t p = 0; p < picture.domains.size(); ++p) {
        const double fraction = (picture.values[p] - limits.low) / limits.width();
        canvas.fill_seamless(to_pixels(layout, picture.domains[p]), map_colour(picture.colours, fraction));
    }
    canvas.draw_union_outline(to_pixels(layout, picture.initial_domains), outline_grey, 1.6);
    canvas.unclip();
}

void draw_axis_x(const PictureLayout& layout, Canvas& canvas)
{
    const double bottom = layout.axes.bottom();
    const int at_most = std::clamp(static_cast<int>(layout.axes.width / 90.0), 2, 12);
    const Ticks ticks = nice_ticks(layout.x, at_most);
    TextStyle text = small_text;
    text.across = AlignX::centre;
    text.along = AlignY::top;
    for (const double value : ticks.values) {
        const double x = std::round(layout.place({value, 0.0}).x);
        canvas.draw_line({x, bottom}, {x, bottom + tick_length}, ink, frame_line);
        canvas.write(tick_label(value, ticks.decimals), {x, bottom + 14.0}, text);
    }
    TextStyle name = axis_text;
    name.across = AlignX::centre;
    name.along = AlignY::top;
    canvas.write("x [m]", {layout.axes.left + 0.5 * layout.axes.width, bottom + 46.0}, name);
}

void draw_axis_y(const PictureLayout& layout, Canvas& canvas)
{
    const double left = layout.axes.left;
    const int at_most = std::clamp(static_cast<int>(layout.axes.height / 60.0), 2, 10);
    const Ticks ticks = nice_ticks(layout.y, at_most);
    TextStyle text = small_text;
    text.across = AlignX::right;
    text.along = AlignY::centre;
    double widest = 0.0;
    for (const double value : ticks.values) {
        const double y = std::round(layout.place({0.0, value}).y);
        canvas.draw_line({left - tick_length, y}, {left, y}, ink, frame_line);
        const std::string label = tick_label(value, ticks.decimals);
        canvas.write(label, {left - 13.0, y}, text);
        widest = std::max(widest, canvas.text_width(label, text));
    }
    TextStyle name = axis_text;
    name.across = AlignX::centre;
    name.upwards = true;
    canvas.write("y [m]", {left - 13.0 - widest - 18.0, layout.axes.top + 0.5 * layout.axes.height}, name);
}

/// Triangles at the ends of the bar tell that values lie beyond its limits.
void draw_bar_ends(const FieldPicture& picture, const PixelBox& bar, const ColourRange& range, Canvas& canvas)
{
    const double tip = 16.0;
    const double middle = bar.left + 0.5 * bar.width;
    if (range.beyond_high)
        canvas.fill_triangle({{{bar.left, bar.top}, {bar.right(), bar.top}, {middle, bar.top - tip}}},
                             map_colour(picture.colours, 1.0));
    if (range.beyond_low)
        canvas.fill_triangle(
            {{{bar.left, bar.bottom()}, {bar.right(), bar.bottom()}, {middle, bar.bottom() + tip}}},
            map_colour(picture.colours, 0.0));
}

void draw_colour_bar(const FieldPicture& picture, const PictureLayout& layout, const ColourRange& range,
                     const DisplayUnit& unit, Canvas& canvas)
{
    const PixelBox& bar = layout.colour_bar;
    const int rows = static_cast<int>(bar.height);
    for (int row = 0; row < rows; ++row) {
        const double fraction = 1.0 - (row + 0.5) / rows;
        canvas.fill_box({bar.left, bar.top + row, bar.width, 1.0}, map_colour(picture.colours, fraction));
    }
    canvas.stroke_box(bar, ink, frame_line);
    draw_bar_ends(picture, bar, range, canvas);

    const PlotRange shown{range.limits.low / unit.factor, range.limits.high / unit.factor};
    const Ticks ticks = nice_ticks(shown, std::clamp(static_cast<int>(bar.height / 50.0), 3, 11));
    TextStyle text = small_text;
    text.along = AlignY::centre;
    double widest = 0.0;
    for (const double value : ticks.values) {
        const double y = std::round(bar.bottom() - (value - shown.low) / shown.width() * bar.height);
        canvas.draw_line({bar.right(), y}, {bar.right() + tick_length, y}, ink, frame_line);
        const std::string label = tick_label(value, ticks.decimals);
        canvas.write(label, {bar.right() + 13.0, y}, text);
        widest = std::max(widest, canvas.text_width(label, text));
    }
    TextStyle name = axis_text;
    name.across = AlignX::centre;
    name.along = AlignY::top;
    name.upwards = true;
    canvas.write(label_with_unit(picture.quantity, unit),
                 {bar.right() + 13.0 + widest + 16.0, bar.top + 0.5 * bar.height}, name);
}

/// The sample line and its text, below the axes at the right.
void draw_legend(const FieldPicture& picture, const PictureLayout& layout, Canvas& canvas)
{
    if (picture.initial_domains.empty()) return;
    TextStyle text{.size = 16.0, .across = AlignX::right, .along = AlignY::top, .colour = faint_ink};
    const std::string name = "initial outline";
    const double top = layout.axes.bottom() + 47.0;
    canvas.write(name, {layout.axes.right(), top}, text);
    const double end = layout.axes.right() - canvas.text_width(name, text) - 8.0;
    canvas.draw_line({end - 30.0, top + 6.0}, {end, top + 6.0}, outline_grey, 2.0);
}

std::string time_text(double time)
{
    return fmt::format("t = {:.4g} s", time);
}

/// The text, cut with an ellipsis where it is longer than `room` pixels.
std::string fit(std::string text, double room, const TextStyle& style, const Canvas& canvas)
{
    if (canvas.text_width(text, style) <= room) return text;
    while (!text.empty() && canvas.text_width(text + "…", style) > room) {
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0u) == 0x80u) text.pop_back();
        if (!text.empty()) text.pop_back();
    }
    return text + "…";
}

void draw_heading(const FieldPicture& picture, const PictureLayout& layout, Canvas& canvas)
{
    TextStyle time{.size = 21.0, .across = AlignX::right};
    const std::string now = time_text(picture.time);
    const double right = layout.width - 20.0; // of the sheet: a narrow section leaves its title little room
    canvas.write(now, {right, 46.0}, time);

    const TextStyle heading{.size = 24.0, .bold = true};
    const double room = right - layout.axes.left - canvas.text_width(now, time) - 24.0;
    canvas.write(fit(picture.quantity, room, heading, canvas), {layout.axes.left, 46.0}, heading);

    std::string line = picture.title;
    if (!picture.note.empty()) line += (line.empty() ? "" : "  ·  ") + picture.note;
    const TextStyle note{.size = 17.0, .colour = faint_ink};
    canvas.write(fit(line, right - layout.axes.left, note, canvas), {layout.axes.left, 76.0}, note);
}

} // namespace

void draw_field_picture(const FieldPicture& picture, const std::filesystem::path& file)
{
    const PictureLayout layout = lay_out_picture(picture);
    const ColourRange range = choose_colour_range(picture);
    const double magnitude = std::max(std::abs(range.limits.low), std::abs(range.limits.high));
    const DisplayUnit unit = display_unit(picture.unit, magnitude);

    Canvas canvas(layout.width, layout.height);
    draw_section(picture, layout, range.limits, canvas);
    canvas.stroke_box(layout.axes, ink, frame_line);
    draw_axis_x(layout, canvas);
    draw_axis_y(layout, canvas);
    draw_colour_bar(picture, layout, range, unit, canvas);
    draw_legend(picture, layout, canvas);
    draw_heading(picture, layout, canvas);
    canvas.save(file);
}

} // namespace quicksand
