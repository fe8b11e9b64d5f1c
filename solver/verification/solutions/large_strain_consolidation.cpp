#include "solver/verification/solutions/large_strain_consolidation.hpp"

#include "solver/verification/solutions/terzaghi.hpp"

#include <cmath>

namespace quicksand {

double pore_pressure(const LargeStrainConsolidation& layer, double Z, double T)
{
    const double swelling = std::expm1(layer.load / layer.constrained_modulus);
    return layer.constrained_modulus * std::log1p(swelling * terzaghi_pressure_ratio(Z, T));
}

double volume_ratio(const LargeStrainConsolidation& layer, double Z, double T)
{
    // sigma' = -M ln J carries what the water has given up
    return std::exp((pore_pressure(layer, Z, T) - layer.load) / layer.constrained_modulus);
}

double settlement_ratio(const LargeStrainConsolidation& layer, double Z, double T)
{
    // 1 - J = (1 - e^{-q/M}) (1 - theta), so the settlement follows Terzaghi's degree
    return -std::expm1(-layer.load / layer.constrained_modulus) * terzaghi_settlement_degree(Z, T);
}

} // namespace quicksand
