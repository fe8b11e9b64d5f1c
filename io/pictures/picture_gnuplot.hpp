// gnuplot as a child process, and the words it is told in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// One picture as gnuplot is told to draw it.
struct Drawing {
    std::filesystem::path png;
    double width = 0.0, height = 0.0; // of the sheet [pixel]
    std::string commands;             // places are X(pixels from the left) and Y(pixels from the top)
};

/// A place on the sheet, from its upper left corner [pixel].
struct PixelBox {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

/// Draw all in one process, for starting it costs more than a plot of curves. A picture is replaced as a
/// whole or not at all; those drawn before one that fails stay. Throws FileError, naming the one that fails,
/// where gnuplot is missing, or fails, then with its last words, or leaves a part of a picture. Returns the
/// files made.
std::vector<std::filesystem::path> draw_pictures(const std::vector<Drawing>& drawings);

/// Text in gnuplot's single quotes, on one line.
std::string gnuplot_text(const std::string& text);

/// "NaN" leaves a gap.
std::string gnuplot_number(double value);

/// Write a text on the sheet, ranged left unless the style says else.
std::string label_at(double left, double top, const std::string& text, const std::string& style);

/// Let the axes fill the box.
std::string axes_in(const PixelBox& box);

} // namespace quicksand
