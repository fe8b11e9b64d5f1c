// What a run is given and never changes: grid, materials, water, boundaries, loads.
#pragma once

#include "solver/faces/boundary.hpp"
#include "solver/interpolation/cut_domains.hpp"
#include "solver/interpolation/interpolation.hpp"
#include "solver/particles/background_grid.hpp"
#include "solver/particles/particles.hpp"
#include "solver/particles/water_flow.hpp"
#include "solver/problem/base_motion.hpp"
#include "solver/problem/skeleton_law.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// Whether a particle's stress follows the volume change at the particle or that of its cell, see
/// volumetric_average.hpp.
enum class VolumetricStrain { particle, cell };

/// How the conductivity follows the porosity n, from its value k_0 at the initial n_0.
enum class PermeabilityLaw {
    constant,                // k_0
    kozeny_carman,           // k_0 [n^3 / (1-n)^2] / [n_0^3 / (1-n_0)^2]
    specific_volume_squared, // k_0 [(1-n_0) / (1-n)]^2 = k_0 J^2 (Xie and Leo 2004)
};

struct Material {
    std::string name;
    SkeletonLaw law;
    double grain_density = 0.0;                     // rho_s [kg/m3]
    double porosity = 0.0;                          // n, initial [-]
    double hydraulic_conductivity = 0.0;            // k [m/s]; not intrinsic permeability
    double conductivity_gravity = standard_gravity; // g_k, the gravity at which k is stated [m/s2]
    VolumetricStrain volumetric_strain = VolumetricStrain::particle;
    PermeabilityLaw permeability_law = PermeabilityLaw::constant;
    bool has_pores = true; // false: a solid without pore water, see solid_mixture.hpp
    bool saturated = true; // pores full of water where the scene has water; false above a phreatic line
    std::optional<std::size_t> part_of = {}; // the material whose soil it is, which differs by its water or
                                             // its state alone; none: a soil of its own
};

struct Water {
    double density = 1000.0;        // rho_w [kg/m3]
    double bulk_modulus = 2.2e9;    // K_w, of the water with the air in it [Pa]
    double level = 0.0;             // y of the still water surface [m]
    bool rises_above_level = false; // a phreatic line in the soil lies above the level somewhere
    WaterFlow flow = WaterFlow::coupled;
    WaterFlow while_settling = WaterFlow::drained;  // or undrained: under weight that comes at once
    std::optional<double> cavitation_pressure = {}; // absolute; none: no limit of tension [Pa]
};

/// Two vertical sides whose points of equal height move together, as in a laminar box.
struct TiedSides {
    std::string left, right; // names of the boundary curves
    double x_left = 0.0;     // [m], on a grid line
    double x_right = 0.0;    // [m], on a grid line
    double period = 0.0;     // by which soil that leaves the middle comes back to it; 0: it does not [m]
};

/// How the equations follow the motion of the soil.
enum class StrainForm {
    large, // weights, volumes and porosities are those of the present shape, stress turns with the soil
    small, // all on the reference shape: the equations of linear consolidation and dynamics
};

/// How the two-phase step goes forward in time.
enum class TimeScheme {
    explicit_steps, // every balance from the old state; sound of the water limits dt
    semi_implicit,  // the water's pressure and drag implicit together; waves of the skeleton limit dt
    implicit,       // besides, the skeleton's stiffness resists accelerations; accuracy limits dt
};

struct FreeField;

/// Immutable inputs of a run. Without `water` the scene is dry.
struct Problem {
    BackgroundGrid grid;
    Interpolation interpolation = Interpolation::cpdi;
    StrainForm strain = StrainForm::large;
    TimeScheme scheme = TimeScheme::explicit_steps; // of a saturated body
    double step_fraction = 1.0;                     // of the stable time step that is taken [-]
    std::vector<Material> materials;
    std::vector<std::string> region_names;
    CutDomains cut_domains; // of the particles that an outline cuts
    std::optional<Water> water;
    double gravity = standard_gravity; // magnitude, acting in -y [m/s2]
    BaseMotion base_motion;
    std::vector<Boundary> boundaries;
    std::vector<Segment> rim; // all edges of the soil as drawn, with a boundary or without: where walls end
    std::optional<TiedSides> tied_sides;
    std::vector<FreeField> free_fields; // one for each place of a free-field side
    /// Body force per mass on a point of a body of one phase, by its reference position and time; for
    /// verification, none otherwise [m/s2].
    std::function<Vector2(const Vector2&, double)> body_acceleration;
};

/// The level ground far beyond a free-field side: one column of cells with the soil, the base and the water
/// that the body has beside the side. Its own sides are tied.
struct FreeField {
    double x = 0.0;       // of the side [m]
    double outward = 0.0; // x of the side's outward normal, -1 or 1 [-]
    Problem column;
};

/// The water of a material's pores: none in a dry scene and above a phreatic line.
const std::optional<Water>& water_of(const Problem& problem, const Material& material);

/// Whether some materials have pores and others are solids.
bool has_soil_and_solids(const Problem& problem);

/// Whether the particle is soil with pores, and not a solid.
bool has_pores(const Problem& problem, const Particles& particles, std::size_t p);

/// Whether the pores of a material have a pressure where the scene has water: not above a phreatic line, nor
/// in solids.
inline bool is_wet(const Material& material)
{
    return material.saturated && material.has_pores;
}

/// Whether any material is not wet in a scene with water.
bool is_partly_wet(const Problem& problem);

/// Whether the pores keep their water while the soil settles.
bool settles_undrained(const Problem& problem);

/// How water flows in the scene; none: the scene is dry.
std::optional<WaterFlow> water_flow(const Problem& problem);

/// Size the arrays that the problem needs for `count` particles, at zero.
void resize_particles(const Problem& problem, std::size_t count, Particles& particles);

/// Static pressure of the still water at height y, zero above the level [Pa].
double static_water_pressure(const Problem& problem, double y);

/// Static pressure of water that stands up to a height, at height y, zero above [Pa].
double pressure_below(const Problem& problem, double surface, double y);

/// Excess over the still water that the water beyond a boundary has at a point, its history having the value
/// `factor`; the scene has water [Pa].
double outer_excess_pressure(const Problem& problem, const Boundary& boundary, const Vector2& point,
                             double factor = 1.0);

/// Pore pressure beyond that of the water at the start of the shaking, whose table lay at the level or at a
/// phreatic line; what the scene begins with as excess is counted [Pa].
double risen_pore_pressure(const Problem& problem, const Particles& particles, std::size_t p);

/// Modulus of water that holds air bubbles (Verruijt 1969): 1/K = S/K_w + (1-S)/p_air, with the saturation S
/// and the absolute pressure p_air of the air, both constant [Pa].
double modulus_with_air(double water_modulus, double saturation, double air_pressure);

/// k at the porosity [m/s].
inline double hydraulic_conductivity(const Material& material, double porosity)
{
    const double k = material.hydraulic_conductivity;
    if (material.permeability_law == PermeabilityLaw::constant) return k;
    const double J = (1.0 - material.porosity) / (1.0 - porosity); // volume over the initial volume
    if (material.permeability_law == PermeabilityLaw::specific_volume_squared) return k * J * J;
    const double ratio = porosity / material.porosity;
    return k * ratio * ratio * ratio * J * J;
}

/// k where the particle is, by its porosity and the state of its grains [m/s].
inline double hydraulic_conductivity(const Material& material, const Particles& particles, std::size_t p)
{
    return conductivity_factor(material.law, p, particles) *
           hydraulic_conductivity(material, particles.porosity[p]);
}

/// n^2 rho_w g_k, which over k is the drag [N/m3].
inline double drag_weight(const Material& material, const Water& water, double porosity)
{
    return porosity * porosity * water.density * material.conductivity_gravity;
}

/// C = n^2 rho_w g_k / k(n), the drag between water and grains [N s/m4].
inline double drag_coefficient(const Material& material, const Water& water, double porosity)
{
    return drag_weight(material, water, porosity) / hydraulic_conductivity(material, porosity);
}

/// The same where the particle is, by the state of its grains too [N s/m4].
inline double drag_coefficient(const Material& material, const Water& water, const Particles& particles,
                               std::size_t p)
{
    return drag_weight(material, water, particles.porosity[p]) /
           hydraulic_conductivity(material, particles, p);
}

/// rho_w g_k / k where the particle is: gradient of the pressure per flux [N s/m4].
inline double flow_resistivity(const Material& material, const Water& water, const Particles& particles,
                               std::size_t p)
{
    return water.density * material.conductivity_gravity / hydraulic_conductivity(material, particles, p);
}

/// Where the particles are in the equations: in small strain at their reference positions [m].
inline const Vectors& place_in_equations(const Problem& problem, const Particles& particles)
{
    return problem.strain == StrainForm::small ? particles.reference_position : particles.position;
}

/// Half edges of the particles' domains in the equations [m].
struct HalfEdges {
    const Vectors &first, &second;
};
inline HalfEdges half_edges_in_equations(const Problem& problem, const Particles& particles)
{
    if (problem.strain == StrainForm::small) return {particles.reference_edge_1, particles.reference_edge_2};
    return {particles.half_edge_1, particles.half_edge_2};
}

} // namespace quicksand
