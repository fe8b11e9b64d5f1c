// The quantities that results tell of a point of the soil, one row each: frames on particles and nodes,
// probes, figures, pictures and io/RESULTS.md follow from this table.
#pragma once

#include "solver/problem/problem.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

enum class QuantityForm : std::uint8_t {
    scalar,
    vector, // x, y
    tensor, // xx, yy, zz, xy
};

/// Which soil has a quantity.
enum class QuantityOf : std::uint8_t {
    any_soil,
    wet_soil,     // of a scene with water
    moving_water, // whose water has a velocity of its own
    staged_soil,  // of a scene with stages
};

/// The numbers that a quantity takes: its colours in pictures.
enum class QuantityRange : std::uint8_t {
    any,          // colours diverge from zero where it takes both signs
    not_negative, // dark to light
};

/// Where a quantity is written; combined by or.
enum QuantityPlace : std::uint8_t {
    on_particles = 1, // fields.pvd
    on_nodes = 2,     // grid.pvd, as an average
    at_probes = 4,    // probes/*.csv
};

/// How a probe at a fixed point finds a quantity.
enum class FoundBy : std::uint8_t {
    average, // of the nodes around it
    place,   // it is the point itself
    slope,   // of the averaged displacement
    change,  // of the velocity from row to row, also of a particle
};

/// Components of a quantity; only the first where it is a scalar.
using QuantityValues = std::array<double, 4>;
using ParticleValue = QuantityValues (*)(const Problem&, const Particles&, std::size_t p);

struct Quantity {
    std::string_view name;    // in frames and in the scene, "pore_pressure"
    std::string_view symbol;  // in equations; the columns of a vector's probes begin with it
    std::string_view unit;    // SI, "-" without one
    std::string_view label;   // in pictures
    std::string_view meaning; // formula and sign
    QuantityForm form = QuantityForm::scalar;
    QuantityOf of = QuantityOf::any_soil;
    std::uint8_t places = 0;          // QuantityPlace bits
    ParticleValue value = nullptr;    // of a particle; none where a probe alone can know it
    ParticleValue averaged = nullptr; // what nodes average where it is not the value
    FoundBy found_by = FoundBy::average;
    bool scatters = false; // from particle to particle, as once soil has liquefied: probes fit those around
    int length_power = 0;  // where lengths and times are drawn s times as large, it is by s to this power [-]
    QuantityRange range = QuantityRange::any;
    std::string_view drawn = {}; // unit in pictures where it is not the SI unit
};

/// All of them; the order is that of arrays in frames and of columns of probes.
std::span<const Quantity> all_quantities();

/// Those of a place.
std::vector<const Quantity*> quantities_of(QuantityPlace place);

/// By its name. Throws InternalError where there is none.
const Quantity& quantity_named(std::string_view name);

/// Unit in pictures, "" without one.
std::string_view drawn_unit(const Quantity& quantity);

/// Whether the particles have the quantity.
bool have(const Particles& particles, const Quantity& quantity);

inline std::size_t component_count(QuantityForm form)
{
    return form == QuantityForm::scalar ? 1 : form == QuantityForm::vector ? 2 : 4;
}

/// "x" and "y" of a vector, "xx" and so on of a tensor, "" of a scalar.
std::string_view component_suffix(QuantityForm form, std::size_t component);

/// A number of a quantity.
struct QuantityComponent {
    const Quantity* quantity = nullptr; // none: a number that no quantity has
    std::size_t component = 0;
};

/// By the name that component_name() gives it.
QuantityComponent find_component(std::string_view name);

/// Name of a number: "ru", "displacement_y", "stress_xy".
std::string component_name(const Quantity& quantity, std::size_t component);

/// The same in words, as above a picture: "Vertical displacement, up".
std::string component_label(const Quantity& quantity, std::size_t component);

/// The same as a column of a probe: "ru", "uy_m", "shear_stress_xy_Pa".
std::string probe_column(const Quantity& quantity, std::size_t component);

/// A unit as the end of a column's name: "_m_s2" of "m/s2", "" of "-".
std::string unit_suffix(std::string_view unit);

/// A number that the soil laws of a problem remember of their particles and that results show.
struct RememberedQuantity {
    std::string_view name, unit, meaning;
    std::vector<std::int32_t> column; // of Particles::memory, one a material; -1: its law has no such number
};
std::vector<RememberedQuantity> remembered_quantities(const Problem& problem);

} // namespace quicksand
