#include "io/reports/page_pictures.hpp"

#include "io/files/file_error.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/pictures/figure_set.hpp"
#include "io/pictures/picture_field.hpp"
#include "io/pictures/picture_set.hpp"
#include "io/reports/html_page.hpp"
#include "io/reports/run_motion.hpp"
#include "io/results/results_folder.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// "probe crest" of probe_crest.png.
std::string caption_of(const fs::path& png)
{
    std::string text = png.stem().string();
    for (char& letter : text)
        if (letter == '_') letter = ' ';
    return text;
}

/// At most `count` frames at even distances, the first and the last among them.
std::vector<FrameEntry> choose_frames(const std::vector<FrameEntry>& frames, std::size_t count)
{
    if (frames.size() <= count) return frames;
    std::vector<FrameEntry> chosen;
    for (std::size_t k = 0; k < count; ++k) chosen.push_back(frames[k * (frames.size() - 1) / (count - 1)]);
    return chosen;
}

/// From the least to the largest value of all frames, ends that few reach left out, and zero within.
PlotRange common_range(const fs::path& results, const std::vector<FrameEntry>& frames,
                       const std::string& field)
{
    PlotRange range{0.0, 0.0};
    for (const FrameEntry& entry : frames) {
        const auto drawn = drawn_field(read_particle_frame(results / entry.file), field);
        if (!drawn) continue;
        std::vector<double> values;
        for (const double value : drawn->values)
            if (std::isfinite(value)) values.push_back(value);
        if (values.empty()) continue;
        std::sort(values.begin(), values.end());
        const std::size_t cut = values.size() / 200;
        range.low = std::min(range.low, values[cut]);
        range.high = std::max(range.high, values[values.size() - 1 - cut]);
    }
    return range.width() > 0.0 ? round_limits(range) : PlotRange{0.0, 1.0};
}

} // namespace

ShortLivedFolder::ShortLivedFolder()
{
    std::string name = (fs::temp_directory_path() / "quicksand_report_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw FileError(name, "cannot create the folder", system_reason(errno), "TMPDIR names another place");
    path_ = name;
}

ShortLivedFolder::~ShortLivedFolder()
{
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string section_picture(const fs::path& results, const fs::path& folder)
{
    PictureRequest request;
    request.field = "region";
    request.time = 0.0;
    request.output = folder / "section.png";
    return html_picture(draw_results(results, request).front(), "The section in the first frame, by regions");
}

std::string result_pictures(const fs::path& results, const fs::path& folder, const Notify& notify)
{
    PictureRequest request;
    request.output = folder / "pictures";
    std::string html;
    for (const fs::path& png : draw_results(results, request)) html += html_picture(png, caption_of(png));
    const fs::path scene = ResultsFolder{results}.scene_copy();
    if (!fs::exists(scene)) return html;
    try {
        const std::vector<SceneFigure> figures = figures_of_scene(scene);
        for (const fs::path& png : draw_figures(results, figures, folder / "figures", notify))
            html += html_picture(png, "Figure of the scene: " + caption_of(png));
    } catch (const InputError& error) { // a variant, whose base lies elsewhere
        notify(std::string("the figures of the scene are left out: ") + error.what());
    }
    return html;
}

std::string field_animation(const fs::path& results, const std::string& field, const fs::path& folder)
{
    constexpr std::size_t most = 24;
    const auto frames = choose_frames(read_series_index(ResultsFolder{results}.particle_series()), most);
    PictureRequest request;
    request.field = field;
    // suction and rebounds beyond the range that matters would take all the colours
    request.range = field == "ru" ? PlotRange{0.0, 1.0} : common_range(results, frames, field);
    std::vector<Drawing> drawings;
    std::vector<std::string> captions;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        request.time = frames[k].time;
        request.output = folder / fmt::format("frame_{:03}.png", k);
        for (Drawing& drawing : result_drawings(results, request)) drawings.push_back(std::move(drawing));
        captions.push_back(fmt::format("{}, t = {:.4g} s", field, frames[k].time));
    }
    return html_animation(draw_pictures(drawings), captions);
}

std::string motion_pictures(const fs::path& results, const fs::path& folder, const Notify& notify)
{
    const RunMotion motion = motion_of_run(results, notify);
    if (motion.motion.accelerations.size() < 2) return "";
    std::string html = html_table(motion.measures);
    for (const fs::path& png : draw_pictures(motion_drawings(motion, folder)))
        html += html_picture(png, motion.origin);
    return html;
}

} // namespace quicksand
