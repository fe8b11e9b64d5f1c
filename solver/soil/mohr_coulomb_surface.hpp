// The six planes of a Mohr-Coulomb surface with tension cut-off in the sector s_1 >= s_2 >= s_3, and the
// return to them.
#pragma once

#include "solver/soil/mohr_coulomb_parameters.hpp"

#include <Eigen/Core>
#include <array>
#include <span>

namespace quicksand {

class MohrCoulombSurface {
public:
    explicit MohrCoulombSurface(const MohrCoulomb& law);

    /// Excess over the surface from the extreme principal stresses alone [Pa].
    double excess(double largest, double smallest) const
    {
        const double shear = (1.0 + sin_phi_) * largest - (1.0 - sin_phi_) * smallest - shear_limit_;
        const double tension = largest - tension_limit_;
        return shear > tension ? shear : tension;
    }

    /// Stress to which the trial, outside the surface, returns; largest tension first [Pa].
    Eigen::Vector3d return_from(const Eigen::Vector3d& trial) const;

private:
    enum Plane { shear_13, shear_12, shear_23, tension_1, tension_2, tension_3, plane_count };

    /// A stress and by how much it fails to be the answer: a plane violated or a multiplier negative [Pa].
    struct Candidate {
        Eigen::Vector3d stress;
        double failure;
    };

    double value(Plane plane, const Eigen::Vector3d& stress) const; // of the plane's yield function [Pa]
    double violation(const Eigen::Vector3d& stress) const;          // largest of the values [Pa]
    Candidate onto(Plane plane, const Eigen::Vector3d& trial) const;
    Candidate onto(Plane one, Plane other, const Eigen::Vector3d& trial) const;
    void snap(std::span<const Plane> planes, Eigen::Vector3d& stress) const;
    Candidate onto_vertex(int tensions, const Eigen::Vector3d& trial) const;

    double sin_phi_, flow_ratio_;                         // sin phi, (1 + sin psi) / (1 - sin psi) [-]
    double shear_limit_, tension_limit_;                  // 2 c cos phi, t [Pa]
    double lambda_, shear_modulus_;                       // [Pa]
    std::array<Eigen::Vector3d, plane_count> normal_;     // [-]
    std::array<Eigen::Vector3d, plane_count> stiff_flow_; // D r, r the direction of plastic strain [Pa]
};

} // namespace quicksand
