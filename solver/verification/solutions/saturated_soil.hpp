// The linear elastic saturated soil of the closed forms: incompressible grains, compressible water, small
// strains. Displacements and velocities are those of the true phases, as in the two-phase step.
#pragma once

#include "solver/base/conventions.hpp"

#include <Eigen/Core>

namespace quicksand {

struct SaturatedSoil {
    double constrained_modulus = 350e6;             // M of the skeleton [Pa]
    double shear_modulus = 100e6;                   // G [Pa]
    double porosity = 0.43;                         // n [-]
    double grain_density = 2650.0;                  // rho_s [kg/m3]
    double water_density = 1000.0;                  // rho_w [kg/m3]
    double water_bulk_modulus = 2.2e9;              // K_w [Pa]
    double hydraulic_conductivity = 1e-4;           // k [m/s]
    double conductivity_gravity = standard_gravity; // g_k, the gravity at which k is stated [m/s2]

    double partial_density_solid() const { return (1.0 - porosity) * grain_density; } // r_1 [kg/m3]
    double partial_density_fluid() const { return porosity * water_density; }         // r_2 [kg/m3]
    double density() const { return partial_density_solid() + partial_density_fluid(); }
    double drag() const; // C = n^2 rho_w g_k / k [N s/m4]
    /// K_w / n, the pressure per volume of water pressed into the pores [Pa].
    double storage_modulus() const { return water_bulk_modulus / porosity; }
    double undrained_modulus() const { return constrained_modulus + storage_modulus(); } // M + K_w/n [Pa]
    /// c_v = k / [gamma_w (1/M + n/K_w)] [m2/s].
    double consolidation_coefficient() const;
    /// Stiffness of plane longitudinal motion of (solid, fluid): M and the storage on (1-n, n) [Pa].
    Eigen::Matrix2d longitudinal_stiffness() const;
};

} // namespace quicksand
