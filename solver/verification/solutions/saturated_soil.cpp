#include "solver/verification/solutions/saturated_soil.hpp"

namespace quicksand {

double SaturatedSoil::drag() const
{
    return porosity * porosity * water_density * conductivity_gravity / hydraulic_conductivity;
}

double SaturatedSoil::consolidation_coefficient() const
{
    const double unit_weight = water_density * conductivity_gravity;
    return hydraulic_conductivity /
           (unit_weight * (1.0 / constrained_modulus + porosity / water_bulk_modulus));
}

Eigen::Matrix2d SaturatedSoil::longitudinal_stiffness() const
{
    const Eigen::Vector2d fractions(1.0 - porosity, porosity);
    Eigen::Matrix2d K = storage_modulus() * fractions * fractions.transpose();
    K(0, 0) += constrained_modulus;
    return K;
}

} // namespace quicksand
