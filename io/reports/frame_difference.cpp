#include "io/reports/frame_difference.hpp"

#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture.hpp"
#include "io/pictures/picture_field.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/results/result_reader.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// The frame nearest to the time, or the last.
ParticleFrame read_nearest(const fs::path& results, const std::optional<double>& time)
{
    const std::vector<FrameEntry> entries = particle_frames(results);
    auto chosen = std::prev(entries.end());
    if (time)
        chosen = std::min_element(entries.begin(), entries.end(), [&](const auto& a, const auto& b) {
            return std::abs(a.time - *time) < std::abs(b.time - *time);
        });
    return read_particle_frame(chosen->file);
}

/// Places in the frame by the particles' lasting numbers.
std::map<double, std::size_t> places_of(const ParticleFrame& frame)
{
    std::map<double, std::size_t> places;
    const std::vector<double>& numbers = frame.scalars.at("particle_id");
    for (std::size_t p = 0; p < numbers.size(); ++p) places[numbers[p]] = p;
    return places;
}

double extent_of(const ParticleFrame& frame)
{
    double lower = INFINITY, upper = -INFINITY;
    for (const DomainCorners& domain : frame.domains)
        for (const Vector2& corner : domain) {
            lower = std::min(lower, corner.x());
            upper = std::max(upper, corner.x());
        }
    return upper - lower;
}

/// Whether two runs start with the same particles: so many, and each where the other has it, up to what they
/// have moved before their first frames.
bool same_particles(const ParticleFrame& a, const ParticleFrame& b)
{
    constexpr double tolerance = 1e-3; // of the width of the soil [-]
    const auto places = places_of(b);
    if (a.domains.size() != b.domains.size()) return false;
    const double allowed = tolerance * extent_of(a);
    const std::vector<double>& numbers = a.scalars.at("particle_id");
    for (std::size_t p = 0; p < a.domains.size(); ++p) {
        const auto found = places.find(numbers[p]);
        if (found == places.end() || a.domains[p].empty() || b.domains[found->second].empty()) return false;
        if ((a.domains[p].front() - b.domains[found->second].front()).norm() > allowed) return false;
    }
    return true;
}

/// Values of the second frame less those of the first, in the order of the first; NaN where one has none.
std::vector<double> difference_of(const DrawnField& first, const ParticleFrame& first_frame,
                                  const DrawnField& second, const ParticleFrame& second_frame)
{
    const auto places = places_of(second_frame);
    const std::vector<double>& numbers = first_frame.scalars.at("particle_id");
    std::vector<double> values;
    for (std::size_t p = 0; p < numbers.size(); ++p) {
        const auto found = places.find(numbers[p]);
        values.push_back(found == places.end() ? NAN : second.values[found->second] - first.values[p]);
    }
    return values;
}

} // namespace

std::vector<Drawing> difference_drawings(const FrameDifference& difference, const fs::path& folder,
                                         std::string& why)
{
    const ParticleFrame first = read_nearest(difference.first, difference.time);
    const ParticleFrame second = read_nearest(difference.second, difference.time);
    if (!same_particles(read_first_frame(difference.first), read_first_frame(difference.second))) {
        why = "their particles do not start at the same places";
        return {};
    }
    if (difference.fields.size() == 1 && !drawn_field(first, difference.fields.front()))
        throw InputError(fmt::format("there is no field '{}' in the results. Available: {}",
                                     difference.fields.front(), fmt::join(drawable_fields(first), ", ")));
    std::vector<Drawing> drawings;
    for (const std::string& field : difference.fields) {
        const auto a = drawn_field(first, field), b = drawn_field(second, field);
        if (!a || !b) continue;
        FieldPicture picture;
        picture.domains = first.domains;
        picture.values = difference_of(*a, first, *b, second);
        picture.quantity = "Difference: " + a->label;
        picture.unit = a->unit;
        picture.title = difference.names;
        if (first.time != second.time)
            picture.note = fmt::format("t = {:g} s less t = {:g} s", second.time, first.time);
        picture.time = first.time;
        picture.colours = ColourMap::diverging;
        drawings.push_back(field_drawing(picture, folder / ("difference_" + field + ".png")));
    }
    return drawings;
}

} // namespace quicksand
