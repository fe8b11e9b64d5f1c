#include "io/element/element_results.hpp"
#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace quicksand {

namespace {

class Table {
public:
    Table(const std::vector<std::string>& comments, const std::vector<std::string>& columns)
        : text_(csv_header(comments, columns))
    {
    }
    void add(const std::vector<std::string>& cells) { text_ += fmt::format("{}\n", fmt::join(cells, ",")); }
    /// Seven digits: what the integration is good for.
    void add_numbers(std::size_t step, std::initializer_list<double> numbers)
    {
        fmt::format_to(std::back_inserter(text_), "{}", step);
        for (const double number : numbers) fmt::format_to(std::back_inserter(text_), ",{:.7g}", number);
        text_ += '\n';
    }
    void write(const std::filesystem::path& file) const { write_atomically(file, text_); }

private:
    std::string text_;
};

std::string cell(std::optional<double> number)
{
    return number ? csv_number(*number) : "";
}

/// As in the paths.
std::string digits(double number)
{
    return fmt::format("{:.7g}", number);
}

std::vector<std::string> heading(const ElementOutcome& outcome)
{
    const DescribedLaw& soil = outcome.test.soil;
    return {"Quicksand element test [tests." + outcome.test.name +
                "]: " + loading_name(outcome.test.loadings.front()),
            "material " + outcome.test.material + ", " + soil.title +
                (soil.density.empty() ? "" : ", " + soil.density)};
}

std::string file_name(const ElementOutcome& outcome, const ElementRun& run)
{
    std::string name = run_label(outcome, run);
    if (name.empty()) return "path.csv";
    std::string plain;
    for (const char c : name) {
        if (c == '%') plain += "percent";
        const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
        if (kept) {
            plain += c;
        } else if (!plain.empty() && plain.back() != '_') {
            plain += '_';
        }
    }
    while (plain.ends_with('_')) plain.pop_back();
    return "path_" + plain + ".csv";
}

void write_path(const ElementOutcome& outcome, const ElementRun& run, ElementResults& results)
{
    std::vector<std::string> comments = heading(outcome);
    const Consolidation& start = outcome.specimen(run).start;
    comments.push_back(fmt::format("{}{}sigma'_v0 = {} Pa, k0 = {}, static shear stress = {} Pa",
                                   run_label(outcome, run), run_label(outcome, run).empty() ? "" : "; ",
                                   start.vertical_stress, start.k0, start.static_shear));
    comments.push_back(
        "compression positive; the mean stress is of all three directions, the deviator stress is "
        "sqrt(3 J2)");
    Table table(comments,
                {"step", "cycle", "shear_strain", "vertical_strain", "horizontal_strain", "volumetric_strain",
                 "shear_stress_Pa", "vertical_effective_stress_Pa", "horizontal_effective_stress_Pa",
                 "out_of_plane_effective_stress_Pa", "mean_effective_stress_Pa", "deviator_stress_Pa",
                 "excess_pore_pressure_Pa", "ru"});
    std::size_t step = 0;
    for (const ElementPoint& point : run.result.path) {
        table.add_numbers(step++, {point.cycle, point.gamma, point.strain_y, point.strain_x,
                                   point.volumetric_strain(), point.tau, point.sigma_y, point.sigma_x,
                                   point.sigma_z, point.mean_stress(), point.deviator_stress(),
                                   point.ru * start.vertical_stress, point.ru});
    }
    table.write(results.add(outcome.test.name, file_name(outcome, run)));
}

/// The varied key's column where there is one.
std::vector<std::string> with_value(const ElementOutcome& outcome, std::size_t specimen,
                                    std::vector<std::string> cells)
{
    if (outcome.test.varied.empty()) return cells;
    cells.insert(cells.begin(), csv_number(outcome.test.specimens[specimen].value));
    return cells;
}

std::vector<std::string> columns_with_value(const ElementOutcome& outcome, std::vector<std::string> columns)
{
    if (!outcome.test.varied.empty()) columns.insert(columns.begin(), outcome.test.varied);
    return columns;
}

void write_strength(const ElementOutcome& outcome, ElementResults& results)
{
    std::vector<std::string> comments = heading(outcome);
    comments.emplace_back(
        "cycles are counted in halves, at the reversals; empty: not reached within cycles_run");
    Table cycles(comments,
                 columns_with_value(outcome, {"csr", "cycles_to_ru_0.95", "cycles_to_3_percent_strain",
                                              "cycles_to_3.75_percent_strain", "cycles_to_7.5_percent_double",
                                              "cycles_run", "largest_ru", "largest_shear_strain"}));
    for (const ElementRun& run : outcome.runs) {
        double ru = 0.0, gamma = 0.0;
        for (const ElementPoint& point : run.result.path) {
            ru = std::max(ru, point.ru);
            gamma = std::max(gamma, std::abs(point.gamma));
        }
        cycles.add(with_value(outcome, run.specimen,
                              {csv_number(std::get<StressCycles>(outcome.loading(run)).csr),
                               cell(run.result.cycles_to_ru_95), cell(run.result.cycles_to_3_percent),
                               cell(run.result.cycles_to_375_percent), cell(run.result.cycles_to_75_double),
                               digits(run.result.path.back().cycle), digits(ru), digits(gamma)}));
    }
    cycles.write(results.add(outcome.test.name, "csr_n.csv"));

    comments = heading(outcome);
    comments.emplace_back("csr_15: CSR to ru > 0.95 in 15 cycles; slope_b: CSR ~ N^-b from 10 to 30 cycles");
    Table strength(comments, columns_with_value(outcome, {"csr_15", "slope_b"}));
    for (std::size_t k = 0; k < outcome.strengths.size(); ++k) {
        const auto& found = outcome.strengths[k];
        strength.add(
            with_value(outcome, k, {found ? digits(found->csr_15) : "", found ? digits(found->slope) : ""}));
    }
    strength.write(results.add(outcome.test.name, "strength.csv"));
}

void write_cycles(const ElementOutcome& outcome, ElementResults& results)
{
    std::vector<std::string> comments = heading(outcome);
    comments.emplace_back("a cycle runs from peak to peak; damping ratio: area of the loop over 4 pi times "
                          "that of the triangle "
                          "below its secant");
    Table table(comments,
                columns_with_value(outcome, {"shear_strain_amplitude", "cycle", "secant_shear_modulus_Pa",
                                             "damping_ratio", "largest_ru"}));
    for (const ElementRun& run : outcome.runs) {
        const double amplitude = std::get<StrainCycles>(outcome.loading(run)).gamma;
        for (const CycleSummary& cycle : summarize_cycles(run.result.path)) {
            table.add(
                with_value(outcome, run.specimen,
                           {csv_number(amplitude), std::to_string(cycle.cycle), digits(cycle.secant_modulus),
                            digits(cycle.damping_ratio), digits(cycle.ru)}));
        }
    }
    table.write(results.add(outcome.test.name, "cycles.csv"));
}

} // namespace

void write_element_csv(const ElementOutcome& outcome, ElementResults& results)
{
    for (const ElementRun& run : outcome.runs) write_path(outcome, run, results);
    const ElementLoading& first = outcome.test.loadings.front();
    if (std::holds_alternative<StressCycles>(first)) write_strength(outcome, results);
    if (std::holds_alternative<StrainCycles>(first)) write_cycles(outcome, results);
}

} // namespace quicksand
