#include "app/run/run_verdict.hpp"

#include "app/run/number_format.hpp"
#include "io/pictures/picture_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// "energy error" of energy_error; a unit is left out, since ratios are judged.
std::string in_words(std::string_view name)
{
    constexpr std::string_view unit = "_J";
    if (name.ends_with(unit)) name.remove_suffix(unit.size());
    std::string words(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string amount(const Finding& finding)
{
    return fmt::format("{} {}", in_words(finding.criterion->quantity),
                       std::isnan(finding.worst) ? "no number" : short_number(finding.worst, 2));
}

std::string what_is_wrong(const Finding& finding)
{
    return fmt::format("{} at t = {} s: {}", amount(finding), short_number(finding.time),
                       finding.criterion->meaning);
}

/// Energy that the run has turned over by each row: the sizes of all terms of the balance [J].
std::vector<double> turnover(const PictureTable& table)
{
    std::vector<double> sum;
    for (const char* name :
         {"kinetic_energy_J", "skeleton_work_J", "gravity_work_J", "base_work_J", "boundary_work_J",
          "numerical_loss_J", "inertia_work_J", "drag_dissipation_J", "storage_energy_water_J"}) {
        const std::vector<double>* values = table.find(name);
        if (values == nullptr) continue;
        sum.resize(values->size(), 0.0);
        for (std::size_t row = 0; row < values->size(); ++row) sum[row] += std::abs((*values)[row]);
    }
    return sum;
}

/// By what the energy errors of the rows count: what is turned over. That with which the run ends counts as
/// it is, unless next to nothing of the energy is left in the balance.
std::vector<double> energy_weights(const PictureTable& table)
{
    constexpr double next_to_nothing = 0.1;
    std::vector<double> weights = turnover(table);
    if (weights.empty()) return weights;
    const double heaviest = *std::max_element(weights.begin(), weights.end());
    if (weights.back() >= next_to_nothing * heaviest) weights.back() = heaviest;
    return weights;
}

/// Energy put in by each row: what there was at the start, and the largest work from outside so far [J].
std::vector<double> energy_put_in(const PictureTable& table)
{
    std::vector<double> sum;
    const auto add = [&](const char* name, auto&& next) {
        const std::vector<double>* values = table.find(name);
        if (values == nullptr || values->empty()) return;
        sum.resize(values->size(), 0.0);
        double so_far = std::max(0.0, values->front());
        for (std::size_t row = 0; row < values->size(); ++row)
            sum[row] += so_far = next(so_far, (*values)[row]);
    };
    for (const char* name : {"kinetic_energy_J", "storage_energy_water_J"})
        add(name, [](double at_start, double) { return at_start; });
    for (const char* name : {"gravity_work_J", "base_work_J", "boundary_work_J"})
        add(name, [](double most, double work) { return std::max(most, std::abs(work)); });
    return sum;
}

/// Kinetic energy of a body that moves with 1e-6 sqrt(g H), as one does that is at rest: m g H / 2 1e-12,
/// with the side of a square of its size for H. What it loses is rounding [J].
double energy_at_rest(const PictureTable& table)
{
    const auto first = [&](const char* name) {
        const std::vector<double>* values = table.find(name);
        return values == nullptr || values->empty() || !(values->front() > 0.0) ? 0.0 : values->front();
    };
    const double mass = first("mass_solid_kg") + first("mass_fluid_kg");
    return 0.5e-12 * mass * standard_gravity * std::sqrt(first("volume_m3"));
}

/// The loss of each row over the energy put in; 0 where there is none.
std::vector<double> loss_ratios(const PictureTable& table, const std::vector<double>& losses)
{
    std::vector<double> given = energy_put_in(table);
    for (double& energy : given) energy += energy_at_rest(table);
    std::vector<double> ratios(losses.size(), 0.0);
    for (std::size_t row = 0; row < std::min(given.size(), losses.size()); ++row)
        if (given[row] > 0.0) ratios[row] = losses[row] / given[row];
    return ratios;
}

std::vector<Finding> judge_rows(const PictureTable& table, const std::vector<double>& times)
{
    std::vector<Finding> findings;
    for (const Criterion& criterion : verdict_criteria()) {
        const std::vector<double>* values = table.find(criterion.quantity);
        if (values == nullptr) continue;
        if (criterion.quantity == "energy_error") {
            findings.push_back(judge(criterion, times, *values, energy_weights(table)));
        } else if (criterion.quantity == "numerical_loss_J") {
            findings.push_back(judge(criterion, times, loss_ratios(table, *values), energy_put_in(table)));
        } else {
            findings.push_back(judge(criterion, times, *values));
        }
    }
    return findings;
}

} // namespace

std::vector<Finding> judge_history(const ResultsFolder& folder)
{
    const PictureTable table = read_picture_table(folder.history());
    const std::vector<double>* times = table.find("time_s");
    return times == nullptr ? std::vector<Finding>() : judge_rows(table, *times);
}

std::string describe_verdict(const std::vector<Finding>& findings, std::int64_t step_halvings)
{
    const Grade grade = worst_grade(findings);
    std::string text = fmt::format("Verdict: {}", name_of(grade));
    for (const Finding& finding : findings) {
        if (grade == Grade::good)
            text += fmt::format("{} {}", &finding == &findings.front() ? "; largest" : ",", amount(finding));
        else if (finding.grade != Grade::good)
            text += "\n  " + what_is_wrong(finding);
    }
    if (step_halvings > 0)
        text += fmt::format("\n  the step that was chosen was too long: the watchdog has halved it {}",
                            step_halvings == 1 ? "once" : fmt::format("{} times", step_halvings));
    return text;
}

std::string explain_bad_verdict(const std::vector<Finding>& findings)
{
    std::string text = "the balances of the run do not close, so its results are not to be used:";
    for (const Finding& finding : findings)
        if (finding.grade == Grade::bad) text += "\n  " + what_is_wrong(finding);
    return text + "\nlikely causes: a time step that is too long for the soil (try half of it, "
                  "analysis.step_share), domains that are torn, a start out of equilibrium or motion above "
                  "the frequencies that the cells resolve (quicksand check tells both)";
}

} // namespace quicksand
