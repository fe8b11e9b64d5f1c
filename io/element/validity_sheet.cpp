#include "io/element/validity_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace quicksand {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Band {
    double low = -infinity, high = infinity;
};

/// A quantity of the table.
struct Row {
    std::string name;
    int decimals;
    std::function<std::optional<double>(const SandSurvey&)> value;
    std::function<std::optional<Band>(double)> band; // of a blow count; none: not judged
    std::string expected;
};

/// CRR of 15 cycles at one atmosphere [IB08].
double triggering_curve(double N)
{
    return std::exp(N / 14.1 + std::pow(N / 126.0, 2) - std::pow(N / 23.6, 3) + std::pow(N / 25.4, 4) - 2.8);
}

/// K_sigma at 800 kPa [IB08].
double confining_effect(double N)
{
    const double C = std::min(0.3, 1.0 / (18.9 - 2.55 * std::sqrt(N)));
    return std::min(1.1, 1.0 - C * std::log(8.0));
}

/// Volumetric strain of reconsolidation after a shear strain of 8 % and more [YWS06, IB08].
double reconsolidation_strain(double N)
{
    return 1.5 * std::exp(-0.369 * std::sqrt(N)) * 0.08;
}

std::function<std::optional<Band>(double)> between(double low, double high)
{
    return [=](double) { return Band{low, high}; };
}

std::vector<Row> strength_rows()
{
    return {
        {"CSR(15) over the triggering curve", 2, // by its N
         nullptr, between(0.92, 1.08), "1 ± 0.08 [IB08]"},
        {"slope b of CSR ~ N^-b, 10 to 30 cycles", 2,
         [](const SandSurvey& s) { return s.strength ? std::optional(s.strength->slope) : std::nullopt; },
         between(0.2, 0.4), "0.2 to 0.4; 0.34 usual [IB08]"},
        {"K_sigma at 800 kPa", 2, [](const SandSurvey& s) { return s.k_sigma; },
         [](double N) {
             return Band{confining_effect(N) - 0.07, confining_effect(N) + 0.07};
         },
         "0.84 (N = 6), 0.79 (12), 0.70 (22), ± 0.07 [IB08]"},
        {"strength at K0 = 1 over K0 = 0.5", 2, [](const SandSurvey& s) { return s.k_0; },
         between(0.95, 1.65), "1.1 to 1.5, ± 0.15: by the mean stress [IY85]"},
        {"K_alpha at alpha = 0.1", 2, [](const SandSurvey& s) { return s.k_alpha; },
         [](double N) {
             return N >= 9.0 ? std::optional(Band{0.75, 1.45}) : std::nullopt;
         },
         "from N = 9 on 0.9 to 1.3, ± 0.15, rising with density [IB08]"},
    };
}

std::vector<Row> liquefaction_rows()
{
    const auto strain_of = [](std::size_t cycle) {
        return [cycle](const SandSurvey& s) {
            return s.strain_of_cycles.empty() ? std::nullopt
                                              : std::optional(100.0 * s.strain_of_cycles[cycle]);
        };
    };
    const auto least_growth = [](const SandSurvey& s) {
        if (s.strain_of_cycles.empty()) return std::optional<double>();
        double least = infinity;
        for (std::size_t k = 1; k < s.strain_of_cycles.size(); ++k)
            least = std::min(least, s.strain_of_cycles[k] / s.strain_of_cycles[k - 1]);
        return std::optional(least);
    };
    return {
        {"shear strain in the cycle of ru = 0.95 [%]", 1, strain_of(0), [](double) { return std::nullopt; },
         ""},
        {"five cycles later [%]", 1, strain_of(5),
         [](double N) {
             return N <= 16.0 ? std::optional(Band{3.0, infinity}) : std::nullopt;
         },
         "above 3 for N up to 16"},
        {"least growth from one of the cycles to the next", 2, least_growth, between(1.005, infinity),
         "above 1: it grows in every cycle"},
        {"stress out of the plane over its failure limit", 2,
         [](const SandSurvey& s) { return std::optional(s.most_out_of_plane); }, between(0.0, 1.0001),
         "at most 1"},
        {"reconsolidation strain after 8 % of shear strain [%]", 2,
         [](const SandSurvey& s) { return std::optional(100.0 * s.reconsolidation); },
         [](double N) {
             return Band{100.0 * reconsolidation_strain(N) / 1.5, 100.0 * reconsolidation_strain(N) * 1.5};
         },
         "4.9 (N = 6), 3.3 (12), 2.1 (22), a factor of 1.5 [YWS06]"},
    };
}

std::vector<Row> small_strain_rows()
{
    const auto modulus = [](std::size_t k) {
        return [k](const SandSurvey& s) { return std::optional(s.curve[k].modulus_ratio); };
    };
    const auto damping = [](std::size_t k) {
        return [k](const SandSurvey& s) { return std::optional(100.0 * s.curve[k].damping_ratio); };
    };
    return {
        {"G/Gmax at a shear strain of 0.01 %", 2, modulus(1), between(0.70, 0.92),
         "0.70 to 0.92 [SI70, D01]"},
        {"at 0.03 %", 2, modulus(2), between(0.48, 0.74), "0.48 to 0.74"},
        {"at 0.1 %", 2, modulus(3), between(0.22, 0.44), "0.22 to 0.44"},
        {"damping at 0.001 % [%]", 2, damping(0), between(0.4, 1.6), "0.4 to 1.6 [SI70, D01]"},
        {"at 0.01 %", 1, damping(1), between(1.5, 5.0), "1.5 to 5"},
        {"at 0.1 %", 1, damping(3), between(8.0, 18.0), "8 to 18"},
    };
}

std::optional<double> value_of(const Row& row, const SurveyedSand& sand)
{
    if (row.value) return row.value(sand.survey);
    if (!sand.survey.strength) return std::nullopt;
    return sand.survey.strength->csr_15 / triggering_curve(sand.n1_60);
}

/// Without a sign where nothing is left of the number.
std::string rounded_text(double value, int decimals)
{
    const double unit = std::pow(10.0, -decimals);
    return fmt::format("{:.{}f}", std::abs(value) < 0.5 * unit ? 0.0 : value, decimals);
}

std::string line_of(const Row& row, const std::vector<SurveyedSand>& sands, int& met, int& judged)
{
    std::string line = "| " + row.name + " |";
    int met_here = 0, judged_here = 0;
    for (const SurveyedSand& sand : sands) {
        const std::optional<double> value = value_of(row, sand);
        const std::optional<Band> band = row.band(sand.n1_60);
        const bool inside = value && band && *value >= band->low && *value <= band->high;
        judged_here += band ? 1 : 0;
        met_here += inside ? 1 : 0;
        const std::string text = value ? rounded_text(*value, row.decimals) : "none";
        line += band && !inside ? " **" + text + "** |" : " " + text + " |";
    }
    met += met_here, judged += judged_here;
    return line + " " + row.expected + " | " +
           (judged_here > 0 ? fmt::format("{} of {}", met_here, judged_here) : "-") + " |\n";
}

} // namespace

std::string validity_table(const std::vector<SurveyedSand>& sands, int& met, int& judged)
{
    std::string head = "| quantity, (N1)60 = |", rule = "|---|";
    for (const SurveyedSand& sand : sands) head += fmt::format(" {:g} |", sand.n1_60), rule += "---|";
    std::string table = head + " expected | met |\n" + rule + "---|---|\n";
    for (const std::vector<Row>& rows : {strength_rows(), liquefaction_rows(), small_strain_rows()})
        for (const Row& row : rows) table += line_of(row, sands, met, judged);
    return table;
}

std::string validity_sources()
{
    return "Strength is that of 15 uniform cycles of undrained simple shear at 100 kPa and K0 = 0.5, to ru > "
           "0.95; under a\n"
           "static shear to a shear strain of 3 % if that comes first. Modulus and damping are those of the "
           "second cycle of\n"
           "drained simple shear. PM4Sand of the report reconsolidates with its post-shaking option. Bold: "
           "outside the band.\n\n"
           "- [IB08] Idriss and Boulanger (2008): triggering curve, K_sigma, K_alpha\n"
           "- [IY85] Ishihara and co-workers: cyclic strength under different K0 goes with the mean stress\n"
           "- [YWS06] Yoshimine, Nishizaki, Amano and Hosono (2006), after Ishihara and Yoshimine (1992)\n"
           "- [SI70, D01] Seed and Idriss (1970) and Darendeli (2001) at one atmosphere: the range of both "
           "with their scatter\n";
}

} // namespace quicksand
