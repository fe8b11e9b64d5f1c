// PM4Sand for one point: effective stress of sand with a bounding surface, dilatancy that depends on state
// and fabric, and a critical state (Boulanger and Ziotopoulou 2017, with roots in Dafalias and Manzari 2004).
//
// Parameters and sources: pm4sand_parameters.hpp; equations: pm4sand_surfaces.hpp, pm4sand_flow.hpp,
// pm4sand_substep.hpp.
// Units/signs  Pm4SandState and Pm4SandStrain are compression positive, as the law is published. Shear strain
// is
//              engineering shear.
// Limits       Of the plane: the out-of-plane stress follows, and nothing depends on it. alpha_in is sought
// for each
//              component of the axes apart, as published, so that the law is not quite the same in axes that
//              are turned.
#pragma once

#include "solver/pm4sand/pm4sand_parameters.hpp"
#include "solver/pm4sand/pm4sand_point.hpp"

namespace quicksand {

/// Start of shaking, the first call of the law: the memory of a point at its consolidation stress. A stress
/// outside the bounding and the dilatancy surface is brought to the outer of them, a mean stress below the
/// floor to it; true when that changed the stress.
bool begin_shaking(const Pm4Sand& law, Pm4SandState& state);

/// Advance a point by a strain, in substeps as long as their error allows.
void update(const Pm4Sand& law, const Pm4SandStrain& strain, Pm4SandState& state);

/// G [Pa] of unloading at the present stress.
double shear_modulus(const Pm4Sand& law, const Pm4SandState& state);

/// The largest q/p that the point can have at its mean stress: M^b, or M^d where that is larger [-].
double largest_ratio(const Pm4Sand& law, double mean_stress, double void_ratio);

/// e at the given relative density [-].
double initial_void_ratio(const Pm4Sand& law);

} // namespace quicksand
