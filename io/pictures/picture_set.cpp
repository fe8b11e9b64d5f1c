#include "io/pictures/picture_set.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_document.hpp"
#include "io/pictures/picture.hpp"
#include "io/pictures/picture_field.hpp"
#include "io/pictures/picture_probes.hpp"
#include "io/results/results_folder.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace quicksand {
namespace {

namespace fs = std::filesystem;

/// Frame to draw and frame to compare with.
struct FramePair {
    ParticleFrame present;
    std::vector<DomainCorners>
        initial; // where displacements are zero, of the same particles in the same order [m]
};

/// The domains of the first frame in the order of the present one, which sorting may have changed.
std::vector<DomainCorners> match_initial(const ParticleFrame& first, const ParticleFrame& present)
{
    const auto first_ids = first.scalars.find("particle_id");
    const auto present_ids = present.scalars.find("particle_id");
    if (first_ids == first.scalars.end() || present_ids == present.scalars.end()) return first.domains;
    std::map<double, std::size_t> place;
    for (std::size_t p = 0; p < first_ids->second.size(); ++p) place[first_ids->second[p]] = p;
    std::vector<DomainCorners> matched;
    matched.reserve(present.domains.size());
    for (std::size_t p = 0; p < present.domains.size(); ++p) {
        const auto found = place.find(present_ids->second[p]);
        matched.push_back(found == place.end() ? present.domains[p] : first.domains[found->second]);
    }
    return matched;
}

void notify(const PictureRequest& request, const std::string& remark)
{
    if (request.notify) request.notify(remark);
}

FramePair read_frames(const fs::path& results, const PictureRequest& request)
{
    const std::vector<FrameEntry> entries = particle_frames(results);
    auto chosen = std::prev(entries.end());
    if (request.time) {
        const double wanted = *request.time;
        chosen = std::min_element(entries.begin(), entries.end(), [wanted](const auto& a, const auto& b) {
            return std::abs(a.time - wanted) < std::abs(b.time - wanted);
        });
        if (std::abs(chosen->time - wanted) > 1e-9 * std::max(1.0, std::abs(wanted)))
            notify(request, fmt::format("there is no frame at t = {:g} s; drawn is the nearest, t = {:g} s",
                                        wanted, chosen->time));
    }
    FramePair frames{read_particle_frame(chosen->file), {}};
    frames.initial = match_initial(read_frame_of_origin(results), frames.present);
    return frames;
}

/// The names of the classes that a field numbers; none of a quantity.
std::vector<std::string> class_names(const ParticleFrame& frame, const std::string& field)
{
    if (field == "material") return frame.material_names;
    if (field == "region") return frame.region_names;
    return {};
}

std::string numbered_names(const std::vector<std::string>& names)
{
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < names.size(); ++k) parts.push_back(fmt::format("{} {}", k, names[k]));
    return fmt::format("{}", fmt::join(parts, ", "));
}

std::string note_of(const ParticleFrame& frame, const std::string& field, double exaggeration)
{
    if (const auto names = class_names(frame, field); !names.empty()) return numbered_names(names);
    return exaggeration == 1.0 ? "" : fmt::format("displacements × {:g}", exaggeration);
}

Drawing drawing_of(const FramePair& frames, const std::string& field, const std::string& title,
                   const PictureRequest& request, const fs::path& file)
{
    std::optional<DrawnField> drawn = drawn_field(frames.present, field);
    if (!drawn) refuse_field(field, drawable_fields(frames.present));
    FieldPicture picture;
    picture.domains = exaggerate(frames.initial, frames.present.domains, request.exaggeration);
    picture.initial_domains = frames.initial;
    picture.values = std::move(drawn->values);
    picture.quantity = drawn->label;
    picture.unit = drawn->unit;
    picture.colours = drawn->colours;
    picture.title = title;
    picture.note = note_of(frames.present, field, request.exaggeration);
    picture.time = frames.present.time;
    picture.range = request.range;
    picture.classes = static_cast<int>(class_names(frames.present, field).size());
    if (picture.classes > 0 && !picture.range) picture.range = PlotRange{-0.5, picture.classes - 0.5};
    return field_drawing(picture, file);
}

std::vector<std::string> default_fields(const ParticleFrame& frame)
{
    const bool saturated = frame.scalars.contains("excess_pore_pressure");
    return {saturated ? "excess_pore_pressure" : "mean_effective_stress", "displacement", "shear_strain"};
}

bool names_a_file(const fs::path& output)
{
    return output.extension() == ".png";
}

void require_sense(const PictureRequest& request)
{
    const bool one_field = !request.field.empty();
    if (!one_field && names_a_file(request.output))
        throw InputError(request.output.string() +
                         " is one file, and the default set has several: name a folder, or one --field");
    if (!one_field && request.range) throw InputError("--range is for one field: name it with --field");
    if (request.range && !(request.range->width() > 0.0))
        throw InputError(fmt::format("the range {:g}:{:g} is empty: its first value must be the smaller one",
                                     request.range->low, request.range->high));
    if (!std::isfinite(request.exaggeration) || request.exaggeration < 0.0)
        throw InputError(fmt::format("displacements cannot be drawn {:g} times as large: zero or more is "
                                     "allowed",
                                     request.exaggeration));
}

void make_folder(const fs::path& folder)
{
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot make the folder", error.message(), "");
}

} // namespace

std::string scene_title(const fs::path& results)
{
    const fs::path file = ResultsFolder{results}.scene_copy();
    if (!fs::exists(file)) return "";
    Diagnostics ignored;
    const auto document = read_document(file, read_text(file), {}, ignored);
    const DocumentNode* title = document ? document->find("title") : nullptr;
    return title == nullptr ? "" : title->text;
}

PlotRange parse_range(std::string_view text)
{
    const auto parse = [text](std::string_view part) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size() || !std::isfinite(value))
            throw InputError(fmt::format("'{}' is no range: write two numbers in SI units with a colon "
                                         "between, as in 0:9e3",
                                         text));
        return value;
    };
    const std::size_t colon = std::min(text.find(':'), text.size());
    return {parse(text.substr(0, colon)), parse(text.substr(std::min(colon + 1, text.size())))};
}

std::vector<std::string> drawable_fields(const ParticleFrame& frame)
{
    std::vector<std::string> names;
    for (const auto& [name, values] : frame.scalars) {
        const std::string vector = name.substr(0, name.size() - std::min<std::size_t>(2, name.size()));
        if (name.ends_with("_x") && frame.scalars.contains(vector + "_y")) names.push_back(vector);
        if (name != "particle_id") names.push_back(name);
    }
    return names;
}

std::vector<Drawing> result_drawings(const fs::path& results, const PictureRequest& request)
{
    require_sense(request);
    const fs::path folder = request.output.empty() ? results / "pictures" : request.output;
    const FramePair frames = read_frames(results, request);
    const std::string title = request.title.empty() ? scene_title(results) : request.title;
    // A picture at a time asked for does not replace the one of the end.
    const std::string suffix = request.time ? fmt::format("_{:g}s.png", frames.present.time) : ".png";

    if (names_a_file(folder)) {
        make_folder(folder.parent_path());
        return {drawing_of(frames, request.field, title, request, folder)};
    }
    const bool one_field = !request.field.empty();
    if (one_field && !drawn_field(frames.present, request.field))
        refuse_field(request.field, drawable_fields(frames.present));
    make_folder(folder);
    std::vector<Drawing> drawings;
    for (const std::string& field : one_field ? std::vector{request.field} : default_fields(frames.present))
        drawings.push_back(drawing_of(frames, field, title, request, folder / (field + suffix)));
    if (one_field) return drawings;
    std::vector<Drawing> plots = probe_drawings(results, folder);
    std::move(plots.begin(), plots.end(), std::back_inserter(drawings));
    return drawings;
}

std::vector<fs::path> draw_results(const fs::path& results, const PictureRequest& request)
{
    return draw_pictures(result_drawings(results, request));
}

} // namespace quicksand
