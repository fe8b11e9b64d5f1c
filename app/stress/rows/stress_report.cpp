#include "app/stress/rows/stress_report.hpp"

#include "app/run/number_format.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace quicksand {

namespace {

/// A measured column of a row.
struct Measured {
    const char* heading; // on the terminal and the page
    const char* column;  // of stress.csv
    double RowOutcome::*value;
};

constexpr std::array measured = {
    Measured{"energy", "energy_error", &RowOutcome::energy_error},
    Measured{"at end", "last_energy_error", &RowOutcome::last_energy_error},
    Measured{"loss", "numerical_loss", &RowOutcome::loss},
    Measured{"water", "water_error", &RowOutcome::water_error},
    Measured{"momentum", "momentum_error", &RowOutcome::momentum_error},
    Measured{"checker.", "checkerboard", &RowOutcome::checkerboard},
    Measured{"max v", "largest_velocity_m_s", &RowOutcome::velocity},
    Measured{"margin", "step_margin", &RowOutcome::margin},
    Measured{"twin", "disagreement", &RowOutcome::disagreement},
    Measured{"halved", "step_halvings", &RowOutcome::halvings},
    Measured{"time s", "seconds", &RowOutcome::seconds},
};

std::string cell(double value)
{
    return std::isnan(value) ? "-" : short_number(value, 2);
}

/// Words for what is wrong beyond the end itself.
std::string remarks(const RowOutcome& outcome)
{
    std::string text;
    const auto add = [&text](const std::string& words) { text += (text.empty() ? "" : "; ") + words; };
    if (is_silent(outcome)) add("SILENT FAILURE");
    if (!outcome.bad_file.empty()) add("no number in " + outcome.bad_file);
    if (is_too_fast(outcome)) add("too fast");
    if (!outcome.reason.empty()) add(outcome.reason);
    return text;
}

std::string section_of(const std::string& heading, const std::vector<std::string>& lines, std::size_t most)
{
    if (lines.empty()) return "";
    std::string text = fmt::format("{} ({})\n", heading, lines.size());
    for (std::size_t k = 0; k < std::min(most, lines.size()); ++k) text += "  " + lines[k] + "\n";
    if (lines.size() > most) text += fmt::format("  and {} more\n", lines.size() - most);
    return text;
}

std::string page_table(const std::vector<RowOutcome>& outcomes, std::size_t first, std::size_t last)
{
    std::string text = fmt::format("\n## {}\n\n| row | end |", outcomes[first].row.group);
    for (const Measured& each : measured) text += fmt::format(" {} |", each.heading);
    text += " remark |\n|---|---|";
    for (std::size_t k = 0; k <= measured.size(); ++k) text += "---|";
    for (std::size_t k = first; k < last; ++k) {
        text += fmt::format("\n| {} | {} |", outcomes[k].row.name, name_of(outcomes[k].end));
        for (const Measured& each : measured) text += fmt::format(" {} |", cell(outcomes[k].*each.value));
        text += fmt::format(" {} |", remarks(outcomes[k]));
    }
    return text + "\n";
}

} // namespace

std::string row_heading()
{
    std::string text = fmt::format("{:<44} {:<9}", "row", "end");
    for (const Measured& each : measured) text += fmt::format(" {:>8}", each.heading);
    return text;
}

std::string describe_row(const RowOutcome& outcome)
{
    std::string text = fmt::format("{:<44} {:<9}", outcome.row.id(), name_of(outcome.end));
    for (const Measured& each : measured) text += fmt::format(" {:>8}", cell(outcome.*each.value));
    const std::string words = remarks(outcome);
    return words.empty() ? text : text + "\n    " + words;
}

std::string describe_summary(const StressSummary& summary, std::size_t most)
{
    std::string text = fmt::format("{} rows:", summary.rows);
    for (std::size_t k = 0; k < summary.ends.size(); ++k)
        if (summary.ends[k] > 0)
            text += fmt::format(" {} {}", summary.ends[k], name_of(static_cast<RowEnd>(k)));
    text += fmt::format("\n{} silent failures, {} rows with files that hold no numbers\n",
                        summary.silent.size(), summary.unreadable.size());
    text +=
        section_of("Silent failures: exit code 0, and energy or water lost or made", summary.silent, most);
    text += section_of("Files that hold no numbers", summary.unreadable, most);
    text += section_of("Failures at a step that the program chose", summary.failures, most);
    text += section_of("Faster than what acts on them can make them", summary.too_fast, most);
    text += section_of("Steps that the program chose, and the watchdog halved", summary.halved, most);
    text += section_of(
        fmt::format("Largest stable step over the own one not within {} to {}", least_margin, most_margin),
        summary.poor_margins, most);
    text += section_of("Explicit and semi-implicit disagree", summary.disagreeing, most);
    return text;
}

void write_stress_csv(const std::filesystem::path& file, const std::vector<RowOutcome>& outcomes)
{
    std::vector<std::string> columns = {"group", "row", "end"};
    for (const Measured& each : measured) columns.emplace_back(each.column);
    columns.emplace_back("remark");
    std::string text =
        csv_header({"quicksand stress: errors are the largest of a run; step_margin: largest stable step "
                    "over the own one",
                    "disagreement: of the largest displacement from that of the twin in the other scheme"},
                   columns);
    for (const RowOutcome& outcome : outcomes) {
        text += fmt::format("{},{},{}", outcome.row.group, outcome.row.name, name_of(outcome.end));
        for (const Measured& each : measured) text += ',' + csv_number(outcome.*each.value);
        text += ',' + csv_text(remarks(outcome)) + '\n';
    }
    write_atomically(file, text);
}

void write_stress_page(const std::filesystem::path& file, const std::vector<RowOutcome>& outcomes,
                       const std::vector<std::filesystem::path>& figures)
{
    constexpr std::size_t all = 100000;
    std::string text =
        "# Stability laboratory\n\n```\n" + describe_summary(summarize(outcomes), all) + "```\n\n";
    for (const std::filesystem::path& figure : figures)
        text += fmt::format("![{}]({})\n", figure.stem().string(), figure.filename().string());
    for (std::size_t first = 0, last = 0; first < outcomes.size(); first = last) {
        while (last < outcomes.size() && outcomes[last].row.group == outcomes[first].row.group) ++last;
        text += page_table(outcomes, first, last);
    }
    write_atomically(file, text);
}

} // namespace quicksand
