#include "solver/measure/body_quantities.hpp"

#include "solver/measure/particle_quantities.hpp"
#include "solver/measure/quantities.hpp"
#include "solver/particles/background_grid.hpp"

#include <array>

namespace quicksand {

namespace {

using enum BodyQuantityOf;

static_assert(BackgroundGrid::domain_reach == 2.5, "the row of limited_domains says so");

// One row, one quantity: the formatter would make it four lines.
// clang-format off
constexpr std::array body_quantity_table = {
    BodyQuantity{"time", "s", "time since the shaking began", any_body,
        [](const MeasuredBody& body) { return body.state.time; }},
    BodyQuantity{"base_acceleration", "m/s2", "acceleration of the base", any_body,
        [](const MeasuredBody& body) { return base_acceleration(body.problem.base_motion, body.state.time); }, "Base acceleration", "m/s²"},
    BodyQuantity{"crest_settlement", "m", "mean of the particles that lay highest when the shaking began, positive downward", any_body,
        [](const MeasuredBody& body) { return body.monitors.crest_settlement; }, "Crest settlement"},
    BodyQuantity{"max_displacement", "m", "largest displacement of a particle since the shaking began, in stages since they were last set to zero", any_body,
        [](const MeasuredBody& body) { return body.monitors.max_displacement; }},
    BodyQuantity{"max_velocity", "m/s", "largest velocity of the grains, relative to the base", any_body,
        [](const MeasuredBody& body) { return body.monitors.max_velocity; }},
    BodyQuantity{"max_excess_pore_pressure", "Pa", "largest excess pore pressure", wet_body,
        [](const MeasuredBody& body) { return body.monitors.max_excess_pore_pressure; }, "Largest excess pore pressure"},
    BodyQuantity{"max_ru", "-", "largest excess pore pressure / initial vertical effective stress", wet_body,
        [](const MeasuredBody& body) { return body.monitors.max_ru; }, "Largest excess pore pressure ratio ru"},
    BodyQuantity{"mass_fluid", "kg", "mass of the pore water", wet_body,
        [](const MeasuredBody& body) { return body.monitors.mass_fluid; }},
    BodyQuantity{"mass_solid", "kg", "mass of the grains, and of water in moist soil above the water", any_body,
        [](const MeasuredBody& body) { return body.monitors.mass_solid; }},
    BodyQuantity{"volume", "m3", "volume of the soil", any_body,
        [](const MeasuredBody& body) { return body.monitors.volume; }},
    BodyQuantity{"momentum_x", "N s", "horizontal momentum of both phases, relative to the base", any_body,
        [](const MeasuredBody& body) { return body.monitors.momentum_x; }},
    BodyQuantity{"momentum_y", "N s", "vertical momentum of both phases, upward", any_body,
        [](const MeasuredBody& body) { return body.monitors.momentum_y; }},
    BodyQuantity{"kinetic_energy", "J", "kinetic energy of both phases, relative to the base", any_body,
        [](const MeasuredBody& body) { return body.monitors.kinetic_energy; }, "Kinetic energy of both phases", "J/m"},
    BodyQuantity{"max_strain", "-", "largest strain of a particle since the reference, of shear or of volume; small strain holds up to about 0.1", small_body,
        [](const MeasuredBody& body) { return largest_strain(body.problem, body.state.particles); }},
    BodyQuantity{"limited_domains", "-", "particle domains scaled down in the last step, as they reached farther than 2.5 cells from their centre", any_body,
        [](const MeasuredBody& body) { return static_cast<double>(body.limited_domains); }, {}, {}, true},
    BodyQuantity{"mean_stress_checkerboard", "-", "|sum (-1)^(i+j) p_c V_c| / sum |p_c| V_c over the cells, of the mean effective stress; above 0.05 neighbouring cells oscillate", any_body,
        [](const MeasuredBody& body) { return body.oscillations.mean_stress_checkerboard; }},
    BodyQuantity{"mean_stress_scatter", "-", "mean effective stress of the particles less the plane through the cell means / its size; some tenths where the volume locks, or soil flows that dilates", any_body,
        [](const MeasuredBody& body) { return body.oscillations.mean_stress_scatter; }},
    BodyQuantity{"pore_pressure_checkerboard", "-", "as mean_stress_checkerboard, of the excess pore pressure", wet_body,
        [](const MeasuredBody& body) { return body.oscillations.pore_pressure_checkerboard; }},
    BodyQuantity{"kinetic_energy_water", "J", "kinetic energy of the water, relative to the base", wet_body,
        [](const MeasuredBody& body) { return body.monitors.kinetic_energy_fluid; }},
    BodyQuantity{"storage_energy_water", "J", "energy stored in the compressed water", wet_body,
        [](const MeasuredBody& body) { return storage_energy(body.problem, body.state.particles); }},
    BodyQuantity{"pore_volume", "m3", "volume of the pores of soil that has a pore pressure", wet_body,
        [](const MeasuredBody& body) { return body.monitors.mass_fluid / body.problem.water->density; }},
    BodyQuantity{"water_content", "m3", "volume of the pore water without its pressure", wet_body,
        [](const MeasuredBody& body) { return water_content(body.problem, body.state.particles); }},
    BodyQuantity{"skeleton_work", "J", "work of the effective stress on the skeleton since t = 0, stored and dissipated", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->skeleton_work; }},
    BodyQuantity{"inertia_work", "J", "work against the stiffness that resists accelerations and of what damps vibrations since t = 0", balanced_stiff_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->inertia_work; }},
    BodyQuantity{"gravity_work", "J", "work of the weight since t = 0, buoyant below water", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->gravity_work; }},
    BodyQuantity{"base_work", "J", "work of the base's acceleration since t = 0", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->base_work; }},
    BodyQuantity{"boundary_work", "J", "work of loads, heads, moving walls, viscous and free-field sides since t = 0", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->boundary_work; }},
    BodyQuantity{"numerical_loss", "J", "kinetic energy lost in transfers between particles and grid, and at walls", balanced_body,
        [](const MeasuredBody& body) { return body.balance.numerical_loss; }},
    BodyQuantity{"energy_error", "-", "residual of kinetic energy, stored energy, works and losses / the sum of their sizes", balanced_body,
        [](const MeasuredBody& body) { return body.balance.energy_error; }},
    BodyQuantity{"impulse_x", "N s", "horizontal impulse of weight, base and boundaries since t = 0", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->impulse_x; }},
    BodyQuantity{"impulse_y", "N s", "vertical impulse of weight, base and boundaries since t = 0, upward", balanced_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->impulse_y; }},
    BodyQuantity{"momentum_error_x", "N s", "horizontal momentum less that at t = 0, the impulses and the momentum of water that entered pores", balanced_body,
        [](const MeasuredBody& body) { return body.balance.momentum_error_x; }},
    BodyQuantity{"momentum_error_y", "N s", "vertical momentum less that at t = 0, the impulses and the momentum of water that entered pores", balanced_body,
        [](const MeasuredBody& body) { return body.balance.momentum_error_y; }},
    BodyQuantity{"drag_dissipation", "J", "energy that the drag between water and grains has dissipated since t = 0", balanced_wet_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->drag_dissipation; }},
    BodyQuantity{"water_outflow", "m3", "volume of water that left the soil since t = 0", balanced_wet_body,
        [](const MeasuredBody& body) { return body.state.balance_terms->outflow; }},
    BodyQuantity{"water_error", "-", "(water_content - content at t = 0 + water_outflow) / content at t = 0", balanced_wet_body,
        [](const MeasuredBody& body) { return body.balance.water_error; }},
};
// clang-format on

bool has(const Problem& problem, const State& state, BodyQuantityOf of)
{
    const bool wet = problem.water.has_value(), balanced = state.balance_terms.has_value();
    return of == any_body || (of == small_body && problem.strain == StrainForm::small) ||
           (of == wet_body && wet) || (of == balanced_body && balanced) ||
           (of == balanced_wet_body && wet && balanced) ||
           (of == balanced_stiff_body && problem.scheme == TimeScheme::implicit && balanced);
}

} // namespace

MeasuredBody measure_body(const Problem& problem, const State& state, const std::vector<std::int32_t>& crest,
                          std::int64_t limited_domains)
{
    return {problem,
            state,
            monitor(problem, state, crest),
            measure_pressure_oscillations(problem, state.particles),
            state.balance_terms ? balance(problem, state) : BalanceErrors{},
            limited_domains};
}

std::span<const BodyQuantity> all_body_quantities()
{
    return body_quantity_table;
}

std::vector<const BodyQuantity*> body_quantities(const Problem& problem, const State& state)
{
    std::vector<const BodyQuantity*> found;
    for (const BodyQuantity& quantity : body_quantity_table)
        if (has(problem, state, quantity.of)) found.push_back(&quantity);
    return found;
}

std::string column_name(const BodyQuantity& quantity)
{
    return std::string(quantity.name).append(unit_suffix(quantity.unit));
}

} // namespace quicksand
