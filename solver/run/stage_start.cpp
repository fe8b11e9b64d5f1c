#include "solver/run/stage_start.hpp"

#include "solver/base/failure.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/faces/boundary.hpp"
#include "solver/motion/soil_placement.hpp"
#include "solver/problem/material_runs.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace quicksand {

namespace {

/// Whether the drawing gives this array, however the soil has moved.
bool is_drawn(std::string_view name, const Problem& problem, const StageStart& start)
{
    constexpr std::string_view memory = "memory_";
    if (name == "mass_solid" || name.starts_with(memory)) return true;
    if (start.settles && name == "water_table") return true;
    return start.settles && !settles_undrained(problem) &&
           (name == "pore_pressure" || name == "tension_deficit");
}

bool has_changed(const StageStart& start, const Particles& particles, std::size_t p)
{
    const auto region = static_cast<std::size_t>(particles.region[p]);
    return region < start.changed_soils.size() && start.changed_soils[region];
}

/// Grains of other density or porosity fill the volume that their soil has now. `reached` may be fewer than
/// those drawn, behind which others are placed.
void set_grains(const Problem& problem, const StageStart& start, const Particles& drawn,
                const Particles& reached, Particles& particles)
{
    for (std::size_t p = 0; p < reached.size(); ++p) {
        if (drawn.mass_solid[p] == reached.mass_solid[p] || !has_changed(start, particles, p)) continue;
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        if (!particles.porosity.empty()) particles.porosity[p] = material.porosity;
        particles.mass_solid[p] = (1.0 - material.porosity) * material.grain_density * particles.volume[p];
    }
}

/// Water that has no arrays of its own in the stage before moves with the grains and fills the pores.
void set_water(const Particles& reached, Particles& particles)
{
    if (reached.velocity_fluid.x.empty() && !particles.velocity_fluid.x.empty()) {
        particles.velocity_fluid = particles.velocity_solid;
        particles.affine_velocity_fluid = particles.affine_velocity_solid;
    }
    if (reached.water_volume.empty())
        for (std::size_t p = 0; p < particles.water_volume.size(); ++p)
            particles.water_volume[p] = particles.porosity[p] * particles.volume[p];
}

/// A memory begins with zeros, as add_memory() lets it.
void forget(std::size_t first, std::size_t last, SoilMemory& memory)
{
    for (Scalars& column : memory)
        std::fill(column.begin() + static_cast<std::ptrdiff_t>(first),
                  column.begin() + static_cast<std::ptrdiff_t>(last), 0.0);
}

/// The memory of laws goes on where the soil is the same, and begins at the present stress elsewhere. A law
/// that remembers nothing leaves nothing to that of a later stage.
void set_memory(const Problem& problem, const StageStart& start, SoilMemory reached, Particles& particles)
{
    const std::size_t columns = memory_columns(problem);
    reached.resize(columns, Scalars(particles.size(), 0.0));
    particles.memory = std::move(reached);
    for_each_material_run(problem, particles, 0, particles.size(),
                          [&](const Material& material, std::size_t first, std::size_t last) {
                              if (memory_of(material.law).empty())
                                  return forget(first, last, particles.memory);
                              while (first < last) {
                                  std::size_t end = first;
                                  const bool changed = has_changed(start, particles, first);
                                  while (end < last && has_changed(start, particles, end) == changed) ++end;
                                  if (changed) {
                                      forget(first, end, particles.memory);
                                      start_memory(material.law, first, end, particles);
                                  } else {
                                      complete_memory(material.law, first, end, particles);
                                  }
                                  first = end;
                              }
                          });
}

/// Soil that is dry in this stage has no pore pressure: its grains bear what its water bore, so that the
/// total stress stays.
void dry_soil(const Problem& problem, Particles& particles)
{
    if (!is_partly_wet(problem) || particles.pore_pressure.empty()) return;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
        const double pressure = std::exchange(particles.pore_pressure[p], 0.0);
        particles.stress.xx[p] -= pressure;
        particles.stress.yy[p] -= pressure;
        particles.stress.zz[p] -= pressure;
    }
}

/// Let the present pore pressure be that from which ru and excess pore pressures count: the height to which
/// water would stand that has it.
void count_pressures_from_here(const Problem& problem, Particles& particles)
{
    const double weight = problem.water ? problem.water->density * problem.gravity : 0.0; // [N/m3]
    for (std::size_t p = 0; p < particles.size(); ++p)
        particles.initial_vertical_effective_stress[p] = -particles.stress.yy[p];
    if (weight <= 0.0 || particles.pore_pressure.empty()) return;
    particles.water_table.assign(particles.size(), problem.water->level);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
        const double y = place_in_equations(problem, particles).y[p];
        particles.water_table[p] =
            y + (static_water_pressure(problem, y) + particles.pore_pressure[p]) / weight;
    }
}

std::size_t pieces_that_let_go(const Problem& problem)
{
    std::size_t count = 0;
    for_each_held_piece(problem, [&](const Boundary&, const BoundaryPiece&) { ++count; });
    return count;
}

/// The same without columns of free fields.
State begin_body(const Problem& problem, const State& initial, State reached, const StageStart& start)
{
    MatchedSoil matched = match_soil(initial.particles, std::move(reached.particles));
    if (!matched.is_same && !start.settles)
        throw InputError(
            "the stage begins with other soil than the stage before ended with"
            "\nexpected: regions with soil = \"absent\" in both, or a stage of kind = \"settle\" "
            "or \"seepage\", in which placed soil comes to rest");
    const Particles& drawn = matched.drawn;
    Particles& goes_on = matched.reached;
    State state;
    state.stages_before = reached.stages_before + 1;
    state.particles = drawn;
    Particles& particles = state.particles;
    if (!goes_on.former_displacement.x.empty() && particles.former_displacement.x.empty())
        add_former_displacement(particles); // a scene without stages that goes on from one with them
    std::vector<const Scalars*> former;
    for_each_array(goes_on, [&](const char* name, const Scalars& values) {
        if (!std::string_view(name).starts_with("memory_")) former.push_back(&values);
    });
    std::size_t next = 0;
    for_each_array(particles, [&](const char* name, Scalars& values) {
        if (std::string_view(name).starts_with("memory_")) return;
        const Scalars& before = *former[next++];
        if (!is_drawn(name, problem, start) && !values.empty() && !before.empty())
            std::copy(before.begin(), before.end(), values.begin()); // what is placed stays as drawn
    });
    if (!start.settles && !goes_on.water_table.empty()) particles.water_table = goes_on.water_table;
    set_grains(problem, start, drawn, goes_on, particles);
    set_water(goes_on, particles);
    dry_soil(problem, particles);
    if (start.settles) {
        place_soil(problem, matched, particles);
        set_at_rest(particles);
        return state;
    }
    state.last_step = reached.last_step;
    state.whole_step = reached.whole_step;
    if (reached.reactions.x.size() == pieces_that_let_go(problem))
        state.reactions = std::move(reached.reactions);
    else
        state.last_step = state.whole_step = 0.0; // the reactions are found as at the start of a run
    set_memory(problem, start, std::move(goes_on.memory), particles);
    if (reached.time == 0.0) return state; // settled, and counted from there
    if (start.zero_pressures) count_pressures_from_here(problem, particles);
    if (!start.zero_displacements) return state;
    keep_displacement(particles);
    if (problem.strain == StrainForm::small) return_to_reference(particles);
    reset_reference(particles);
    return state;
}

} // namespace

State begin_stage(const Problem& problem, const State& initial, State reached, const StageStart& start)
{
    if (reached.free_fields.size() != problem.free_fields.size())
        throw InputError("the stage before has " + std::to_string(reached.free_fields.size()) +
                         " free-field columns and this one " + std::to_string(problem.free_fields.size()) +
                         "\nexpected: the same sides with soil = \"free_field\" from the first stage on");
    std::vector<FreeFieldState> columns = std::move(reached.free_fields);
    State state = begin_body(problem, initial, std::move(reached), start);
    for (std::size_t k = 0; k < columns.size(); ++k)
        columns[k].column = begin_stage(problem.free_fields[k].column, initial.free_fields[k].column,
                                        std::move(columns[k].column), start);
    state.free_fields = std::move(columns);
    return state;
}

} // namespace quicksand
