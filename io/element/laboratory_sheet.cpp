#include "io/element/laboratory_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {
namespace {

// Sizes of the page [pixel].
constexpr double page_width = 1400.0, margin = 40.0;
constexpr double title_height = 76.0, detail_height = 24.0;
constexpr double panel_width = 560.0, panel_height = 400.0, panel_left = 80.0, panel_top = 52.0;
constexpr double cell_width = 0.5 * (page_width - 2.0 * margin) + 10.0, cell_height = 520.0;
constexpr double table_line = 23.0;

/// Where the axes of a cell stand; two cells make a row.
PixelBox axes_of(std::size_t cell, double head)
{
    const auto column = static_cast<double>(cell % 2), row = static_cast<double>(cell / 2);
    return {margin + cell_width * column + panel_left, head + cell_height * row + panel_top, panel_width,
            panel_height};
}

std::string rule(double top)
{
    return fmt::format("set arrow from screen X({0:g}), screen Y({2:g}) to screen X({1:g}), screen Y({2:g}) "
                       "nohead lw 1.2 lc rgb '#303030'\n",
                       margin, page_width - margin, top);
}

/// Heading, rules and table; drawn with the first panel.
std::string texts(const LaboratorySheet& sheet, double head)
{
    std::string script = label_at(margin, 40.0, sheet.title, "font ':Bold,17'");
    double top = title_height;
    for (const std::string& line : sheet.details) {
        script += label_at(margin, top, line, "font ',11' textcolor rgb '#404040'");
        top += detail_height;
    }
    script += rule(60.0) + rule(head - 16.0);
    PixelBox place = axes_of(sheet.panels.size(), head);
    for (const std::string& line : sheet.table) {
        script += label_at(place.left - 56.0, place.top, line, "font 'DejaVu Sans Mono,11'");
        place.top += table_line;
    }
    return script;
}

} // namespace

Drawing sheet_drawing(const LaboratorySheet& sheet, const std::filesystem::path& png)
{
    const double head = title_height + detail_height * static_cast<double>(sheet.details.size()) + 20.0;
    const std::size_t cells = sheet.panels.size() + (sheet.table.empty() ? 0 : 1);
    const double rows = std::ceil(0.5 * static_cast<double>(cells));
    const double longest = panel_top + table_line * static_cast<double>(sheet.table.size() + 1);
    const double height = head + (rows - 1.0) * cell_height + std::max(cell_height, longest) + 10.0;

    std::string commands = "set multiplot\n" + texts(sheet, head);
    for (std::size_t p = 0; p < sheet.panels.size(); ++p)
        commands += panel_commands(sheet.panels[p], axes_of(p, head));
    return {png, page_width, height, commands + "unset multiplot\n"};
}

} // namespace quicksand
