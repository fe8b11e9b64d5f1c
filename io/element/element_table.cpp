#include "io/element/element_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

std::string soil_line(const ElementOutcome& outcome)
{
    const ElementTest& test = outcome.test;
    const DescribedLaw& soil = test.soil;
    std::string title = soil.title;
    if (!soil.density.empty())
        title += ", " + (test.varied == soil.density_key ? test.varied + " varied" : soil.density);
    return fmt::format("Material   {}: {}; {}{}", test.material, title,
                       test.varied.empty() ? "" : "first value: ", test.specimens.front().soil.numbers);
}

std::string specimen_line(const ElementOutcome& outcome)
{
    const Consolidation& start = outcome.test.specimens.front().start;
    std::string line =
        fmt::format("Specimen   σ'v0 = {:.4g} kPa, K0 = {:.3g}, static shear stress {:.4g} kPa",
                    1e-3 * start.vertical_stress, start.k0, 1e-3 * start.static_shear);
    if (outcome.test.varied.empty()) return line;
    line += "; varied:";
    for (std::size_t k = 0; k < outcome.test.specimens.size(); ++k) {
        line += (k == 0 ? " " : ", ") + outcome.test.specimens[k].label;
    }
    return line;
}

std::string criterion_text(LiquefactionCriterion criterion)
{
    switch (criterion) {
    case LiquefactionCriterion::ru_95:
        return "ru > 0.95";
    case LiquefactionCriterion::strain_3_percent:
        return "3 % single-amplitude shear strain";
    case LiquefactionCriterion::strain_375_percent:
        return "3.75 % single-amplitude shear strain";
    case LiquefactionCriterion::double_amplitude_75_percent:
        return "7.5 % double-amplitude shear strain";
    }
    return "";
}

/// First lines and last line when there are too many.
std::vector<std::string> cut(std::vector<std::string> lines, std::size_t most)
{
    if (lines.size() <= most) return lines;
    const std::size_t left_out = lines.size() - most + 1;
    lines.resize(most - 1);
    lines.push_back(fmt::format("... {} more rows in the CSV file", left_out));
    return lines;
}

/// Three decimals, zero without a sign.
std::string rounded(double number)
{
    return fmt::format("{:.3f}", std::round(1000.0 * number) / 1000.0 + 0.0);
}

/// Cells under each other, the first column to the left.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows)
{
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::vector<std::string> lines;
    for (const auto& row : rows) {
        std::string line = fmt::format("{:<{}}", row[0], widths[0]);
        for (std::size_t c = 1; c < row.size(); ++c) line += fmt::format("  {:>{}}", row[c], widths[c]);
        lines.push_back(line);
    }
    return lines;
}

std::vector<std::string> strength_lines(const ElementOutcome& outcome)
{
    std::vector<std::vector<std::string>> rows = {{"", "CSR at N = 15", "slope b"}};
    bool liquefies = true;
    for (std::size_t k = 0; k < outcome.strengths.size(); ++k) {
        const auto& strength = outcome.strengths[k];
        const std::string& label = outcome.test.specimens[k].label;
        liquefies = liquefies && strength;
        rows.push_back({label.empty() ? "ru > 0.95" : label,
                        strength ? fmt::format("{:.4f}", strength->csr_15) : "-",
                        strength ? fmt::format("{:.3f}", strength->slope) : "-"});
    }
    std::vector<std::string> lines = aligned(rows);
    lines.emplace_back("CSR ~ N^-b between 10 and 30 cycles");
    if (!liquefies) lines.emplace_back("-: ru = 0.95 is not reached in so many cycles");
    return lines;
}

/// Cycles to liquefaction, a row for each CSR and a column for each specimen.
std::vector<std::string> strength_matrix(const ElementOutcome& outcome)
{
    std::vector<std::vector<std::string>> rows(1 + outcome.test.loadings.size());
    rows[0].emplace_back("CSR");
    for (std::size_t k = 0; k < outcome.test.loadings.size(); ++k) {
        rows[k + 1].push_back(short_text(std::get<StressCycles>(outcome.test.loadings[k]).csr, 4));
    }
    for (const ElementSpecimen& specimen : outcome.test.specimens) {
        rows[0].push_back(specimen.label.substr(specimen.label.find('=') + 2));
    }
    for (const ElementRun& run : outcome.runs) {
        std::vector<std::string>& row = rows[run.loading + 1];
        row.resize(rows[0].size(), "-");
        row[run.specimen + 1] = short_text(cycles_to_liquefaction(outcome, run), 4);
    }
    std::vector<std::string> lines = aligned(rows);
    lines.insert(lines.begin(),
                 "N to " + criterion_text(outcome.test.criterion) + ", by " + outcome.test.varied);
    return lines;
}

std::vector<std::string> cyclic_table(const ElementOutcome& outcome, std::size_t most_rows)
{
    std::vector<std::vector<std::string>> rows = {
        {"", "N ru 0.95", "N 3 %", "N 3.75 %", "N 7.5 % DA", "cycles run"}};
    for (const ElementRun& run : outcome.runs) {
        const CyclicTest& result = run.result;
        rows.push_back(
            {run_label(outcome, run), short_text(result.cycles_to_ru_95, 4),
             short_text(result.cycles_to_3_percent, 4), short_text(result.cycles_to_375_percent, 4),
             short_text(result.cycles_to_75_double, 4), fmt::format("{:.2f}", result.path.back().cycle)});
    }
    const std::vector<std::string> strength = strength_lines(outcome);
    const std::size_t room = most_rows > strength.size() + 4 ? most_rows - strength.size() - 1 : 3;
    const bool as_matrix = rows.size() > room && !outcome.test.varied.empty();
    std::vector<std::string> lines = cut(as_matrix ? strength_matrix(outcome) : aligned(rows), room);
    lines.emplace_back("");
    lines.insert(lines.end(), strength.begin(), strength.end());
    return lines;
}

std::vector<std::string> strain_table(const ElementOutcome& outcome, std::size_t most_rows)
{
    std::vector<std::vector<std::string>> rows = {{"", "cycle", "G sec MPa", "damping %", "ru", "N ru 0.95"}};
    for (const ElementRun& run : outcome.runs) {
        const std::vector<CycleSummary> cycles = summarize_cycles(run.result.path);
        for (const CycleSummary& cycle : cycles) {
            if (cycle.cycle != 1 && cycle.cycle != 10) continue;
            rows.push_back({run_label(outcome, run), std::to_string(cycle.cycle),
                            fmt::format("{:.3g}", 1e-6 * cycle.secant_modulus),
                            fmt::format("{:.3g}", 100.0 * cycle.damping_ratio),
                            fmt::format("{:.3f}", cycle.ru), short_text(run.result.cycles_to_ru_95, 4)});
        }
    }
    return cut(aligned(rows), most_rows);
}

/// Where the water begins to leave and where it has left.
std::vector<std::string> reconsolidation_table(const ElementOutcome& outcome, std::size_t most_rows)
{
    std::vector<std::vector<std::string>> rows = {
        {"", "N ru 0.95", "s'v kPa from", "to", "s'h/s'v", "eps_vol %"}};
    for (const ElementRun& run : outcome.runs) {
        const ElementPoint &from = run.result.path[run.result.drained_from], &to = run.result.path.back();
        rows.push_back({run_label(outcome, run), short_text(run.result.cycles_to_ru_95, 4),
                        fmt::format("{:.1f}", 1e-3 * from.sigma_y), fmt::format("{:.1f}", 1e-3 * to.sigma_y),
                        fmt::format("{:.3f}", to.sigma_x / to.sigma_y),
                        fmt::format("{:.3f}", 100.0 * to.volumetric_strain())});
    }
    return cut(aligned(rows), most_rows);
}

/// Coordinate and two stresses at round strains, and phase transformation: the least mean stress in the
/// plane.
std::vector<std::string> monotonic_table(const ElementOutcome& outcome, bool shear, std::size_t most_rows)
{
    std::vector<std::vector<std::string>> rows = {{"", shear ? "gamma %" : "eps_v %",
                                                   shear ? "tau kPa" : "q kPa", shear ? "s'v kPa" : "s' kPa",
                                                   "ru", "eps_vol %"}};
    const auto add = [&](const std::string& label, const ElementPoint& point) {
        rows.push_back(
            {label, fmt::format("{:.3g}", 100.0 * (shear ? point.gamma : point.strain_y)),
             fmt::format("{:.1f}", 1e-3 * (shear ? point.tau : point.sigma_y - point.sigma_x)),
             fmt::format("{:.1f}", 1e-3 * (shear ? point.sigma_y : 0.5 * (point.sigma_x + point.sigma_y))),
             rounded(point.ru), rounded(100.0 * point.volumetric_strain())});
    };
    for (const ElementRun& run : outcome.runs) {
        const ElementPath& path = run.result.path;
        const auto least =
            std::min_element(path.begin(), path.end(), [](const ElementPoint& a, const ElementPoint& b) {
                return a.sigma_x + a.sigma_y < b.sigma_x + b.sigma_y;
            });
        const std::string& label = outcome.specimen(run).label;
        if (least != path.begin() && std::next(least) != path.end())
            add(label + (label.empty() ? "" : ", ") + "least s'", *least);
        for (const double strain : {0.001, 0.01, 0.02, 0.05, 0.1}) {
            const auto reached = std::find_if(path.begin(), path.end(), [&](const ElementPoint& point) {
                return (shear ? point.gamma : point.strain_y) >= strain - 1e-9;
            });
            if (reached != path.end()) add(label, *reached);
        }
    }
    return cut(aligned(rows), most_rows);
}

std::vector<std::string> compression_table(const ElementOutcome& outcome, std::size_t most_rows)
{
    std::vector<std::vector<std::string>> rows = {{"", "s'v kPa", "s'h kPa", "s'h/s'v", "eps_vol %"}};
    for (const ElementRun& run : outcome.runs) {
        const ElementPath& path = run.result.path;
        for (std::size_t k = 0; k < path.size(); ++k) {
            const bool turns =
                k > 0 && k + 1 < path.size() &&
                (path[k].sigma_y - path[k - 1].sigma_y) * (path[k + 1].sigma_y - path[k].sigma_y) < 0.0;
            if (k != 0 && k + 1 != path.size() && !turns) continue;
            rows.push_back({outcome.specimen(run).label, fmt::format("{:.1f}", 1e-3 * path[k].sigma_y),
                            fmt::format("{:.1f}", 1e-3 * path[k].sigma_x),
                            fmt::format("{:.3f}", path[k].sigma_x / path[k].sigma_y),
                            fmt::format("{:.4f}", 100.0 * path[k].volumetric_strain())});
        }
    }
    return cut(aligned(rows), most_rows);
}

} // namespace

std::vector<std::string> describe_conditions(const ElementOutcome& outcome)
{
    std::vector<std::string> lines = {soil_line(outcome), specimen_line(outcome)};
    std::string loading = "Loading    " + loading_name(outcome.test.loadings.front());
    if (std::holds_alternative<StressCycles>(outcome.test.loadings.front())) {
        loading +=
            "; liquefaction is " + criterion_text(outcome.test.criterion) + ", cycles counted in halves";
    }
    lines.push_back(loading);
    return lines;
}

std::vector<std::string> result_table(const ElementOutcome& outcome, std::size_t most_rows)
{
    const ElementLoading& first = outcome.test.loadings.front();
    if (std::holds_alternative<StressCycles>(first)) return cyclic_table(outcome, most_rows);
    if (std::holds_alternative<StrainCycles>(first)) return strain_table(outcome, most_rows);
    if (std::holds_alternative<Reconsolidation>(first)) return reconsolidation_table(outcome, most_rows);
    if (std::holds_alternative<MonotonicShear>(first)) return monotonic_table(outcome, true, most_rows);
    if (std::holds_alternative<BiaxialCompression>(first)) return monotonic_table(outcome, false, most_rows);
    return compression_table(outcome, most_rows);
}

} // namespace quicksand
