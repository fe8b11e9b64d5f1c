#include "solver/element_test_cyclic.hpp"

#include "solver/failure.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double largest_step = 5e-5; // of gamma on the plateau of a liquefied specimen [-]

/// A leg runs from one reversal to the next; leg 0 is the first quarter cycle.
struct Leg {
    int number;
    double from, to; // of the controlled quantity
    double direction() const { return to > from ? 1.0 : -1.0; }
};

/// Place in cycles of a value on a leg: legs end at 0.25, 0.75, 1.25, ...
double cycle_of(const Leg& leg, double value)
{
    const double share = std::clamp((value - leg.from) / (leg.to - leg.from), 0.0, 1.0);
    return leg.number == 0 ? 0.25 * share : 0.5 * leg.number - 0.25 + 0.5 * share;
}

void note_events(const Leg& leg, CyclicTest& test)
{
    const ElementPoint& point = test.path.back();
    const double cycles = 0.5 * leg.number;
    const auto note = [&](bool happens, std::optional<double>& event) {
        if (happens && !event) event = cycles;
    };
    note(point.ru > 0.95, test.cycles_to_ru_95);
    note(std::abs(point.gamma) > 0.03, test.cycles_to_3_percent);
    note(std::abs(point.gamma) > 0.0375, test.cycles_to_375_percent);
}

/// One step of a stress-controlled leg: |d tau| is about `tau_step` and the leg's end is not passed. Returns
/// the shear strain of the step.
double step_stress(const Leg& leg, double tau_step, double guess, Specimen& specimen)
{
    const Specimen before = specimen;
    const double direction = leg.direction();
    double step = guess;
    for (int attempt = 0; attempt < 60; ++attempt) {
        specimen = before;
        strain(0.0, 0.0, direction * step, specimen);
        const double change = direction * (specimen.state.tau_xy - before.state.tau_xy);
        const double room =
            std::min(1.2 * tau_step, direction * (leg.to - before.state.tau_xy) + 1e-4 * tau_step);
        if (std::abs(change) <= 1.2 * tau_step && change <= room) return step;
        step *=
            std::clamp((change > 0.0 ? std::min(tau_step, room) : tau_step) / std::abs(change), 0.1, 0.98);
    }
    return step;
}

/// Follow a leg to its end; false when the test ends before.
bool follow(const Leg& leg, const StressCycles& loading, double tau_step, Specimen& specimen,
            CyclicTest& test)
{
    double step = tau_step / shear_modulus(specimen.law, specimen.state);
    while (leg.direction() * (leg.to - specimen.state.tau_xy) > 1e-3 * tau_step) {
        const double before = specimen.state.tau_xy;
        const double taken = step_stress(leg, tau_step, step, specimen);
        const double change = std::abs(specimen.state.tau_xy - before);
        const double wanted = change > 0.0 ? taken * tau_step / change : largest_step;
        step = std::min({wanted, 1.5 * taken, largest_step});
        test.path.push_back(record(specimen, cycle_of(leg, specimen.state.tau_xy)));
        note_events(leg, test);
        if (std::abs(specimen.gamma) > loading.largest_gamma) return false;
        if (loading.stop_at_ru && test.cycles_to_ru_95) return false;
    }
    return true;
}

} // namespace

CyclicTest shear_cyclically(const UbcSand& law, const Consolidation& start, const StressCycles& loading)
{
    if (!(loading.csr > 0.0)) throw InputError("element test: csr must be positive");
    Specimen specimen = consolidate(law, start);
    CyclicTest test;
    test.path = {record(specimen, 0.0)};
    const double amplitude = loading.csr * start.vertical_stress;
    const int legs = static_cast<int>(std::lround(2.0 * loading.cycles)) + 1;
    Leg leg = {0, start.static_shear, start.static_shear + amplitude};
    while (leg.number < legs && follow(leg, loading, 0.01 * amplitude, specimen, test)) {
        leg = {leg.number + 1, leg.to, start.static_shear - leg.direction() * amplitude};
    }
    return test;
}

CyclicTest shear_cyclically(const UbcSand& law, const Consolidation& start, const StrainCycles& loading)
{
    if (!(loading.gamma > 0.0)) throw InputError("element test: gamma must be positive");
    Specimen specimen = consolidate(law, start);
    CyclicTest test;
    test.path = {record(specimen, 0.0)};
    const int legs = static_cast<int>(std::lround(2.0 * loading.cycles)) + 1;
    Leg leg = {0, 0.0, loading.gamma};
    for (; leg.number < legs; leg = {leg.number + 1, leg.to, -leg.to}) {
        // quarter legs at the start and at the end, which is at gamma = 0
        const double to = leg.number + 1 == legs ? 0.0 : leg.to;
        const double steps =
            std::ceil(loading.steps_per_leg * std::abs(to - leg.from) / (2.0 * loading.gamma));
        for (double k = 0.0; k < steps; k += 1.0) {
            strain(0.0, 0.0, (to - leg.from) / steps, specimen);
            test.path.push_back(record(specimen, cycle_of(leg, specimen.gamma)));
            note_events(leg, test);
        }
    }
    return test;
}

std::optional<double> interpolate_csr(const std::vector<StrengthPoint>& points, double cycles)
{
    for (std::size_t k = 1; k < points.size(); ++k) {
        const StrengthPoint &weak = points[k - 1], &strong = points[k];
        if (cycles > weak.cycles || cycles < strong.cycles || weak.cycles == strong.cycles) continue;
        const double share = std::log(cycles / weak.cycles) / std::log(strong.cycles / weak.cycles);
        return weak.csr * std::pow(strong.csr / weak.csr, share);
    }
    return std::nullopt;
}

double csr_to_ru_95(const UbcSand& law, const Consolidation& start, double cycles)
{
    const auto cycles_at = [&](double csr) {
        const StressCycles loading = {csr, 2.0 * cycles + 5.0, 0.5, true};
        return shear_cyclically(law, start, loading).cycles_to_ru_95.value_or(2.0 * cycles + 5.0);
    };
    // bracket by halves of the range in log CSR; fewer cycles at a higher CSR
    StrengthPoint weak = {0.01, 1e9}, strong = {1.0, 0.0};
    while (strong.csr / weak.csr > 1.04) {
        const double csr = std::sqrt(weak.csr * strong.csr);
        const double reached = cycles_at(csr);
        (reached > cycles ? weak : strong) = {csr, reached};
    }
    return interpolate_csr({weak, strong}, cycles).value_or(std::sqrt(weak.csr * strong.csr));
}

} // namespace quicksand
