// The material points: one array per quantity, so that kernels run across particles.
#pragma once

#include "solver/base/conventions.hpp"
#include "solver/particles/water_flow.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace quicksand {

using Scalars = std::vector<double>;

struct Vectors {
    Scalars x, y;
    Vector2 operator[](std::size_t p) const { return {x[p], y[p]}; }
    void set(std::size_t p, const Vector2& v) { x[p] = v.x(), y[p] = v.y(); }
};

/// Velocity gradients, L_ab = d v_a / d x_b [1/s].
struct Gradients {
    Scalars xx, xy, yx, yy;
};

/// Plane-strain symmetric tensors with their out-of-plane component.
struct SymmetricTensors {
    Scalars xx, yy, zz, xy;
};

/// What soil laws remember: column k holds the k-th number of every particle, which the law of its material
/// gives a meaning (soil/law_interface.hpp). No columns where no law remembers anything.
using SoilMemory = std::vector<Scalars>;

/// In small strain the equations are set up on the reference shape; position and edges show the displaced
/// one. Structure of arrays; every array has `size()` entries, or none where the scene does not need it: a
/// dry scene carries nothing of water, a drained one the porosity and the pressures that are held, and
/// velocities of the water are there in coupled flow alone.
struct Particles {
    std::vector<std::int32_t> identifier; // lasting number, as sampled; the arrays are reordered [-]
    std::vector<std::int32_t> material;   // index into Problem::materials [-]
    std::vector<std::int32_t> region;     // index into Problem::region_names [-]

    Vectors position;            // x_p, centre of the domain [m]
    Vectors half_edge_1;         // r_1, half an edge of the parallelogram domain [m]
    Vectors half_edge_2;         // r_2, the other half edge, r_1 x r_2 > 0 [m]
    Vectors twist;               // t of a quadrilateral domain, see cpdi2.hpp; none otherwise [m]
    Vectors reference_position;  // x_p when displacements were last set to zero [m]
    Vectors reference_edge_1;    // r_1 at that time [m]
    Vectors reference_edge_2;    // r_2 at that time [m]
    Vectors former_displacement; // of the stages before, up to the reference position; in a scene with
                                 // stages alone [m]
    Scalars volume;              // V_p per metre of thickness [m3/m]

    Vectors velocity_solid;            // v_s [m/s]
    Gradients velocity_gradient_solid; // L_s, with which the domain deforms [1/s]
    Gradients affine_velocity_solid;   // C_s, carried to the nodes, see affine_velocity.hpp [1/s]
    Scalars mass_solid;                // (1-n) rho_s V_p, constant [kg/m]
    SymmetricTensors stress;           // effective stress sigma', tension positive [Pa]

    Vectors velocity_fluid;          // v_w, true velocity [m/s]
    Gradients affine_velocity_fluid; // C_w [1/s]
    Scalars porosity;                // n [-]
    Scalars water_volume;            // of the water a particle keeps when undrained, without pressure [m3/m]
    Scalars tension_deficit;    // excess pressure that cavities keep from the water, see pore_pressure.hpp,
                                // never positive; none without a cavitation limit [Pa]
    Scalars pore_pressure;      // excess over the static water pressure, compression positive [Pa]
    Scalars pore_pressure_rate; // of the cell in the last semi-implicit step, none in explicit runs [Pa/s]
    Scalars initial_vertical_effective_stress; // sigma'_v0 at the start of shaking, compression positive [Pa]
    Scalars water_table; // y to which the water stood at the start, none where it is the level [m]

    SoilMemory memory; // while the soil is shaken

    std::size_t size() const { return identifier.size(); }
    bool has_fluid() const { return !porosity.empty(); }
};

/// Name of a column of memory: "memory_00".
const char* memory_name(std::size_t column);

/// Call `visit(name, values)` for every array of doubles, in a fixed order. `ParticleSet` is Particles or
/// const Particles. Reordering, checkpoints and memory counts go through here.
template <class ParticleSet, class Visitor>
void for_each_array(ParticleSet& particles, Visitor&& visit)
{
    const auto vectors = [&](const char* name_x, const char* name_y, auto& field) {
        visit(name_x, field.x);
        visit(name_y, field.y);
    };
    const auto gradients = [&](const char* xx, const char* xy, const char* yx, const char* yy, auto& field) {
        visit(xx, field.xx);
        visit(xy, field.xy);
        visit(yx, field.yx);
        visit(yy, field.yy);
    };
    vectors("position_x", "position_y", particles.position);
    vectors("half_edge_1_x", "half_edge_1_y", particles.half_edge_1);
    vectors("half_edge_2_x", "half_edge_2_y", particles.half_edge_2);
    vectors("twist_x", "twist_y", particles.twist);
    vectors("reference_position_x", "reference_position_y", particles.reference_position);
    vectors("reference_edge_1_x", "reference_edge_1_y", particles.reference_edge_1);
    vectors("reference_edge_2_x", "reference_edge_2_y", particles.reference_edge_2);
    vectors("former_displacement_x", "former_displacement_y", particles.former_displacement);
    visit("volume", particles.volume);
    vectors("velocity_solid_x", "velocity_solid_y", particles.velocity_solid);
    gradients("velocity_gradient_solid_xx", "velocity_gradient_solid_xy", "velocity_gradient_solid_yx",
              "velocity_gradient_solid_yy", particles.velocity_gradient_solid);
    gradients("affine_velocity_solid_xx", "affine_velocity_solid_xy", "affine_velocity_solid_yx",
              "affine_velocity_solid_yy", particles.affine_velocity_solid);
    visit("mass_solid", particles.mass_solid);
    visit("stress_xx", particles.stress.xx);
    visit("stress_yy", particles.stress.yy);
    visit("stress_zz", particles.stress.zz);
    visit("stress_xy", particles.stress.xy);
    vectors("velocity_fluid_x", "velocity_fluid_y", particles.velocity_fluid);
    gradients("affine_velocity_fluid_xx", "affine_velocity_fluid_xy", "affine_velocity_fluid_yx",
              "affine_velocity_fluid_yy", particles.affine_velocity_fluid);
    visit("porosity", particles.porosity);
    visit("water_volume", particles.water_volume);
    visit("tension_deficit", particles.tension_deficit);
    visit("pore_pressure", particles.pore_pressure);
    visit("pore_pressure_rate", particles.pore_pressure_rate);
    visit("initial_vertical_effective_stress", particles.initial_vertical_effective_stress);
    visit("water_table", particles.water_table);
    for (std::size_t k = 0; k < particles.memory.size(); ++k) visit(memory_name(k), particles.memory[k]);
}

/// As for_each_array, for the arrays of 32-bit integers.
template <class ParticleSet, class Visitor>
void for_each_index_array(ParticleSet& particles, Visitor&& visit)
{
    visit("identifier", particles.identifier);
    visit("material", particles.material);
    visit("region", particles.region);
}

/// The arrays that come and go together.
enum class ArrayGroup {
    always,
    pores,         // with water
    pressure,      // with water that has an excess pressure
    fluid_motion,  // with water that moves by itself
    kept_water,    // with water that cannot
    cavities,      // with a cavitation limit
    water_table,   // with a phreatic line above the level
    pressure_rate, // with the semi-implicit scheme
    twist,         // with quadrilaterals
    stages,        // in a scene with stages
    memory,        // with a law that remembers
};

/// The group of an array by its name in for_each_array.
ArrayGroup group_of(std::string_view name);

/// Size the arrays that such a flow of water (none: a dry scene) needs for `count` particles, at zero; none
/// that depend on more than the flow.
void resize(Particles& particles, std::size_t count, std::optional<WaterFlow> flow);

/// The flow whose arrays the particles carry; none: dry.
std::optional<WaterFlow> carried_flow(const Particles& particles);

/// Excess pore pressure, zero where none is carried [Pa].
inline double excess_pore_pressure(const Particles& particles, std::size_t p)
{
    return particles.pore_pressure.empty() ? 0.0 : particles.pore_pressure[p];
}

/// Velocity of the water, that of the grains where it has none of its own [m/s].
inline Vector2 velocity_of_water(const Particles& particles, std::size_t p)
{
    return particles.velocity_fluid.x.empty() ? particles.velocity_solid[p] : particles.velocity_fluid[p];
}

/// Give every particle a memory of so many numbers, at zero.
void add_memory(Particles& particles, std::size_t columns);

/// Permute the particles: the new particle k is the old particle order[k].
void reorder(Particles& particles, const std::vector<std::int32_t>& order);

/// Count the displacements, none so far, of the stages to come.
void add_former_displacement(Particles& particles);

/// Add the present displacement to that of the stages before, if such are counted: the reference is about to
/// change.
void keep_displacement(Particles& particles);

/// Declare the present shape the reference of displacement and strain.
void reset_reference(Particles& particles);

/// Undo the displacements since the reference; of small strain, where the drawn shape is that of the
/// equations.
void return_to_reference(Particles& particles);

/// Set all velocities and their gradients to zero.
void set_at_rest(Particles& particles);

/// Deformation gradient since the reference, from the domain's edges [-].
Eigen::Matrix2d deformation_gradient(const Particles& particles, std::size_t p);

/// Bytes held by the particle arrays [byte].
std::size_t memory_bytes(const Particles& particles);

} // namespace quicksand
