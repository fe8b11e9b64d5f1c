#include "io/element/laboratory_sheet.hpp"

#include "io/files/atomic_file.hpp"
#include "io/pictures/picture_gnuplot.hpp"

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

// On logarithmic axes the powers of ten alone are too few.
constexpr const char* round_ticks = "0.001,0.01,0.1,0.2,0.5,1,2,5,10,20,50,100,200,500,1000,2000,5000,10000";

struct Page {
    const LaboratorySheet& sheet;
    double head = 0.0, height = 0.0; // [pixel]
};

Page lay_out(const LaboratorySheet& sheet)
{
    Page page{sheet};
    page.head = title_height + detail_height * static_cast<double>(sheet.details.size()) + 20.0;
    const std::size_t cells = sheet.panels.size() + (sheet.table.empty() ? 0 : 1);
    const double rows = std::ceil(0.5 * static_cast<double>(cells));
    const double longest = panel_top + table_line * static_cast<double>(sheet.table.size() + 1);
    page.height = page.head + (rows - 1.0) * cell_height + std::max(cell_height, longest) + 10.0;
    return page;
}

struct Corner {
    double left = 0.0, top = 0.0; // of a cell [pixel]
};

Corner corner_of(std::size_t cell, const Page& page)
{
    const std::size_t column = cell % 2, row = cell / 2;
    return {margin + cell_width * static_cast<double>(column),
            page.head + cell_height * static_cast<double>(row)};
}

std::string label(int tag, const std::string& text, const Corner& at, const Page& page, const char* style)
{
    return fmt::format("set label {} {} at screen {:.5f}, screen {:.5f} left {}\n", tag, gnuplot_text(text),
                       at.left / page_width, 1.0 - at.top / page.height, style);
}

std::string rule(int tag, double from_top, const Page& page)
{
    const double y = 1.0 - from_top / page.height;
    return fmt::format(
        "set arrow {} from screen {:.5f}, screen {:.5f} to screen {:.5f}, screen {:.5f} nohead "
        "lw 1.2 lc rgb '#303030'\n",
        tag, margin / page_width, y, 1.0 - margin / page_width, y);
}

/// Heading, rules and table; drawn with the first panel.
std::string texts(const Page& page)
{
    int tag = 10;
    std::string script = label(tag++, page.sheet.title, {margin, 40.0}, page, "font ':Bold,17'");
    double top = title_height;
    for (const std::string& line : page.sheet.details) {
        script += label(tag++, line, {margin, top}, page, "font ',11' textcolor rgb '#404040'");
        top += detail_height;
    }
    script += rule(1, 60.0, page) + rule(2, page.head - 16.0, page);
    Corner at = corner_of(page.sheet.panels.size(), page);
    at.left += 24.0, at.top += panel_top;
    for (const std::string& line : page.sheet.table) {
        script += label(tag++, line, at, page, "font 'DejaVu Sans Mono,11'");
        at.top += table_line;
    }
    return script;
}

std::string data_blocks(const LaboratorySheet& sheet)
{
    std::string script;
    for (std::size_t p = 0; p < sheet.panels.size(); ++p) {
        for (std::size_t c = 0; c < sheet.panels[p].curves.size(); ++c) {
            const PlotCurve& curve = sheet.panels[p].curves[c].curve;
            script += fmt::format("$curve_{}_{} << end_of_data\n", p, c);
            for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k)
                script += gnuplot_number(curve.x[k]) + " " + gnuplot_number(curve.y[k]) + "\n";
            script += "end_of_data\n";
        }
    }
    return script;
}

std::string axis(const char* name, SheetAxis kind, const std::optional<std::pair<double, double>>& range)
{
    const bool logarithmic = kind == SheetAxis::logarithmic;
    std::string script =
        fmt::format("{} logscale {}{}\n", logarithmic ? "set" : "unset", name, logarithmic ? " 10" : "");
    const std::string limits = range ? fmt::format("{:g}:{:g}", range->first, range->second) : "*:*";
    if (logarithmic) script += fmt::format("set {}tics ({})\n", name, round_ticks);
    if (!logarithmic) script += fmt::format("set {}tics autofreq\n", name);
    return script + fmt::format("set {}range [{}] {}\n", name, limits,
                                kind == SheetAxis::downward ? "reverse" : "noreverse");
}

/// The y range: that asked for, or around the values with room above them where the key stands at the top.
std::optional<std::pair<double, double>> y_range(const SheetPanel& panel)
{
    if (panel.y_range || panel.y_axis != SheetAxis::linear || panel.key == KeyCorner::lower_right) {
        return panel.y_range;
    }
    double low = INFINITY, high = -INFINITY, names = 0.0;
    for (const SheetCurve& curve : panel.curves) {
        if (!curve.curve.name.empty()) names += 1.0;
        for (const double y : curve.curve.y) {
            if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
        }
    }
    const double span = high - low;
    if (!(span > 0.0) || names == 0.0) return std::nullopt;
    constexpr double name_height = 0.055; // of the panel
    const double room = std::min(0.6, 0.04 + name_height * names);
    return std::pair(low - 0.03 * span, high + span * room / (1.0 - room));
}

const char* corner_words(KeyCorner corner)
{
    switch (corner) {
    case KeyCorner::upper_left:
        return "top left Left reverse";
    case KeyCorner::upper_right:
        return "top right Right noreverse";
    case KeyCorner::lower_right:
        return "bottom right Right noreverse";
    }
    return "";
}

std::string style_of(const SheetCurve& curve)
{
    const std::string colour = hex_code(curve.curve.colour);
    switch (curve.mark) {
    case SheetMark::line:
        return fmt::format("lines lw 1.5 lc rgb '{}'", colour);
    case SheetMark::guide:
        return fmt::format("lines lw 1.1 dashtype 2 lc rgb '{}'", colour);
    case SheetMark::points:
        return fmt::format("points pt 4 ps 1.5 lw 1.8 lc rgb '{}'", colour);
    case SheetMark::line_with_points:
        return fmt::format("linespoints lw 1.5 pt 7 ps 0.9 lc rgb '{}'", colour);
    }
    return "";
}

std::string panel_commands(std::size_t p, const Page& page)
{
    const SheetPanel& panel = page.sheet.panels[p];
    const Corner at = corner_of(p, page);
    const double left = at.left + panel_left, top = at.top + panel_top;
    std::string script = fmt::format(
        "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset tmargin at screen {:.5f}\n"
        "set bmargin at screen {:.5f}\n",
        left / page_width, (left + panel_width) / page_width, 1.0 - top / page.height,
        1.0 - (top + panel_height) / page.height);
    script += label(1, panel.heading, {left, top - 20.0}, page, "font ':Bold,12'");
    script += axis("x", panel.x_axis, panel.x_range) + axis("y", panel.y_axis, y_range(panel));
    script += fmt::format("set xlabel {}\nset ylabel {}\n", gnuplot_text(panel.x_label),
                          gnuplot_text(panel.y_label));
    script += fmt::format("set key {} vertical samplen 1.6 spacing 1.1 opaque width 1 font ',10'\nplot ",
                          corner_words(panel.key));
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        const SheetCurve& curve = panel.curves[c];
        script += fmt::format(
            "{}$curve_{}_{} using 1:2 with {} {}", c == 0 ? "" : ", \\\n     ", p, c, style_of(curve),
            curve.curve.name.empty() ? "notitle" : "title " + gnuplot_text(curve.curve.name));
    }
    return script + "\nunset label\nunset arrow\n";
}

} // namespace

std::string sheet_script(const LaboratorySheet& sheet, const std::filesystem::path& png)
{
    const Page page = lay_out(sheet);
    std::string script = fmt::format("set encoding utf8\n"
                                     "set terminal pngcairo noenhanced size {:.0f},{:.0f} "
                                     "font 'DejaVu Sans,12' background rgb '#ffffff'\n"
                                     "set output {}\n"
                                     "set minussign\nset format '%g'\n"
                                     "set border 15 lw 1 lc rgb '#303030'\n"
                                     "set tics out nomirror scale 0.6 textcolor rgb '#1a1a1a'\n"
                                     "set grid lt 1 lw 0.7 lc rgb '#dddddd'\n",
                                     page_width, page.height, gnuplot_text(png.string()));
    script += data_blocks(sheet) + "set multiplot\n" + texts(page);
    for (std::size_t p = 0; p < sheet.panels.size(); ++p) script += panel_commands(p, page);
    return script + "unset multiplot\nunset output\n";
}

void draw_laboratory_sheets(const std::vector<SheetFile>& files)
{
    if (files.empty()) return;
    std::string script; // of one process: starting it costs more than a picture
    for (const SheetFile& file : files)
        script += sheet_script(file.sheet, temporary_name(file.png)) + "reset\n";
    run_gnuplot(script, files.front().png);
    for (const SheetFile& file : files) replace_file(file.png);
}

} // namespace quicksand
