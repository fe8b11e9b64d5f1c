#include "io/pictures/picture.hpp"

#include "io/keys/scene_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace quicksand {
namespace {

constexpr double bar_gap = 28.0, bar_width = 26.0, bar_tip = 16.0; // [pixel]
constexpr double sheet_rim = 20.0;                                 // beside the heading [pixel]
constexpr const char* faint = "textcolor rgb '#616161'";

/// The domains whose values are defined, or those whose values are not, with the values in the unit shown.
std::string domain_block(const char* name, const FieldPicture& picture, const DisplayUnit& unit, bool defined)
{
    std::string block = fmt::format("${} << end_of_data\n", name);
    for (std::size_t p = 0; p < picture.domains.size(); ++p) {
        const double value = picture.values[p] / unit.factor;
        if (std::isfinite(value) != defined) continue;
        const std::string colour = gnuplot_number(value);
        const DomainCorners& domain = picture.domains[p];
        for (std::size_t k = 0; k <= domain.size(); ++k) { // the border ends where it begins
            const Vector2& corner = domain[k % domain.size()];
            fmt::format_to(std::back_inserter(block), "{:.7g} {:.7g} {}\n", corner.x(), corner.y(), colour);
        }
        block += "\n\n";
    }
    return block + "end_of_data\n";
}

std::string outline_block(const FieldPicture& picture, const PictureLayout& layout)
{
    std::string block = "$outline << end_of_data\n";
    const double pixel = layout.x.width() / layout.axes.width; // [m]
    for (const std::vector<Vector2>& line : outline_of(picture.initial_domains, pixel)) {
        for (const Vector2& corner : line)
            fmt::format_to(std::back_inserter(block), "{:.7g} {:.7g}\n", corner.x(), corner.y());
        block += '\n';
    }
    return block + "end_of_data\n";
}

std::string axis(const char* name, const PlotRange& range, int at_most)
{
    const Ticks ticks = nice_ticks(range, at_most);
    return fmt::format("set {0}range [{1:.9g}:{2:.9g}]\nset {0}tics {3:g} font ',13'\n"
                       "set format {0} '%.{4}f'\n",
                       name, range.low, range.high, ticks.step, ticks.decimals);
}

int ticks_along(double length, double distance, int least, int most)
{
    return std::clamp(static_cast<int>(length / distance), least, most);
}

std::string section_axes(const PictureLayout& layout)
{
    return axes_in(layout.axes) + axis("x", layout.x, ticks_along(layout.axes.width, 90.0, 2, 12)) +
           axis("y", layout.y, ticks_along(layout.axes.height, 60.0, 2, 10)) +
           "set xlabel 'x [m]' font ',14' offset 0,-0.4\nset ylabel 'y [m]' font ',14' offset -0.8,0\nunset "
           "grid\n";
}

/// A colour and a tick for each class.
std::string class_bar(const FieldPicture& picture)
{
    const int last = picture.classes - 1;
    if (last < 0) return "";
    std::string stops;
    for (int k = 0; k <= last; ++k) {
        const double place = last > 0 ? static_cast<double>(k) / last : 0.0;
        const std::string colour = hex_code(map_colour(picture.colours, place));
        stops += fmt::format("{0}{1} '{2}', {3} '{2}'", k == 0 ? "" : ", ", k, colour, k + 1);
    }
    return fmt::format("set palette defined ({})\nset cbtics 0,1,{}\nset format cb '%.0f'\n", stops, last);
}

std::string palette(ColourMap colours)
{
    constexpr int steps = 32; // of the maps' tables
    std::string stops;
    for (int k = 0; k <= steps; ++k)
        stops += fmt::format("{}{} '{}'", k == 0 ? "" : ", ", k,
                             hex_code(map_colour(colours, static_cast<double>(k) / steps)));
    return "set palette defined (" + stops + ")\n";
}

/// A triangle at an end of the bar tells that values lie beyond its limit.
std::string bar_end(const PixelBox& bar, double from, double tip, const Colour& colour)
{
    return fmt::format("set object polygon from screen X({0:g}), screen Y({1:g}) to screen X({2:g}), "
                       "screen Y({1:g}) to screen X({3:g}), screen Y({4:g}) to screen X({0:g}), "
                       "screen Y({1:g}) fillstyle solid noborder fillcolor rgb '{5}'\n",
                       bar.left, from, bar.right(), bar.left + 0.5 * bar.width, tip, hex_code(colour));
}

std::string colour_bar(const FieldPicture& picture, const PictureLayout& layout, const ColourRange& range,
                       const DisplayUnit& unit)
{
    const PixelBox bar{layout.axes.right() + bar_gap, layout.axes.top, bar_width, layout.axes.height};
    const PlotRange shown{range.limits.low / unit.factor, range.limits.high / unit.factor};
    const int at_most = ticks_along(bar.height, 50.0, 3, 11);
    const int decimals = nice_ticks(shown, at_most).decimals;
    // gnuplot leaves the ticks' labels room for few digits only.
    const std::size_t digits = std::max(fmt::formatted_size("{:.{}f}", shown.low, decimals),
                                        fmt::formatted_size("{:.{}f}", shown.high, decimals));
    std::string commands =
        palette(picture.colours) + axis("cb", shown, at_most) + class_bar(picture) +
        fmt::format("set colorbox user origin screen X({:g}), screen Y({:g}) "
                    "size screen X({:g}), screen 1.0 - Y({:g})\nset cblabel {} font ',14' offset {:.1f},0\n",
                    bar.left, bar.bottom(), bar.width, bar.height,
                    gnuplot_text(label_with_unit(picture.quantity, unit)), static_cast<double>(digits));
    if (range.beyond_high)
        commands += bar_end(bar, bar.top, bar.top - bar_tip, map_colour(picture.colours, 1.0));
    if (range.beyond_low)
        commands += bar_end(bar, bar.bottom(), bar.bottom() + bar_tip, map_colour(picture.colours, 0.0));
    return commands;
}

/// The text, cut with an ellipsis where it has more letters than `room` pixels hold.
std::string fit(const std::string& text, double room, double letter)
{
    const auto most = static_cast<std::size_t>(std::max(1.0, room / letter));
    std::size_t letters = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool begins = (static_cast<unsigned char>(text[k]) & 0xc0u) != 0x80u;
        if (begins && ++letters > most) return text.substr(0, k) + "…";
    }
    return text;
}

std::string heading(const FieldPicture& picture, const PictureLayout& layout)
{
    constexpr double bold_letter = 13.8, letter = 9.6; // mean width [pixel]
    constexpr double time_room = 140.0;
    const double left = layout.axes.left;
    const double right =
        layout.width - sheet_rim; // of the sheet: a narrow section leaves its title little room
    std::string line = picture.title;
    if (!picture.note.empty()) line += (line.empty() ? "" : "  ·  ") + picture.note;
    return label_at(right, 39.0, "t = " + time_text(picture.time), "right font ',16'") +
           label_at(left, 39.0, fit(picture.quantity, right - left - time_room, bold_letter),
                    "font ':Bold,18'") +
           label_at(left, 70.0, fit(line, right - left, letter), fmt::format("font ',13' {}", faint));
}

/// The sample of the outline and its name, below the axes at the right.
std::string legend(const PictureLayout& layout)
{
    return fmt::format("set key at screen X({:g}), screen Y({:g}) right center Left reverse samplen 2 "
                       "width -5 font ',12' {}\n",
                       layout.axes.right(), layout.axes.bottom() + 54.0, faint);
}

} // namespace

Drawing field_drawing(const FieldPicture& picture, const std::filesystem::path& file)
{
    const PictureLayout layout = lay_out_picture(picture);
    const ColourRange range = choose_colour_range(picture);
    const double magnitude = std::max(std::abs(range.limits.low), std::abs(range.limits.high));
    const DisplayUnit unit = display_unit(picture.unit, magnitude);
    // The border of a domain, in its colour, closes the gaps between neighbours.
    const std::string plots = fmt::format(
        "set style fill solid 1.0 border\n"
        "plot $undefined using 1:2 with filledcurves closed fillcolor rgb '{}' lw 1.5 notitle, \\\n"
        "     $defined using 1:2:3 with filledcurves closed fillcolor palette lw 1.5 notitle, \\\n"
        "     $outline using 1:2 with lines lw 2 lc rgb '#737373' {}\n",
        hex_code(undefined_colour), picture.initial_domains.empty() ? "notitle" : "title 'initial outline'");
    return {file, layout.width, layout.height,
            domain_block("undefined", picture, unit, false) + domain_block("defined", picture, unit, true) +
                outline_block(picture, layout) + section_axes(layout) +
                colour_bar(picture, layout, range, unit) + heading(picture, layout) + legend(layout) + plots};
}

} // namespace quicksand
