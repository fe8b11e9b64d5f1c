#include "solver/base/history.hpp"

#include "solver/base/overload.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quicksand {

namespace {

double sampled_value(const SampledHistory& table, double time)
{
    if (table.times.empty()) return 0.0;
    const auto after = std::upper_bound(table.times.begin(), table.times.end(), time);
    if (after == table.times.begin()) return table.values.front();
    if (after == table.times.end()) return table.values.back();
    const auto k = static_cast<std::size_t>(after - table.times.begin());
    const double weight = (time - table.times[k - 1]) / (table.times[k] - table.times[k - 1]);
    return (1.0 - weight) * table.values[k - 1] + weight * table.values[k];
}

/// Trapezoids from 0: exact for straight pieces, of which one goes back from 0.
double sampled_integral(const SampledHistory& table, double time)
{
    double integral = 0.0, last_time = 0.0, last_value = sampled_value(table, 0.0);
    const auto reach = [&](double next_time, double next_value) {
        integral += 0.5 * (last_value + next_value) * (next_time - last_time);
        last_time = next_time;
        last_value = next_value;
    };
    for (std::size_t k = 0; k < table.times.size() && table.times[k] < time; ++k) {
        if (table.times[k] > 0.0) reach(table.times[k], table.values[k]);
    }
    reach(time, sampled_value(table, time));
    return integral;
}

double sine_integral(double angular, double ramp_time, double time)
{
    const double rising = std::min(time, ramp_time);
    double integral = 0.0;
    if (ramp_time > 0.0) {
        // int (t / T) sin(w t) dt
        integral = (std::sin(angular * rising) / angular - rising * std::cos(angular * rising)) /
                   (angular * ramp_time);
    }
    return integral + (std::cos(angular * rising) - std::cos(angular * time)) / angular;
}

/// The last two times before `end` at which t sin(w t) turns [s]: tan(w t) = -w t, w t = n pi - atan(w t).
std::array<double, 2> last_turns_of_ramp(double angular, double end)
{
    const double last = std::floor((angular * end + std::atan(angular * end)) / std::numbers::pi);
    std::array<double, 2> times{};
    for (std::size_t k = 0; k < 2; ++k) {
        const double full = (last - static_cast<double>(k)) * std::numbers::pi;
        double angle = full;
        for (int iteration = 0; iteration < 50; ++iteration) angle = full - std::atan(angle);
        times[k] = angle / angular;
    }
    return times;
}

} // namespace

double history_value(const History& history, double time)
{
    const double t = std::max(history.begun + time, 0.0);
    const double rise = t < history.ramp_time ? t / history.ramp_time : 1.0;
    return std::visit(Overload{[&](const ConstantHistory&) { return rise; },
                               [&](const SineHistory& sine) {
                                   return rise * std::sin(2.0 * std::numbers::pi * sine.frequency * t);
                               },
                               [&](const SampledHistory& table) { return sampled_value(table, time); }},
                      history.shape);
}

double history_integral(const History& history, double time)
{
    const double t = std::max(history.begun + time, 0.0);
    return std::visit(Overload{[&](const ConstantHistory&) {
                                   if (history.ramp_time == 0.0) return time;
                                   const double rising = std::min(t, history.ramp_time);
                                   return 0.5 * rising * rising / history.ramp_time + (t - rising);
                               },
                               [&](const SineHistory& sine) {
                                   const auto since_its_start = [&](double end) {
                                       return sine_integral(2.0 * std::numbers::pi * sine.frequency,
                                                            history.ramp_time, end);
                                   };
                                   return since_its_start(t) - since_its_start(history.begun);
                               },
                               [&](const SampledHistory& table) { return sampled_integral(table, time); }},
                      history.shape);
}

History history_from(const History& history, double time)
{
    if (std::holds_alternative<SineHistory>(history.shape))
        return {history.shape, history.ramp_time, history.begun + time};
    const auto* drawn = std::get_if<SampledHistory>(&history.shape);
    if (drawn == nullptr && (history.ramp_time < time || history.ramp_time == 0.0)) return {};
    const SampledHistory table =
        drawn != nullptr ? *drawn : SampledHistory{{0.0, history.ramp_time}, {0.0, 1.0}};
    const auto next = std::lower_bound(table.times.begin(), table.times.end(), time);
    if (next == table.times.end()) return {SampledHistory{{0.0}, {history_value(history, time)}}, 0.0};
    SampledHistory left;
    const auto first = static_cast<std::size_t>(next - table.times.begin());
    for (std::size_t k = first > 0 ? first - 1 : 0; k < table.times.size(); ++k) {
        left.times.push_back(table.times[k] - time);
        left.values.push_back(table.values[k]);
    }
    return {left, 0.0};
}

std::vector<double> turning_times(const History& history, double end)
{
    std::vector<double> times{0.0};
    const auto add = [&](double time) {
        if (time > 0.0 && time < end) times.push_back(time);
    };
    if (const auto* table = std::get_if<SampledHistory>(&history.shape))
        for (const double time : table->times) add(time);
    add(history.ramp_time - history.begun);
    if (const auto* sine = std::get_if<SineHistory>(&history.shape)) {
        // of the ramp those before its end, which grow; then crests and troughs of one period: sin is 1 a
        // quarter later
        const double ramp_end = std::min(history.ramp_time, history.begun + end);
        for (const double time : last_turns_of_ramp(2.0 * std::numbers::pi * sine->frequency, ramp_end))
            add(time - history.begun);
        const double quarter = 0.25 / sine->frequency,
                     first = std::ceil(std::max(history.begun, history.ramp_time) / quarter);
        for (double k = first; k < first + 4.0; ++k) add(k * quarter - history.begun);
    }
    times.push_back(end);
    return times;
}

bool varies(const History& history)
{
    const auto* table = std::get_if<SampledHistory>(&history.shape);
    if (table == nullptr)
        return std::holds_alternative<SineHistory>(history.shape) || history.ramp_time > 0.0;
    const double first = sampled_value(*table, 0.0);
    for (std::size_t k = 0; k < table->times.size(); ++k)
        if (table->times[k] > 0.0 && table->values[k] != first) return true;
    return false;
}

double peak_value(const History& history)
{
    const auto largest = [](const SampledHistory& table) {
        double peak = 0.0;
        for (const double value : table.values) peak = std::max(peak, std::abs(value));
        return peak;
    };
    return std::visit(
        Overload{[](const ConstantHistory&) { return 1.0; }, [](const SineHistory&) { return 1.0; }, largest},
        history.shape);
}

} // namespace quicksand
