#include "solver/verification/periodic_column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

/// Largest difference of the pressure of a theory from the full one, over the largest pressure.
double pressure_difference(const PeriodicColumn& column, InertiaTheory theory)
{
    constexpr int points = 200;
    const Complex s(0.0, column.angular_frequency());
    const ColumnResponse full(column.soil, column.height, s);
    const ColumnResponse simple(column.soil, column.height, s, theory);
    double difference = 0.0, largest = 0.0;
    for (int i = 0; i < points; ++i) {
        const double x = column.height * i / points;
        const Complex p = full.amplitude(x).pore_pressure;
        difference = std::max(difference, std::abs(simple.amplitude(x).pore_pressure - p));
        largest = std::max(largest, std::abs(p));
    }
    return difference / largest;
}

} // namespace

double PeriodicColumn::angular_frequency() const
{
    return 2.0 * std::numbers::pi * frequency;
}

ColumnAmplitude periodic_amplitude(const PeriodicColumn& column, double x, InertiaTheory theory)
{
    const Complex s(0.0, column.angular_frequency());
    return ColumnResponse(column.soil, column.height, s, theory).amplitude(x);
}

PeriodicColumnParameters map_parameters(const PeriodicColumn& column)
{
    const SaturatedSoil& soil = column.soil;
    const double speed_squared = soil.undrained_modulus() / soil.density();
    const double beta = soil.water_density / soil.density();
    const double omega = column.angular_frequency(), L2 = column.height * column.height;
    return {soil.hydraulic_conductivity * speed_squared / (column.gravity * beta * omega * L2),
            omega * omega * L2 / speed_squared};
}

InertiaZone inertia_zone(const PeriodicColumn& column, double tolerance)
{
    if (pressure_difference(column, InertiaTheory::consolidation) <= tolerance) return InertiaZone::I;
    if (pressure_difference(column, InertiaTheory::u_p) <= tolerance) return InertiaZone::II;
    return InertiaZone::III;
}

} // namespace quicksand
