#include "solver/element/cyclic_laboratory.hpp"

#include "solver/base/failure.hpp"
#include "solver/element/held_stress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace quicksand {

namespace {

// UBCSAND is integrated to first order: with this step the mean stress at the peaks is right to 0.2 %.
constexpr double stress_step = 0.004;         // elastic stress of a step over tau_a [-]
constexpr double least_csr = 0.01;            // from which strength is searched [-]
constexpr double largest_csr = 2.0;           // up to which [-]
constexpr double reconsolidation_step = 1.02; // of the vertical stress over the one before [-]
constexpr double leg_tolerance = 1e-3;        // of a stress step, within which a leg has ended [-]

// Distances between points of the path.
constexpr double tau_resolution = 0.02;   // over tau_a [-]
constexpr double gamma_resolution = 2e-4; // [-]

/// A leg runs from one reversal to the next; leg 0 is the first quarter cycle.
struct Leg {
    int number;
    double from, to; // of the controlled quantity
    double direction() const { return to > from ? 1.0 : -1.0; }
};

/// Place in cycles of a value on a leg: legs end at 0.25, 0.75, 1.25, ...
double cycle_of(const Leg& leg, double value)
{
    const double fraction = std::clamp((value - leg.from) / (leg.to - leg.from), 0.0, 1.0);
    return leg.number == 0 ? 0.25 * fraction : 0.5 * leg.number - 0.25 + 0.5 * fraction;
}

/// Half cycles are counted at the reversals.
double cycles_of(const Leg& leg)
{
    return 0.5 * leg.number;
}

/// `turned` is the shear strain at which the leg began [-].
void note_events(const Leg& leg, double turned, const ElementPoint& point, CyclicTest& test)
{
    const double cycles = cycles_of(leg);
    const auto note = [&](bool happens, std::optional<double>& event) {
        if (happens && !event) event = cycles;
    };
    note(point.ru > 0.95, test.cycles_to_ru_95);
    note(std::abs(point.gamma) > 0.03, test.cycles_to_3_percent);
    note(std::abs(point.gamma) > 0.0375, test.cycles_to_375_percent);
    note(leg.number > 0 && std::abs(point.gamma - turned) > 0.075, test.cycles_to_75_double);
}

/// One step of a stress-controlled leg: the elastic stress of its strain is `tau_step`, so that the steps are
/// fine where the specimen is soft; the last step ends the leg. `before` is room for the specimen.
void step_stress(const Leg& leg, double tau_step, Specimen& before, Specimen& specimen)
{
    before = specimen;
    double step = leg.direction() * tau_step / shear_modulus(specimen);
    for (int attempt = 0; attempt < 60; ++attempt) {
        if (attempt > 0) specimen = before;
        strain(0.0, 0.0, step, specimen);
        const double beyond = leg.direction() * (specimen.tau() - leg.to);
        if (beyond <= leg_tolerance * tau_step) return;
        step *= (leg.to - before.tau()) / (specimen.tau() - before.tau());
    }
}

bool worth_recording(const ElementPoint& point, const ElementPoint& last, double amplitude)
{
    return std::abs(point.tau - last.tau) >= tau_resolution * amplitude ||
           std::abs(point.gamma - last.gamma) >= gamma_resolution;
}

/// Follow a leg to its end; false when the test ends before.
bool follow(const Leg& leg, const StressCycles& loading, double amplitude, Specimen& specimen,
            CyclicTest& test)
{
    const double tau_step = stress_step * amplitude, turned = test.path.back().gamma;
    Specimen before = specimen; // its arrays are made once
    bool ends = false, stops = false;
    while (!ends && !stops) {
        step_stress(leg, tau_step, before, specimen);
        const ElementPoint point = record(specimen, cycle_of(leg, specimen.tau()));
        note_events(leg, turned, point, test);
        ends = leg.direction() * (leg.to - point.tau) <= leg_tolerance * tau_step;
        stops = std::abs(point.gamma) > loading.largest_gamma ||
                (test.cycles_to_ru_95 && cycles_of(leg) - *test.cycles_to_ru_95 >= loading.cycles_after);
        if (ends || stops || worth_recording(point, test.path.back(), amplitude)) test.path.push_back(point);
    }
    return !stops;
}

std::optional<double> cycles_to_ru_95(const CyclicTest& test)
{
    return test.cycles_to_ru_95;
}

/// Strengths of one specimen. The searches for several numbers of cycles bisect the same range of CSR and use
/// the same tests.
class StrengthSearch {
public:
    /// How many cycles a test took, and the strain at which it may end.
    using Count = std::optional<double> (*)(const CyclicTest&);

    StrengthSearch(const SkeletonLaw& law, const Consolidation& start, double most_cycles,
                   Count count = cycles_to_ru_95, double largest_gamma = 0.5)
        : law_(law), start_(start), most_cycles_(most_cycles), count_(count), largest_gamma_(largest_gamma)
    {
    }

    /// CSR to the criterion in N cycles; log-log interpolation between the halves. None beyond the search.
    std::optional<double> csr_at(double cycles)
    {
        const double fewer = std::max(0.5, std::floor(2.0 * cycles) / 2.0), more = fewer + 0.5;
        const double strong = middle(fewer);
        const double weak = cycles <= fewer ? strong : middle(more);
        if (strong > 0.99 * largest_csr || weak < 1.01 * least_csr) return std::nullopt;
        if (cycles <= fewer) return strong;
        return interpolate_csr({{weak, more}, {strong, fewer}}, cycles).value_or(strong);
    }

private:
    /// Cycles to the criterion, without end where they are more than most_cycles.
    double cycles_at(double csr)
    {
        const auto known = known_.find(csr);
        if (known != known_.end()) return known->second;
        const StressCycles loading = {csr, most_cycles_, largest_gamma_, 0.0};
        const auto cycles = count_(shear_cyclically(law_, start_, loading));
        return known_[csr] = cycles.value_or(std::numeric_limits<double>::infinity());
    }

    /// Least CSR that reaches it within N cycles.
    double least(double cycles)
    {
        double below = least_csr, above = largest_csr;
        while (above / below > 1.002) {
            const double csr = std::sqrt(below * above);
            (cycles_at(csr) <= cycles ? above : below) = csr;
        }
        return above;
    }

    /// Middle of the range of CSR that reaches it at N cycles, a whole number of halves.
    double middle(double cycles) { return std::sqrt(least(cycles) * least(cycles - 0.5)); }

    const SkeletonLaw& law_;
    const Consolidation& start_;
    double most_cycles_;
    Count count_;
    double largest_gamma_;           // [-]
    std::map<double, double> known_; // cycles by CSR
};

} // namespace

CyclicTest shear_cyclically(const SkeletonLaw& law, const Consolidation& start, const StressCycles& loading)
{
    if (!(loading.csr > 0.0)) throw InputError("element test: csr must be positive");
    Specimen specimen = consolidate(law, start);
    CyclicTest test;
    test.path = {record(specimen, 0.0)};
    const double amplitude = loading.csr * start.vertical_stress;
    const int legs = static_cast<int>(std::lround(2.0 * loading.cycles)) + 1;
    Leg leg = {0, start.static_shear, start.static_shear + amplitude};
    while (leg.number < legs && follow(leg, loading, amplitude, specimen, test)) {
        leg = {leg.number + 1, leg.to, start.static_shear - leg.direction() * amplitude};
    }
    return test;
}

namespace {

void shear_by(double step, Drainage drainage, double vertical_stress, Specimen& specimen)
{
    if (drainage == Drainage::undrained) return strain(0.0, 0.0, step, specimen);
    const auto apply = [&](double vertical, Specimen& s) { strain(0.0, vertical, step, s); };
    hold(
        vertical_stress, constrained_modulus(specimen), apply, [](const Specimen& s) { return s.sigma_y(); },
        specimen);
}

/// Steps of a way of the shear strain [-]. Where the vertical stress is held they are short: at large strains
/// it changes by per cents in a longer one, which no strain of the specimen holds.
double steps_over_way(const StrainCycles& loading, double way)
{
    constexpr double longest_held = 2e-5; // step [-]
    const double steps = loading.steps_per_leg * way / (2.0 * loading.gamma);
    return std::ceil(loading.drainage == Drainage::drained ? std::max(steps, way / longest_held) : steps);
}

CyclicTest shear_cyclically(const StrainCycles& loading, const Consolidation& start, Specimen& specimen)
{
    CyclicTest test;
    test.path = {record(specimen, 0.0)};
    const int legs = static_cast<int>(std::lround(2.0 * loading.cycles)) + 1;
    Leg leg = {0, 0.0, loading.gamma};
    for (; leg.number < legs; leg = {leg.number + 1, leg.to, -leg.to}) {
        // quarter legs at the start and at the end, which is at gamma = 0
        const double to = leg.number + 1 == legs ? 0.0 : leg.to;
        const double steps = steps_over_way(loading, std::abs(to - leg.from));
        for (double k = 0.0; k < steps; k += 1.0) {
            shear_by((to - leg.from) / steps, loading.drainage, start.vertical_stress, specimen);
            const ElementPoint point = record(specimen, cycle_of(leg, specimen.gamma));
            note_events(leg, leg.from, point, test);
            if (std::fmod(k + 1.0, 4.0) == 0.0 || k + 1.0 == steps) test.path.push_back(point);
        }
    }
    return test;
}

/// Shear on, at constant volume and at most to a strain, to where the vertical stress is least: liquefied
/// sand that has dilated on its last leg has no stress for the water to leave.
void shear_to_least_stress(double largest_gamma, Specimen& specimen, ElementPath& path)
{
    constexpr int steps = 200;
    const double step = (largest_gamma - specimen.gamma) / steps, cycle = path.back().cycle;
    Specimen ahead = specimen;
    double least = specimen.sigma_y();
    int wanted = 0;
    for (int k = 1; k <= steps; ++k) {
        strain(0.0, 0.0, step, ahead);
        if (ahead.sigma_y() < least) least = ahead.sigma_y(), wanted = k;
    }
    for (int k = 0; k < wanted; ++k) {
        strain(0.0, 0.0, step, specimen);
        path.push_back(record(specimen, cycle));
    }
}

} // namespace

CyclicTest shear_cyclically(const SkeletonLaw& law, const Consolidation& start, const StrainCycles& loading)
{
    if (!(loading.gamma > 0.0)) throw InputError("element test: gamma must be positive");
    Specimen specimen = consolidate(law, start);
    return shear_cyclically(loading, start, specimen);
}

CyclicTest reconsolidate(const SkeletonLaw& law, const SkeletonLaw& settling, const Consolidation& start,
                         const Reconsolidation& loading)
{
    if (!(loading.gamma > 0.0)) throw InputError("element test: gamma must be positive");
    Specimen specimen = consolidate(law, start);
    CyclicTest test = shear_cyclically(StrainCycles{loading.gamma, loading.cycles}, start, specimen);
    shear_to_least_stress(loading.gamma, specimen, test.path);
    test.drained_from = test.path.size() - 1;
    specimen.law = settling;
    const double cycle = test.path.back().cycle;
    const auto apply = [](double step, Specimen& s) { strain(0.0, step, 0.0, s); };
    for (double stress = specimen.sigma_y(); stress < start.vertical_stress;) {
        stress = std::min(start.vertical_stress, reconsolidation_step * stress);
        hold(
            stress, constrained_modulus(specimen), apply, [](const Specimen& s) { return s.sigma_y(); },
            specimen);
        test.path.push_back(record(specimen, cycle));
    }
    return test;
}

std::vector<CycleSummary> summarize_cycles(const ElementPath& path)
{
    // peaks are at 0.25, 1.25, ...; the loop between two of them is closed by a straight line
    std::vector<CycleSummary> cycles;
    std::size_t begin = 0;
    while (begin < path.size() && path[begin].cycle < 0.25 - 1e-6) ++begin;
    for (int cycle = 1; begin < path.size(); ++cycle) {
        std::size_t end = begin;
        const ElementPoint* trough = &path[begin];
        double work = 0.0, ru = path[begin].ru;
        while (end + 1 < path.size() && path[end].cycle < cycle + 0.25 - 1e-6) {
            ++end;
            work += 0.5 * (path[end].tau + path[end - 1].tau) * (path[end].gamma - path[end - 1].gamma);
            ru = std::max(ru, path[end].ru);
            if (path[end].gamma < trough->gamma) trough = &path[end];
        }
        if (path[end].cycle < cycle + 0.25 - 1e-6) break;
        const ElementPoint &peak = path[begin], &next = path[end];
        work -= 0.5 * (next.tau + peak.tau) * (next.gamma - peak.gamma);
        const double gamma = 0.5 * (peak.gamma - trough->gamma), tau = 0.5 * (peak.tau - trough->tau);
        cycles.push_back({cycle, gamma, tau / gamma, work / (2.0 * std::numbers::pi * tau * gamma), ru});
        begin = end;
    }
    return cycles;
}

std::optional<double> interpolate_csr(const std::vector<StrengthPoint>& points, double cycles)
{
    for (std::size_t k = 1; k < points.size(); ++k) {
        const StrengthPoint &weak = points[k - 1], &strong = points[k];
        if (cycles > weak.cycles || cycles < strong.cycles || weak.cycles == strong.cycles) continue;
        const double fraction = std::log(cycles / weak.cycles) / std::log(strong.cycles / weak.cycles);
        return weak.csr * std::pow(strong.csr / weak.csr, fraction);
    }
    return std::nullopt;
}

std::optional<double> csr_to_ru_95(const SkeletonLaw& law, const Consolidation& start, double cycles)
{
    return StrengthSearch(law, start, cycles + 0.5).csr_at(cycles);
}

std::optional<double> csr_to_liquefaction(const SkeletonLaw& law, const Consolidation& start, double cycles)
{
    constexpr double just_beyond = 0.0301; // [-]
    return StrengthSearch(law, start, cycles + 0.5, cycles_to_liquefaction, just_beyond).csr_at(cycles);
}

std::optional<double> cycles_to_liquefaction(const CyclicTest& test)
{
    const auto ru = test.cycles_to_ru_95, strain = test.cycles_to_3_percent;
    if (!ru || !strain) return ru ? ru : strain;
    return std::min(*ru, *strain);
}

std::optional<CyclicStrength> cyclic_strength(const SkeletonLaw& law, const Consolidation& start)
{
    if (memory_of(law).empty()) return std::nullopt;
    StrengthSearch search(law, start, 30.0);
    const auto csr_10 = search.csr_at(10.0), csr_15 = search.csr_at(15.0), csr_30 = search.csr_at(30.0);
    if (!csr_10 || !csr_15 || !csr_30) return std::nullopt;
    return CyclicStrength{*csr_15, std::log(*csr_10 / *csr_30) / std::log(3.0)};
}

} // namespace quicksand
