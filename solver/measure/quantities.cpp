#include "solver/measure/quantities.hpp"

#include "solver/base/failure.hpp"
#include "solver/measure/particle_quantities.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <initializer_list>

namespace quicksand {

namespace {

QuantityValues of_vector(const Vector2& v)
{
    return {v.x(), v.y()};
}

QuantityValues shear_strain_xy(const Problem&, const Particles& particles, std::size_t p)
{
    const Eigen::Matrix2d gradient = deformation_gradient(particles, p);
    return {gradient(0, 1) + gradient(1, 0)};
}

constexpr std::uint8_t everywhere = on_particles | on_nodes | at_probes;

// A row as it is read: what it is called, what it means, where it is, how it is found.
// clang-format off
constexpr std::array quantity_table = {
    Quantity{.name = "position", .symbol = "", .unit = "m", .label = "Position",
        .meaning = "place of the point", .form = QuantityForm::vector, .places = at_probes,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return of_vector(particles.position[p]); },
        .found_by = FoundBy::place, .length_power = 1},
    Quantity{.name = "displacement", .symbol = "u", .unit = "m", .label = "Displacement",
        .meaning = "displacement since the shaking began, in stages since they were last set to zero, relative to the base", .form = QuantityForm::vector, .places = everywhere,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return of_vector(displacement(particles, p)); },
        .length_power = 1},
    Quantity{.name = "total_displacement", .symbol = "total_u", .unit = "m", .label = "Total displacement",
        .meaning = "displacement since the first stage settled, or since soil was placed after that, of all stages",
        .form = QuantityForm::vector, .of = QuantityOf::staged_soil, .places = everywhere,
        .value = [](const Problem&, const Particles& particles, std::size_t p) {
            return of_vector(particles.former_displacement[p] + displacement(particles, p)); },
        .length_power = 1},
    Quantity{.name = "velocity_solid", .symbol = "v", .unit = "m/s", .label = "Velocity of the grains",
        .meaning = "velocity of the grains, relative to the base", .form = QuantityForm::vector, .places = everywhere,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return of_vector(particles.velocity_solid[p]); }},
    Quantity{.name = "acceleration", .symbol = "a", .unit = "m/s2", .label = "Acceleration",
        .meaning = "change of v over the probe interval, relative to the base; empty in the first row",
        .form = QuantityForm::vector, .places = at_probes, .found_by = FoundBy::change, .length_power = -1, .drawn = "m/s²"},
    Quantity{.name = "velocity_fluid", .symbol = "v_w", .unit = "m/s", .label = "Velocity of the water",
        .meaning = "true velocity of the pore water, relative to the base", .form = QuantityForm::vector,
        .of = QuantityOf::moving_water, .places = on_particles | on_nodes,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return of_vector(particles.velocity_fluid[p]); }},
    Quantity{.name = "pore_pressure", .symbol = "p", .unit = "Pa", .label = "Pore pressure",
        .meaning = "static plus excess pore pressure, compression positive", .of = QuantityOf::wet_soil, .places = everywhere,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{total_pore_pressure(problem, particles, p)}; }},
    Quantity{.name = "excess_pore_pressure", .symbol = "p_e", .unit = "Pa", .label = "Excess pore pressure",
        .meaning = "pore pressure beyond that of the water at the start of the shaking, compression positive",
        .of = QuantityOf::wet_soil, .places = everywhere,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{risen_pore_pressure(problem, particles, p)}; }},
    Quantity{.name = "ru", .symbol = "r_u", .unit = "-", .label = "Excess pore pressure ratio ru",
        .meaning = "p_e / sigma'_v0, excess pore pressure over the vertical effective stress at the start of the shaking",
        .of = QuantityOf::wet_soil, .places = everywhere,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{excess_pressure_ratio(problem, particles, p)}; },
        .averaged = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{bounded_pressure_ratio(problem, particles, p)}; }},
    Quantity{.name = "mean_effective_stress", .symbol = "p'", .unit = "Pa", .label = "Mean effective stress",
        .meaning = "-(sigma'_xx + sigma'_yy + sigma'_zz) / 3, compression positive", .places = everywhere,
        .value = [](const Problem&, const Particles& particles, std::size_t p) {
            return QuantityValues{mean_effective_stress(particles.stress, p)}; },
        .scatters = true},
    Quantity{.name = "vertical_effective_stress", .symbol = "sigma'_v", .unit = "Pa", .label = "Vertical effective stress",
        .meaning = "-sigma'_yy, compression positive", .places = everywhere,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return QuantityValues{-particles.stress.yy[p]}; },
        .scatters = true},
    Quantity{.name = "deviatoric_stress", .symbol = "q", .unit = "Pa", .label = "Deviatoric stress",
        .meaning = "sqrt(3 J_2)", .places = on_particles,
        .value = [](const Problem&, const Particles& particles, std::size_t p) {
            return QuantityValues{deviatoric_stress(particles.stress, p)}; }, .range = QuantityRange::not_negative},
    Quantity{.name = "shear_stress_xy", .symbol = "tau_xy", .unit = "Pa", .label = "Shear stress",
        .meaning = "sigma'_xy of the tensor that is positive in tension", .places = on_nodes | at_probes,
        .value = [](const Problem&, const Particles& particles, std::size_t p) { return QuantityValues{particles.stress.xy[p]}; },
        .scatters = true},
    Quantity{.name = "stress", .symbol = "sigma'", .unit = "Pa", .label = "Effective stress",
        .meaning = "effective stress tensor, tension positive", .form = QuantityForm::tensor, .places = on_particles,
        .value = [](const Problem&, const Particles& particles, std::size_t p) {
            const SymmetricTensors& stress = particles.stress;
            return QuantityValues{stress.xx[p], stress.yy[p], stress.zz[p], stress.xy[p]}; }},
    Quantity{.name = "shear_strain_xy", .symbol = "gamma_xy", .unit = "-", .label = "Shear strain",
        .meaning = "engineering shear strain du_x/dy + du_y/dx", .places = at_probes, .value = shear_strain_xy,
        .found_by = FoundBy::slope, .drawn = "%"},
    Quantity{.name = "shear_strain", .symbol = "gamma_max", .unit = "-", .label = "Greatest shear strain",
        .meaning = "greatest engineering shear strain, (s_1 - s_2) / sqrt(s_1 s_2) with the singular values of F; of the linear strain tensor in small strain",
        .places = on_particles,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{greatest_shear_strain(problem, particles, p)}; },
        .range = QuantityRange::not_negative, .drawn = "%"},
    Quantity{.name = "volumetric_strain", .symbol = "eps_v", .unit = "-", .label = "Volumetric strain",
        .meaning = "det F - 1, expansion positive; in small strain the trace of the linear strain tensor", .places = on_particles,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{volumetric_strain(problem, particles, p)}; },
        .drawn = "%"},
    Quantity{.name = "porosity", .symbol = "n", .unit = "-", .label = "Porosity",
        .meaning = "volume of the pores over that of the soil", .of = QuantityOf::wet_soil, .places = on_particles | on_nodes,
        .value = [](const Problem& problem, const Particles& particles, std::size_t p) {
            return QuantityValues{has_pores(problem, particles, p) ? particles.porosity[p] : 0.0}; },
        .range = QuantityRange::not_negative},
};
// clang-format on

/// The texts one after the other; gcc 12 takes "text" + std::string for an overlapping copy (its bug 105651).
std::string joined(std::initializer_list<std::string_view> parts)
{
    std::string text;
    for (const std::string_view part : parts) text.append(part);
    return text;
}

std::string lower_first(std::string_view text)
{
    std::string lowered(text);
    lowered.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(lowered.front())));
    return lowered;
}

} // namespace

std::span<const Quantity> all_quantities()
{
    return quantity_table;
}

std::vector<const Quantity*> quantities_of(QuantityPlace place)
{
    std::vector<const Quantity*> found;
    for (const Quantity& quantity : quantity_table)
        if ((quantity.places & place) != 0) found.push_back(&quantity);
    return found;
}

const Quantity& quantity_named(std::string_view name)
{
    const auto found = std::find_if(quantity_table.begin(), quantity_table.end(),
                                    [&](const Quantity& quantity) { return quantity.name == name; });
    ENSURE(found != quantity_table.end());
    return *found;
}

std::string_view drawn_unit(const Quantity& quantity)
{
    if (!quantity.drawn.empty()) return quantity.drawn;
    return quantity.unit == "-" ? "" : quantity.unit;
}

bool have(const Particles& particles, const Quantity& quantity)
{
    switch (quantity.of) {
    case QuantityOf::any_soil:
        return true;
    case QuantityOf::wet_soil:
        return particles.has_fluid();
    case QuantityOf::moving_water:
        return !particles.velocity_fluid.x.empty();
    case QuantityOf::staged_soil:
        return !particles.former_displacement.x.empty();
    }
    ENSURE(false);
    return false;
}

std::string_view component_suffix(QuantityForm form, std::size_t component)
{
    static constexpr std::array<std::string_view, 2> of_vectors = {"x", "y"};
    static constexpr std::array<std::string_view, 4> of_tensors = {"xx", "yy", "zz", "xy"};
    if (form == QuantityForm::scalar) return "";
    return form == QuantityForm::vector ? of_vectors.at(component) : of_tensors.at(component);
}

QuantityComponent find_component(std::string_view name)
{
    for (const Quantity& quantity : quantity_table)
        for (std::size_t c = 0; c < component_count(quantity.form); ++c)
            if (component_name(quantity, c) == name) return {&quantity, c};
    return {};
}

std::string component_name(const Quantity& quantity, std::size_t component)
{
    const std::string_view suffix = component_suffix(quantity.form, component);
    return joined({quantity.name, suffix.empty() ? "" : "_", suffix});
}

std::string component_label(const Quantity& quantity, std::size_t component)
{
    switch (quantity.form) {
    case QuantityForm::scalar:
        break;
    case QuantityForm::vector:
        return component == 0 ? joined({"Horizontal ", lower_first(quantity.label)})
                              : joined({"Vertical ", lower_first(quantity.label), ", up"});
    case QuantityForm::tensor:
        return joined(
            {quantity.label, " ", component_suffix(quantity.form, component), ", tension positive"});
    }
    return std::string(quantity.label);
}

std::string probe_column(const Quantity& quantity, std::size_t component)
{
    const std::string_view suffix = component_suffix(quantity.form, component);
    return joined({suffix.empty() ? quantity.name : quantity.symbol, suffix, unit_suffix(quantity.unit)});
}

std::string unit_suffix(std::string_view unit)
{
    if (unit == "-") return "";
    std::string suffix = joined({"_", unit});
    std::replace_if(
        suffix.begin(), suffix.end(), [](char letter) { return letter == '/' || letter == ' '; }, '_');
    return suffix;
}

std::vector<RememberedQuantity> remembered_quantities(const Problem& problem)
{
    std::vector<RememberedQuantity> all;
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        const LawMemory memory = memory_of(problem.materials[m].law);
        for (std::size_t k = 0; k < memory.size(); ++k) {
            if (!memory[k].shown) continue;
            auto known = std::find_if(all.begin(), all.end(),
                                      [&](const auto& each) { return each.name == memory[k].name; });
            if (known == all.end())
                known = all.insert(all.end(), {memory[k].name, memory[k].unit, memory[k].meaning,
                                               std::vector<std::int32_t>(problem.materials.size(), -1)});
            known->column[m] = static_cast<std::int32_t>(k);
        }
    }
    return all;
}

} // namespace quicksand
