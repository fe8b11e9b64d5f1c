#include "io/results/result_reader.hpp"

#include "geometry/drawing/lower_case.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_units.hpp"
#include "io/results/results_folder.hpp"
#include "io/results/stage_table.hpp"
#include "solver/base/failure.hpp"
#include "solver/measure/quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>

namespace quicksand {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// One number a tuple: a scalar array, or one component of another.
struct FieldComponent {
    std::string name; // "ru", "displacement_y", "stress_xy"
    std::string unit;
    std::size_t array = 0; // place in the frame's list
    std::size_t component = 0;
};

/// All numbers of the arrays by name; z of vectors, which is zero, is left out.
std::vector<FieldComponent> components_of(const std::vector<FrameArray>& arrays)
{
    std::vector<FieldComponent> components;
    for (std::size_t a = 0; a < arrays.size(); ++a) {
        const FrameArray& array = arrays[a];
        if (array.components.empty()) components.push_back({array.name, array.unit, a, 0});
        for (std::size_t c = 0; c < array.components.size(); ++c)
            if (array.components[c] != "Z")
                components.push_back({array.name + "_" + lower_case(array.components[c]), array.unit, a, c});
    }
    return components;
}

double value_at(const std::vector<FrameArray>& arrays, const FieldComponent& field, std::size_t tuple)
{
    const FrameArray& array = arrays[field.array];
    const std::size_t index = tuple * array.component_count() + field.component;
    return std::visit([&](const auto& values) { return static_cast<double>(values[index]); }, array.values);
}

/// The components a request names: one of them, or all of an array.
std::vector<FieldComponent> select(const std::vector<FrameArray>& arrays,
                                   const std::vector<std::string>& names)
{
    const std::vector<FieldComponent> all = components_of(arrays);
    std::vector<FieldComponent> selected;
    std::vector<std::string> known;
    for (const FrameArray& array : arrays) known.push_back(array.name);
    for (const std::string& name : names) {
        const std::size_t before = selected.size();
        std::copy_if(all.begin(), all.end(), std::back_inserter(selected), [&](const FieldComponent& field) {
            return field.name == name || arrays[field.array].name == name;
        });
        if (selected.size() == before) refuse_field(name, known);
    }
    return selected;
}

/// "displacement_y_m", "ru": the unit as part of a column's name.
std::string field_column(const FieldComponent& field)
{
    return field.name + unit_suffix(field.unit);
}

/// Looks at a frame and returns the wanted values; nothing where the point is not in the soil.
using TakeValues =
    std::function<std::optional<std::vector<double>>(const Frame&, const std::vector<FieldComponent>&)>;

struct Box {
    Vector2 lower = Vector2::Constant(std::numeric_limits<double>::infinity());
    Vector2 upper = -lower;
    void include(const Frame& frame)
    {
        for (const Vector2& point : frame.points) {
            lower = lower.cwiseMin(point);
            upper = upper.cwiseMax(point);
        }
    }
};

[[noreturn]] void refuse_point(const Vector2& at, const Box& box)
{
    throw InputError(
        fmt::format("the point ({}, {}) m is never inside the soil, which reaches from {} to {} m", at.x(),
                    at.y(), place_text(box.lower), place_text(box.upper)));
}

/// Values of the axis-parallel cell around the point, bilinear.
std::optional<std::vector<double>>
interpolate_at(const Frame& frame, const std::vector<FieldComponent>& fields, const Vector2& at)
{
    for (std::size_t cell = 0; cell < frame.cells.size(); ++cell) {
        const std::span<const std::int64_t> quad = frame.cells[cell];
        const Vector2& lower = frame.points[static_cast<std::size_t>(quad[0])];
        const Vector2& upper = frame.points[static_cast<std::size_t>(quad[2])];
        if ((at.array() < lower.array()).any() || (at.array() > upper.array()).any()) continue;
        const Vector2 fraction = (at - lower).cwiseQuotient(upper - lower);
        const std::array<double, 4> weights{(1.0 - fraction.x()) * (1.0 - fraction.y()),
                                            fraction.x() * (1.0 - fraction.y()), fraction.x() * fraction.y(),
                                            (1.0 - fraction.x()) * fraction.y()};
        std::vector<double> values(fields.size(), 0.0);
        for (std::size_t f = 0; f < fields.size(); ++f)
            for (std::size_t k = 0; k < 4; ++k)
                values[f] +=
                    weights[k] * value_at(frame.point_data, fields[f], static_cast<std::size_t>(quad[k]));
        return values;
    }
    return std::nullopt;
}

std::vector<Vector2> corners_of(const Frame& frame, std::size_t cell)
{
    std::vector<Vector2> corners;
    for (const std::int64_t point : frame.cells[cell])
        corners.push_back(frame.points[static_cast<std::size_t>(point)]);
    return corners;
}

Vector2 centre_of(const std::vector<Vector2>& corners)
{
    Vector2 sum = Vector2::Zero();
    for (const Vector2& corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
}

FieldComponent find_component(const Frame& frame, const std::string& name)
{
    return select(frame.cell_data, {name}).front();
}

/// Follows one particle through the frames by its lasting number.
class Rider {
public:
    explicit Rider(const Vector2& at) : at_(at) {}

    std::optional<std::vector<double>> operator()(const Frame& frame,
                                                  const std::vector<FieldComponent>& fields)
    {
        if (identifier_ == unknown) choose(frame);
        if (identifier_ == unknown) return std::nullopt;
        const FieldComponent identifiers = find_component(frame, "particle_id");
        for (std::size_t cell = 0; cell < frame.cells.size(); ++cell) {
            if (value_at(frame.cell_data, identifiers, cell) != identifier_) continue;
            std::vector<double> values;
            for (const FieldComponent& field : fields)
                values.push_back(value_at(frame.cell_data, field, cell));
            return values;
        }
        return std::nullopt;
    }

private:
    static constexpr double unknown = -1.0;

    /// The particle whose place before its displacement was nearest, unless the point is beyond its reach.
    void choose(const Frame& frame)
    {
        const FieldComponent identifiers = find_component(frame, "particle_id");
        const std::vector<FieldComponent> displacement = select(frame.cell_data, {"displacement"});
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t cell = 0; cell < frame.cells.size(); ++cell) {
            const Vector2 moved(value_at(frame.cell_data, displacement[0], cell),
                                value_at(frame.cell_data, displacement[1], cell));
            const std::vector<Vector2> corners = corners_of(frame, cell);
            const double distance = (centre_of(corners) - moved - at_).norm();
            const double size = (corners[2] - corners[0]).norm();
            if (distance >= least || distance > 2.0 * size) continue;
            least = distance;
            identifier_ = value_at(frame.cell_data, identifiers, cell);
        }
    }

    Vector2 at_;
    double identifier_ = unknown;
};

HistoryTable extract(const std::filesystem::path& index, std::vector<FrameArray> Frame::*arrays,
                     const ExtractRequest& request, const TakeValues& take)
{
    HistoryTable table{{"time_s"}, {}};
    Box box;
    bool ever_inside = false;
    const std::vector<FrameEntry> entries = read_series_index(index);
    if (entries.empty()) throw InputError(index.string() + ": the series has no frames yet");
    for (const FrameEntry& entry : entries) {
        const Frame frame = read_frame(index.parent_path() / entry.file);
        const std::vector<FieldComponent> fields = select(frame.*arrays, request.fields);
        if (table.rows.empty())
            for (const FieldComponent& field : fields) table.columns.push_back(field_column(field));
        box.include(frame);
        const auto values = take(frame, fields);
        ever_inside = ever_inside || values.has_value();
        const std::vector<double> taken = values.value_or(std::vector<double>(fields.size(), no_value));
        table.rows.push_back({entry.time});
        table.rows.back().insert(table.rows.back().end(), taken.begin(), taken.end());
    }
    if (!ever_inside) refuse_point(request.at, box);
    return table;
}

bool is_displaced(const ParticleFrame& frame)
{
    const auto moves = [&](const char* name) {
        const auto found = frame.scalars.find(name);
        return found != frame.scalars.end() &&
               std::any_of(found->second.begin(), found->second.end(), [](double u) { return u != 0.0; });
    };
    return moves("displacement_x") || moves("displacement_y");
}

} // namespace

void refuse_field(const std::string& name, const std::vector<std::string>& known)
{
    const std::string near = nearest_name(name, known);
    throw InputError(fmt::format("there is no field '{}' in the results{} Available: {}", name,
                                 near.empty() ? "." : "; did you mean '" + near + "'?",
                                 fmt::join(known, ", ")));
}

ParticleFrame read_particle_frame(const std::filesystem::path& file)
{
    const Frame frame = read_frame(file);
    ParticleFrame particles;
    particles.time = frame.time;
    for (std::size_t cell = 0; cell < frame.cells.size(); ++cell)
        particles.domains.push_back(corners_of(frame, cell));
    for (const FieldComponent& field : components_of(frame.cell_data)) {
        std::vector<double>& values = particles.scalars[field.name];
        for (std::size_t cell = 0; cell < frame.cells.size(); ++cell)
            values.push_back(value_at(frame.cell_data, field, cell));
        particles.units[field.name] = field.unit;
    }
    for (const FrameText& text : frame.texts) {
        if (text.name == "material_names") particles.material_names = text.lines;
        if (text.name == "region_names") particles.region_names = text.lines;
    }
    return particles;
}

std::vector<FrameEntry> particle_frames(const std::filesystem::path& results)
{
    const std::filesystem::path index = ResultsFolder{results}.particle_series();
    std::vector<FrameEntry> frames = read_series_index(index);
    if (frames.empty()) throw InputError(index.string() + ": there is no frame in it yet");
    for (FrameEntry& frame : frames) frame.file = index.parent_path() / frame.file;
    return frames;
}

ParticleFrame read_first_frame(const std::filesystem::path& results)
{
    return read_particle_frame(particle_frames(results).front().file);
}

ParticleFrame read_frame_of_origin(const std::filesystem::path& results)
{
    const std::vector<std::filesystem::path> stages = stages_up_to(results);
    ParticleFrame first = read_first_frame(stages.back());
    for (auto stage = std::next(stages.rbegin()); stage != stages.rend() && is_displaced(first); ++stage)
        if (std::filesystem::exists(ResultsFolder{*stage}.particle_series()))
            first = read_first_frame(*stage);
    return first;
}

HistoryTable extract_history(const std::filesystem::path& results, const ExtractRequest& request)
{
    const ResultsFolder folder{results};
    if (request.kind == ProbeKind::fixed)
        return extract(folder.grid_series(), &Frame::point_data, request,
                       [&](const Frame& frame, const std::vector<FieldComponent>& fields) {
                           return interpolate_at(frame, fields, request.at);
                       });
    if (request.kind == ProbeKind::material)
        return extract(folder.particle_series(), &Frame::cell_data, request, Rider(request.at));
    throw InputError("only fixed and material points can be extracted from the frames");
}

void write_history_table(const std::filesystem::path& path, const HistoryTable& table)
{
    std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
    for (const std::vector<double>& row : table.rows) {
        CsvRow cells;
        for (const double value : row) cells.push_back(csv_number(value));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    write_atomically(path, text);
}

} // namespace quicksand
