#include "app/stress/scenes/section_draft.hpp"

#include "app/stress/scenes/scene_draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace quicksand {

int SectionDraft::point_at(const Vector2& place)
{
    for (std::size_t k = 0; k < points_.size(); ++k)
        if (points_[k] == place) return static_cast<int>(k) + 1;
    points_.push_back(place);
    return static_cast<int>(points_.size());
}

/// Its number, negative where it was drawn the other way.
int SectionDraft::line_between(int first, int last, const std::string& curve)
{
    for (std::size_t k = 0; k < lines_.size(); ++k) {
        if (lines_[k] == std::pair(first, last)) return static_cast<int>(k) + 1;
        if (lines_[k] == std::pair(last, first)) return -static_cast<int>(k) - 1;
    }
    lines_.emplace_back(first, last);
    const int number = static_cast<int>(lines_.size());
    if (!curve.empty()) curves_[curve].push_back(number);
    return number;
}

void SectionDraft::add_region(const std::string& name, const std::vector<DraftCorner>& corners)
{
    std::vector<int> loop;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const int first = point_at(corners[k].at);
        const int last = point_at(corners[(k + 1) % corners.size()].at);
        if (first != last) loop.push_back(line_between(first, last, corners[k].curve));
    }
    loops_.push_back(std::move(loop));
    regions_.push_back(name);
}

std::string SectionDraft::text() const
{
    std::string text = "// A section of quicksand stress, in metres.\n";
    for (std::size_t k = 0; k < points_.size(); ++k)
        text += fmt::format("Point({}) = {{{}, {}, 0}};\n", k + 1, draft_number(points_[k].x()),
                            draft_number(points_[k].y()));
    for (std::size_t k = 0; k < lines_.size(); ++k)
        text += fmt::format("Line({}) = {{{}, {}}};\n", k + 1, lines_[k].first, lines_[k].second);
    for (std::size_t k = 0; k < loops_.size(); ++k)
        text += fmt::format("Curve Loop({0}) = {{{1}}};\nPlane Surface({0}) = {{{0}}};\n", k + 1,
                            fmt::join(loops_[k], ", "));
    std::map<std::string, std::vector<std::size_t>> surfaces;
    for (std::size_t k = 0; k < regions_.size(); ++k) surfaces[regions_[k]].push_back(k + 1);
    for (const auto& [name, numbers] : surfaces)
        text += fmt::format("Physical Surface(\"{}\") = {{{}}};\n", name, fmt::join(numbers, ", "));
    for (const auto& [name, numbers] : curves_)
        text += fmt::format("Physical Curve(\"{}\") = {{{}}};\n", name, fmt::join(numbers, ", "));
    return text;
}

SectionDraft draft_rectangle(double left, double lower, double right, double upper)
{
    SectionDraft section;
    section.add_region("soil", {{{left, lower}, "base"},
                                {{right, lower}, "right"},
                                {{right, upper}, "surface"},
                                {{left, upper}, "left"}});
    return section;
}

} // namespace quicksand
