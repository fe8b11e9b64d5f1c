#include "solver/reconsolidation/shaking_history.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double most_shear = 0.08;      // that counts for reconsolidation [-] [YWS06]
constexpr double liquefied_stress = 0.1; // of s_0, at which sand has liquefied [-]

} // namespace

ShakingHistory history_at(std::size_t first, SoilMemory& memory)
{
    return {memory[first].data(),     memory[first + 1].data(), memory[first + 2].data(),
            memory[first + 3].data(), memory[first + 4].data(), memory[first + 5].data()};
}

void begin_history(double start_mean, std::size_t p, const ShakingHistory& history)
{
    history.start_mean[p] = start_mean;
    history.shear_x[p] = history.shear_y[p] = 0.0;
    history.largest_shear[p] = history.liquefied_shear[p] = history.compaction[p] = 0.0;
}

double late_start_mean(double present, std::size_t p, const Particles& particles)
{
    constexpr double over_vertical = 0.75; // (1 + K_0)/2
    return std::max(present, over_vertical * particles.initial_vertical_effective_stress[p]);
}

void note_shear(double x, double y, double mean_stress, double floor, std::size_t p,
                const ShakingHistory& history)
{
    history.shear_x[p] += x;
    history.shear_y[p] += y;
    const double size = std::hypot(history.shear_x[p], history.shear_y[p]);
    history.largest_shear[p] = std::max(history.largest_shear[p], size);
    constexpr double rounding = 1.0 + 1e-9;
    if (mean_stress <= std::max(liquefied_stress * history.start_mean[p], floor * rounding))
        history.liquefied_shear[p] = history.largest_shear[p];
}

double whole_compaction(double slope, std::size_t p, const ShakingHistory& history)
{
    return slope * std::min(history.liquefied_shear[p], most_shear);
}

} // namespace quicksand
