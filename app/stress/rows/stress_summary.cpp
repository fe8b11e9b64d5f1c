#include "app/stress/rows/stress_summary.hpp"

#include "app/run/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace quicksand {

namespace {

bool ended_well(const RowOutcome& outcome)
{
    return outcome.end == RowEnd::good || outcome.end == RowEnd::usable;
}

std::string line_of(const RowOutcome& outcome, const std::string& what)
{
    return outcome.row.id() + ": " + what;
}

} // namespace

bool is_silent(const RowOutcome& outcome)
{
    if (!ended_well(outcome)) return false;
    const double energy = std::fmax(std::abs(outcome.energy_error), std::abs(outcome.last_energy_error));
    return energy > worst_energy_error || outcome.water_error > worst_water_error ||
           outcome.loss > worst_loss;
}

bool is_failure(const RowOutcome& outcome)
{
    return outcome.row.step_factor <= 1.0 && !ended_well(outcome) && outcome.end != RowEnd::refused;
}

bool was_halved(const RowOutcome& outcome)
{
    return outcome.row.step_factor <= 1.0 && ended_well(outcome) && outcome.halvings > 0.0;
}

bool is_too_fast(const RowOutcome& outcome)
{
    return outcome.velocity > outcome.row.most_velocity;
}

bool has_poor_margin(const RowOutcome& outcome)
{
    return !std::isnan(outcome.margin) && !(outcome.margin >= least_margin && outcome.margin <= most_margin);
}

void compare_twins(std::vector<RowOutcome>& outcomes)
{
    std::map<std::string, const RowOutcome*> by_name;
    for (const RowOutcome& outcome : outcomes) by_name[outcome.row.id()] = &outcome;
    for (RowOutcome& outcome : outcomes) {
        if (outcome.row.twin.empty()) continue;
        const auto twin = by_name.find(outcome.row.group + "/" + outcome.row.twin);
        if (twin == by_name.end() || !ended_well(outcome) || !ended_well(*twin->second)) continue;
        const double larger = std::max(outcome.displacement, twin->second->displacement);
        const double apart = std::abs(outcome.displacement - twin->second->displacement);
        outcome.disagreement = larger > 0.0 ? apart / larger : 0.0;
    }
}

StressSummary summarize(const std::vector<RowOutcome>& outcomes)
{
    StressSummary summary;
    summary.rows = outcomes.size();
    summary.ends.assign(static_cast<std::size_t>(RowEnd::overtime) + 1, 0);
    for (const RowOutcome& outcome : outcomes) {
        ++summary.ends[static_cast<std::size_t>(outcome.end)];
        if (is_silent(outcome))
            summary.silent.push_back(line_of(
                outcome,
                fmt::format("energy error {} ({} at the end), loss {}, water error {}",
                            short_number(outcome.energy_error, 2), short_number(outcome.last_energy_error, 2),
                            short_number(outcome.loss, 2), short_number(outcome.water_error, 2))));
        if (is_failure(outcome))
            summary.failures.push_back(
                line_of(outcome, fmt::format("{}: {}", name_of(outcome.end), outcome.reason)));
        if (!outcome.bad_file.empty()) summary.unreadable.push_back(line_of(outcome, outcome.bad_file));
        if (is_too_fast(outcome))
            summary.too_fast.push_back(
                line_of(outcome, fmt::format("{} m/s, at most {}", short_number(outcome.velocity, 2),
                                             short_number(outcome.row.most_velocity))));
        if (was_halved(outcome))
            summary.halved.push_back(line_of(outcome, fmt::format("{} times", outcome.halvings)));
        if (has_poor_margin(outcome))
            summary.poor_margins.push_back(line_of(outcome, short_number(outcome.margin, 3)));
        if (outcome.disagreement > most_disagreement)
            summary.disagreeing.push_back(line_of(
                outcome, fmt::format("{:.3g} % from {}", 100.0 * outcome.disagreement, outcome.row.twin)));
    }
    return summary;
}

} // namespace quicksand
