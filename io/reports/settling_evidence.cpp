#include "io/reports/settling_evidence.hpp"

#include "io/frames/particle_frame.hpp"
#include "io/frames/vtk_series.hpp"
#include "io/pictures/picture.hpp"
#include "io/pictures/picture_field.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

/// The corners where they were drawn, as far as the displacement of the centres tells.
std::vector<DomainCorners> drawn_domains(const ParticleFrame& frame)
{
    std::vector<DomainCorners> domains = frame.domains;
    const std::vector<double>& x = frame.scalars.at("displacement_x");
    const std::vector<double>& y = frame.scalars.at("displacement_y");
    for (std::size_t p = 0; p < domains.size(); ++p)
        for (Vector2& corner : domains[p]) corner -= Vector2(x[p], y[p]);
    return domains;
}

void draw(const fs::path& file, const ParticleFrame& frame, const std::string& title, std::int64_t step)
{
    std::optional<DrawnField> field = drawn_field(frame, "displacement");
    ENSURE(field);
    FieldPicture picture;
    picture.domains = frame.domains;
    picture.initial_domains = drawn_domains(frame);
    picture.values = std::move(field->values);
    picture.quantity = field->label;
    picture.unit = field->unit;
    picture.colours = field->colours;
    picture.title = title;
    picture.note = fmt::format("step {} of the settling, the line is the section as drawn", step);
    draw_pictures({field_drawing(picture, file)});
}

} // namespace

std::string leave_settling_evidence(const ResultsFolder& folder, const std::string& title,
                                    const Problem& problem, const State& state)
{
    try {
        Frame frame = particle_frame(problem, state);
        frame.time = 0.0; // that of the shaking has not begun
        VtkSeries series(folder.settling_series());
        series.append(frame);
        const fs::path file = folder.directory / series.entries().back().file;
        draw(folder.settling_picture(), read_particle_frame(file), title, state.step);
    } catch (const FileError& error) {
        return fmt::format("\n  the soil as it is could not be kept: {}", error.what());
    }
    return fmt::format("\n  the soil as it is: {} (ParaView), its displacement: {}",
                       folder.settling_series().string(), folder.settling_picture().string());
}

} // namespace quicksand
