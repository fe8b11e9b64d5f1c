// A sheet to draw on, in pixels from the upper left corner, that is saved as a PNG. A thin layer over Cairo.
#pragma once

#include "io/pictures/colour_map.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace quicksand {

/// A place on the sheet [pixel].
struct PixelPoint {
    double x = 0.0, y = 0.0;
};

using PixelPolygon = std::vector<PixelPoint>;

struct PixelBox {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0; // [pixel]
    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

enum class AlignX { left, centre, right };
enum class AlignY { top, centre, baseline, bottom };

/// How text stands at its point.
struct TextStyle {
    double size = 17.0; // [pixel]
    AlignX across = AlignX::left;
    AlignY along = AlignY::baseline;
    Colour colour{0.1, 0.1, 0.1};
    bool bold = false;
    bool upwards = false; // turned by 90 degrees, reading from below
};

class Canvas {
public:
    /// A white sheet. Throws FileError when there is no memory for it.
    Canvas(int width, int height);

    /// Fill and outline in the same colour, unsmoothed, so that no seam shows between neighbours.
    void fill_seamless(const PixelPolygon& polygon, const Colour& colour);
    /// The outline of the union of the polygons, just outside of it.
    void draw_union_outline(const std::vector<PixelPolygon>& polygons, const Colour& colour,
                            double line_width);
    void fill_box(const PixelBox& box, const Colour& colour);
    void stroke_box(const PixelBox& box, const Colour& colour, double line_width);
    void fill_triangle(const std::array<PixelPoint, 3>& corners, const Colour& colour);
    void draw_line(const PixelPoint& from, const PixelPoint& to, const Colour& colour, double line_width);
    void write(const std::string& text, const PixelPoint& at, const TextStyle& style);
    /// Length of the text as written [pixel].
    double text_width(const std::string& text, const TextStyle& style) const;
    /// Limit drawing to the box until `unclip`.
    void clip(const PixelBox& box);
    void unclip();

    /// Write the PNG under a temporary name, then rename. Throws FileError.
    void save(const std::filesystem::path& file) const;

private:
    struct Release {
        void operator()(cairo_t* context) const;
        void operator()(cairo_surface_t* surface) const;
    };
    int width_, height_;
    std::unique_ptr<cairo_surface_t, Release> surface_;
    std::unique_ptr<cairo_t, Release> context_;
};

} // namespace quicksand
