#include "solver/verification/solutions/periodic_column.hpp"

#include <numbers>

namespace quicksand {

double PeriodicColumn::angular_frequency() const
{
    return 2.0 * std::numbers::pi * frequency;
}

ColumnAmplitude periodic_amplitude(const PeriodicColumn& column, double x)
{
    const Complex s(0.0, column.angular_frequency());
    return ColumnResponse(column.soil, column.height, s).amplitude(x);
}

} // namespace quicksand
