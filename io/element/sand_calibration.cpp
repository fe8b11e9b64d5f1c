#include "io/element/sand_calibration.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/element/element_data.hpp"
#include "io/element/element_file.hpp"
#include "io/element/element_keys.hpp"
#include "io/files/csv_file.hpp"
#include "io/keys/scene_units.hpp"
#include "solver/base/failure.hpp"
#include "solver/base/parallel_tasks.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

namespace quicksand {

namespace {

constexpr double largest_factor = 20.0;   // by which a key may change [-]
constexpr int most_evaluations = 60;      // of the law's fit [-]
constexpr double factor_tolerance = 1e-2; // of a key, relative [-]
constexpr double weak_law = 1e3;          // root mean square of a law that its keys refuse [-]

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& what)
{
    throw InputError(
        "'" + file.string() + "': " + what +
        "\nallowed: one line of column names with CSR and N, and if you like alpha, k0, sigma_v and "
        "criterion, then rows of numbers, as 0.15,12");
}

/// The row's cell of a column, "" where there is none.
std::string cell_of(const CsvRow& names, const CsvRow& cells, std::string_view column)
{
    for (std::size_t k = 0; k < std::min(names.size(), cells.size()); ++k)
        if (names[k] == column) return cells[k];
    return "";
}

LiquefactionCriterion criterion_of(const std::filesystem::path& file, const std::string& word)
{
    if (const auto criterion = find_criterion(word)) return *criterion;
    refuse(file, "criterion " + word +
                     " is none of ru_95, strain_3_percent, strain_3.75_percent and double_7.5_percent");
}

StrengthObservation observation_of(const std::filesystem::path& file, const CsvRow& names,
                                   const CsvRow& cells, const StrengthObservation& usual)
{
    const auto number = [&](std::string_view column, double otherwise) {
        const std::string cell = cell_of(names, cells, column);
        if (cell.empty()) return otherwise;
        const auto quantity = split_quantity(cell);
        if (!quantity || !quantity->unit.empty() || !std::isfinite(quantity->number))
            refuse(file, "'" + cell + "' is no number");
        return quantity->number;
    };
    StrengthObservation point = usual;
    point.csr = number("CSR", 0.0);
    point.cycles = number("N", 0.0);
    point.static_shear_ratio = number("alpha", point.static_shear_ratio);
    point.k0 = number("k0", point.k0);
    point.vertical_stress = number("sigma_v", point.vertical_stress);
    if (const std::string word = cell_of(names, cells, "criterion"); !word.empty())
        point.criterion = criterion_of(file, word);
    const bool good = point.csr > 0.0 && point.cycles > 0.0 && point.k0 > 0.0 && point.vertical_stress > 0.0;
    if (!good) refuse(file, "CSR, N, k0 and sigma_v must be positive");
    if (point.csr > largest_stress_ratio) refuse(file, "a CSR of " + cell_of(names, cells, "CSR") + no_ratio);
    return point;
}

/// `turned` is the shear strain at the last reversal [-].
bool meets(LiquefactionCriterion criterion, double turned, const ElementPoint& point)
{
    switch (criterion) {
    case LiquefactionCriterion::ru_95:
        return point.ru > 0.95;
    case LiquefactionCriterion::strain_3_percent:
        return std::abs(point.gamma) > 0.03;
    case LiquefactionCriterion::strain_375_percent:
        return std::abs(point.gamma) > 0.0375;
    case LiquefactionCriterion::double_amplitude_75_percent:
        return point.cycle > 0.25 && std::abs(point.gamma - turned) > 0.075;
    }
    return false;
}

/// What the optimiser varies, and what it compares.
struct Fit {
    const std::filesystem::path& file;
    const std::vector<std::string>& overrides;
    const std::vector<StrengthObservation>& observations;
    SandCalibration& result;

    /// Cycles of the points with the keys by factors.
    std::vector<double> cycles(const double* logarithms) const
    {
        std::vector<std::string> changed = overrides;
        for (std::size_t k = 0; k < result.keys.size(); ++k)
            changed.push_back(fmt::format("{}={:.6g}", result.keys[k].path,
                                          result.keys[k].start * std::exp(logarithms[k])));
        const SkeletonLaw law = read_element_file(file, changed).programme.tests.front().soil.law;
        std::vector<double> cycles(observations.size());
        rethrow_first(
            attempt_each(cycles.size(), [&](std::size_t k) { cycles[k] = cycles_of(law, observations[k]); }));
        return cycles;
    }

    double error(const std::vector<double>& cycles) const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < cycles.size(); ++k)
            sum += std::pow(std::log(cycles[k] / observations[k].cycles), 2);
        return std::sqrt(sum / static_cast<double>(cycles.size()));
    }
};

/// For the optimiser; keys that make no soil are far from any fit.
double error_of(unsigned, const double* logarithms, double*, void* fit)
{
    const Fit& data = *static_cast<Fit*>(fit);
    ++data.result.evaluations;
    try {
        return data.error(data.cycles(logarithms));
    } catch (const InputError&) {
        return weak_law;
    }
}

void refuse_unknown(const std::string& path)
{
    const std::string name = path.substr(path.rfind('.') + 1);
    std::vector<std::string> names;
    for (const SceneKey* key : keys_of_table(element_key_table(), "materials.*"))
        names.emplace_back(key->pattern.substr(key->pattern.rfind('.') + 1));
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    const std::string nearest = nearest_name(name, names);
    throw InputError("calibrate: " + path + " is no key of a sand" +
                     (nearest.empty() ? "" : "\nhint: did you mean " + nearest + "?"));
}

FittedKey fitted_key(const ElementReading& reading, const std::string& path)
{
    for (const ResolvedKey& key : reading.keys) {
        const auto quantity = split_quantity(key.value);
        if (key.path == path && quantity && quantity->number > 0.0)
            return {path, quantity->number, quantity->number};
    }
    refuse_unknown(path);
    throw InputError("calibrate: " + path + " has no positive number to begin with" +
                     "\nhint: give it one in the file or with --set, or name another key after --fit");
}

} // namespace

StrengthObservation conditions_of_first_test(const std::filesystem::path& test_file,
                                             const std::vector<std::string>& overrides)
{
    const ElementReading reading = read_element_file(test_file, overrides);
    const ElementTest& test = reading.programme.tests.front();
    const Consolidation& start = test.specimens.front().start;
    StrengthObservation point;
    point.vertical_stress = start.vertical_stress;
    point.k0 = start.k0;
    point.static_shear_ratio = start.static_shear / start.vertical_stress;
    point.criterion = test.criterion;
    return point;
}

std::vector<StrengthObservation> read_observations(const std::filesystem::path& file,
                                                   const StrengthObservation& usual)
{
    std::ifstream stream(file);
    if (!stream) throw InputError("there is no file " + file.string());
    CsvRow names;
    std::vector<StrengthObservation> points;
    for (std::string line; std::getline(stream, line);) {
        std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        if (line.empty() || line.starts_with('#')) continue;
        const CsvRow cells = csv_cells(line);
        if (names.empty()) {
            names = cells;
            for (const char* needed : {"CSR", "N"})
                if (std::find(names.begin(), names.end(), needed) == names.end())
                    refuse(file, std::string("it has no column ") + needed);
        } else {
            points.push_back(observation_of(file, names, cells, usual));
        }
    }
    if (points.empty()) refuse(file, "it holds no points");
    return points;
}

double longest_test(const StrengthObservation& observation)
{
    return 2.0 * observation.cycles + 1.0;
}

double cycles_of(const SkeletonLaw& law, const StrengthObservation& observation)
{
    constexpr double least = 0.05;
    const double most = longest_test(observation);
    const Consolidation start = {observation.vertical_stress, observation.k0,
                                 observation.static_shear_ratio * observation.vertical_stress};
    const bool by_strain = observation.criterion != LiquefactionCriterion::ru_95;
    const bool by_range = observation.criterion == LiquefactionCriterion::double_amplitude_75_percent;
    const StressCycles loading = {observation.csr, most, by_strain && !by_range ? 0.04 : 0.5,
                                  by_strain ? most : 0.0};
    double ru = 0.0, gamma = 0.0, turned = 0.0, half_cycles = 0.0;
    double last = 0.0; // shear strain of the point before [-]
    for (const ElementPoint& point : shear_cyclically(law, start, loading).path) {
        const double legs = std::floor(2.0 * point.cycle + 0.5 - 1e-9); // reversals are at 0.25, 0.75, ...
        if (legs > half_cycles) turned = last;
        half_cycles = legs;
        last = point.gamma;
        if (meets(observation.criterion, turned, point)) return std::max(least, point.cycle);
        ru = std::max(ru, point.ru);
        gamma = std::max(gamma, std::abs(point.gamma));
    }
    // a number that falls as the test comes nearer to the criterion shows the optimiser the way
    return most * (3.0 - std::min(1.0, ru / 0.95) - std::min(1.0, gamma / 0.0375));
}

SandCalibration calibrate_sand(const std::filesystem::path& test_file,
                               const std::vector<std::string>& overrides,
                               const std::vector<std::string>& keys,
                               const std::vector<StrengthObservation>& observations)
{
    SandCalibration result;
    const ElementReading reading = read_element_file(test_file, overrides);
    const std::string material = "materials." + reading.programme.tests.front().material + ".";
    for (const std::string& key : keys) result.keys.push_back(fitted_key(reading, material + key));
    Fit fit{test_file, overrides, observations, result};
    std::vector<double> logarithms(keys.size(), 0.0);
    result.cycles_before = fit.cycles(logarithms.data());
    result.error_before = fit.error(result.cycles_before);

    const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimiser(
        nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(keys.size())), nlopt_destroy);
    nlopt_set_min_objective(optimiser.get(), error_of, &fit);
    nlopt_set_lower_bounds1(optimiser.get(), -std::log(largest_factor));
    nlopt_set_upper_bounds1(optimiser.get(), std::log(largest_factor));
    nlopt_set_initial_step1(optimiser.get(), 0.2);
    nlopt_set_xtol_abs1(optimiser.get(), factor_tolerance);
    nlopt_set_maxeval(optimiser.get(), most_evaluations);
    double least = 0.0;
    if (nlopt_optimize(optimiser.get(), logarithms.data(), &least) < 0)
        throw NumericalError({"calibration", "the optimiser found no fit", "try other keys"});
    for (std::size_t k = 0; k < keys.size(); ++k)
        result.keys[k].value = result.keys[k].start * std::exp(logarithms[k]);
    result.cycles_after = fit.cycles(logarithms.data());
    result.error_after = fit.error(result.cycles_after);
    return result;
}

} // namespace quicksand
