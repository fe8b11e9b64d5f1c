#include "app/stress/rows/row_outcome.hpp"

#include "app/run/choices.hpp"
#include "app/run/run_verdict.hpp"
#include "app/stress/rows/row_numbers.hpp"
#include "geometry/drawing/text_file.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/results/run_manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const fs::path& file)
{
    std::vector<std::string> lines;
    if (!fs::exists(file)) return lines;
    std::istringstream text(read_text(file));
    for (std::string line; std::getline(text, line);)
        if (!line.empty()) lines.push_back(line);
    return lines;
}

/// The failure's first line, or the last line said, and the place behind it; without the row's folder.
std::string reason_in(const RowFiles& files)
{
    const std::vector<std::string> lines = lines_of(files.complaints());
    const auto tells_failure = [](const std::string& line) {
        return line.starts_with("the run failed") || line.starts_with("the balances") ||
               line.starts_with("internal error") || line.find("error[") != std::string::npos;
    };
    auto line = std::find_if(lines.begin(), lines.end(), tells_failure);
    if (line == lines.end() && !lines.empty()) --line;
    if (line == lines.end()) return "";
    std::string reason = *line;
    if (line + 1 != lines.end() && (line + 1)->starts_with("  ") && line->find("error[") == std::string::npos)
        reason += (reason.ends_with(':') ? "" : ";") + (line + 1)->substr(1);
    const std::string folder = files.folder.string() + "/";
    for (auto at = reason.find(folder); at != std::string::npos; at = reason.find(folder))
        reason.erase(at, folder.size());
    return reason;
}

double largest_in(const PictureTable& table, std::string_view column)
{
    const std::vector<double>* values = table.find(column);
    if (values == nullptr || values->empty()) return NAN;
    double largest = 0.0;
    for (const double value : *values)
        largest = std::isnan(value) ? value : std::max(largest, std::abs(value));
    return largest;
}

/// The larger of two components over the largest momentum, impulse, or momentum that all the mass would have
/// at the largest velocity.
double momentum_error(const PictureTable& table)
{
    const double mass = std::fmax(largest_in(table, "mass_solid_kg"), 0.0) +
                        std::fmax(largest_in(table, "mass_fluid_kg"), 0.0);
    double scale = std::fmax(mass * largest_in(table, "max_velocity_m_s"), 0.0), error = 0.0;
    for (const char* name : {"momentum_x_N_s", "momentum_y_N_s", "impulse_x_N_s", "impulse_y_N_s"})
        scale = std::fmax(scale, largest_in(table, name));
    for (const char* name : {"momentum_error_x_N_s", "momentum_error_y_N_s"})
        error = std::fmax(error, largest_in(table, name));
    return scale > 0.0 ? error / scale : 0.0;
}

void read_history(const RowFiles& files, RowOutcome& outcome)
{
    const fs::path history = files.results() / "history.csv";
    if (!fs::exists(history)) return;
    for (const Finding& finding : judge_history({files.results()})) {
        const std::string_view quantity = finding.criterion->quantity;
        if (quantity == "energy_error") outcome.energy_error = finding.worst;
        if (quantity == "water_error") outcome.water_error = finding.worst;
        if (quantity == "numerical_loss_J") outcome.loss = finding.worst;
        if (quantity.ends_with("checkerboard"))
            outcome.checkerboard = std::fmax(outcome.checkerboard, finding.worst);
    }
    const PictureTable table = read_picture_table(history);
    const std::vector<double>* energy = table.find("energy_error");
    if (energy != nullptr && !energy->empty()) outcome.last_energy_error = energy->back();
    const std::vector<double>* displacement = table.find("max_displacement_m");
    if (displacement != nullptr && !displacement->empty()) outcome.displacement = displacement->back();
    outcome.momentum_error = momentum_error(table);
    outcome.velocity = largest_in(table, "max_velocity_m_s");
}

RowEnd end_of(const ProcessEnd& process, const RowFiles& files, const std::string& reason)
{
    if (process.was_late) return RowEnd::overtime;
    if (process.code == static_cast<int>(ExitCode::input)) return RowEnd::refused;
    if (process.code != static_cast<int>(ExitCode::good) &&
        process.code != static_cast<int>(ExitCode::numerical))
        return RowEnd::crashed;
    const bool has_history = fs::exists(files.results() / "history.csv");
    const std::vector<Finding> findings =
        has_history ? judge_history({files.results()}) : std::vector<Finding>();
    if (process.code == static_cast<int>(ExitCode::good))
        return worst_grade(findings) == Grade::good ? RowEnd::good : RowEnd::usable;
    const std::string verdict = explain_bad_verdict(findings);
    return reason.starts_with(verdict.substr(0, verdict.find('\n'))) ? RowEnd::bad : RowEnd::stopped;
}

} // namespace

const char* name_of(RowEnd end)
{
    constexpr std::array names = {"good", "usable", "bad", "refused", "stopped", "crashed", "overtime"};
    return names.at(static_cast<std::size_t>(end));
}

RowOutcome read_outcome(const StressRow& row, const RowFiles& files, const ProcessEnd& process)
{
    RowOutcome outcome;
    outcome.row = row;
    outcome.reason = process.code == 0 ? "" : reason_in(files);
    if (process.was_late) outcome.reason = fmt::format("ended after {:.0f} s of wall time", process.seconds);
    if (process.code < 0 && !process.was_late)
        outcome.reason = fmt::format("signal {}: {}", -process.code, reason_in(files));
    outcome.seconds = process.seconds;
    outcome.end = end_of(process, files, outcome.reason);
    read_history(files, outcome);
    outcome.halvings = read_step_halvings(ResultsFolder{files.results()}.manifest());
    if (fs::exists(files.margin())) {
        const PictureTable margin = read_picture_table(files.margin());
        outcome.margin = margin.find("margin")->back();
        outcome.seconds -= margin.find("seconds")->back();
    }
    outcome.bad_file = find_bad_numbers(files.results());
    return outcome;
}

} // namespace quicksand
