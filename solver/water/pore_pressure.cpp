#include "solver/water/pore_pressure.hpp"

#include "solver/water/pressure_slope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace quicksand {

namespace {

/// Call work(slot, first, last) for the cells of a tile that hold soil, with their entries of the lists.
template <class Work>
void for_each_filled_cell(const CellLists& lists, const Tile& tile, Work&& work)
{
    if (lists.first_entry(tile) == lists.last_entry(tile)) return;
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
        const auto slot = static_cast<std::size_t>(c);
        const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
        const auto last = static_cast<std::size_t>(lists.cell_start[slot + 1]);
        if (first != last) work(slot, first, last);
    }
}

/// gamma_w, where moving up or down changes the static pressure [N/m3].
double static_gradient(const Problem& problem)
{
    return problem.strain == StrainForm::large ? problem.water->density * problem.gravity : 0.0;
}

/// What makes the excess pressure smooth where water stands above the level: it refers to a static pressure
/// that is none there, so that still water of another level has a kink in it at the level [Pa].
double lift_above_level(const Problem& problem, double y)
{
    const double level = problem.water->level;
    return y > level ? pressure_below(problem, y, level) : 0.0; // most soil lies below, without a call
}

/// Pressure of a particle in the mean of its cell, lifted [Pa].
double lifted_pressure(const Problem& problem, const Vectors& place, const Particles& particles,
                       std::size_t p)
{
    const double deficit = particles.tension_deficit.empty() ? 0.0 : particles.tension_deficit[p];
    return particles.pore_pressure[p] + deficit + lift_above_level(problem, place.y[p]);
}

/// Sums over the particles of one cell.
struct CellSums {
    double volume = 0.0;              // [m3/m]
    double pressure = 0.0;            // lifted [Pa m3/m]
    double rise = 0.0;                // volume times v_y [m4/s per metre]
    Vector2 moment = Vector2::Zero(); // volume times position [m4/m]
};

CellSums sum_cell(const Problem& problem, const CellLists& lists, std::size_t first, std::size_t last,
                  const Particles& particles, const Vectors& place)
{
    CellSums sums;
    for (std::size_t k = first; k < last; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const double V = particles.volume[p];
        sums.volume += V;
        sums.pressure += V * lifted_pressure(problem, place, particles, p);
        sums.rise += V * particles.velocity_solid.y[p];
        sums.moment += V * place[p];
    }
    return sums;
}

/// Whether a cell beside a solid has so much soil of others besides its own that its pressure must be flat:
/// the force of a slope on the means (new_part_of_slopes) grows with the square of its length. With 0.4 of a
/// cell more it is stable, with 0.5 it is not.
bool is_enlarged(const Problem& problem, double volume)
{
    return volume > 1.4 * problem.grid.cell_size * problem.grid.cell_size;
}

/// dp of a tile's cells from divergence(p) of the flux [1/s].
template <class Divergence>
void increments_of(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                   const Particles& particles, Divergence&& divergence, Scalars& increment)
{
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        double pores = 0.0, outflow = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            pores += particles.volume[p] * particles.porosity[p];
            outflow += particles.volume[p] * divergence(p);
        }
        increment[slot] = -dt * problem.water->bulk_modulus * outflow / pores;
    });
}

/// ln k of the materials, whose slopes end at faces between them; empty where all are alike or no water
/// flows.
Scalars logarithms_of_conductivity(const Problem& problem)
{
    Scalars logarithms;
    if (water_flow(problem) != WaterFlow::coupled) return logarithms;
    for (const Material& material : problem.materials) {
        const double k =
            material.has_pores ? material.hydraulic_conductivity / material.conductivity_gravity : 0.0;
        logarithms.push_back(k > 0.0 ? std::log(k) : 0.0);
    }
    const bool alike = std::all_of(logarithms.begin(), logarithms.end(),
                                   [&](double each) { return each == logarithms.front(); });
    if (alike) logarithms.clear();
    return logarithms;
}

void note_conductivities(const CellLists& lists, std::size_t slot, std::size_t first, std::size_t last,
                         const Particles& particles, CellMeans& means)
{
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t k = first; k < last; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[k]);
        const double of_soil = means.of_material[static_cast<std::size_t>(particles.material[p])];
        least = std::min(least, of_soil);
        most = std::max(most, of_soil);
    }
    means.least_conductive[slot] = least;
    means.most_conductive[slot] = most;
}

/// Least excess pressure of water at height y without cavities [Pa].
double lowest_excess(const Problem& problem, double y)
{
    return *problem.water->cavitation_pressure - atmospheric_pressure - static_water_pressure(problem, y);
}

/// Keep the excess pressure at or above `lowest` and what is beyond as a deficit besides the cell's [Pa].
void cavitate(double lowest, double deficit_of_cell, std::size_t p, Particles& particles)
{
    const double wanted = particles.pore_pressure[p];
    particles.pore_pressure[p] = std::max(wanted, lowest);
    particles.tension_deficit[p] = deficit_of_cell + wanted - particles.pore_pressure[p];
}

/// A slope, and the part of it that the particles take over in a step; the rest stays as it is [-].
struct FollowedSlope {
    Vector2 slope; // [Pa/m]
    double part = 1.0;
};

/// Planes through the means of the cells with slope_in(slot), a FollowedSlope.
template <class SlopeIn>
void lay_planes(const Problem& problem, const CellLists& lists, const Tile& tile, const CellMeans& means,
                Particles& particles, SlopeIn&& slope_in)
{
    const Vectors& place = place_in_equations(problem, particles);
    const bool cavitates = problem.water->cavitation_pressure.has_value();
    const bool has_solids = has_soil_and_solids(problem);
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        const Vector2 centre = means.centre[slot];
        const bool is_flat = has_solids && is_enlarged(problem, means.volume[slot]);
        const auto [slope, part] = is_flat ? FollowedSlope{Vector2::Zero()} : slope_in(slot);
        const double mean = means.pore_pressure[slot];
        const double old_mean =
            part == 1.0
                ? 0.0
                : sum_cell(problem, lists, first, last, particles, place).pressure / means.volume[slot];
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            double beside = slope.dot(place[p] - centre); // of the mean
            if (part != 1.0)
                beside =
                    part * beside + (1.0 - part) * (lifted_pressure(problem, place, particles, p) - old_mean);
            particles.pore_pressure[p] = mean + beside - lift_above_level(problem, place.y[p]);
            if (cavitates)
                cavitate(lowest_excess(problem, place.y[p]), means.tension_deficit[slot], p, particles);
        }
    });
}

/// Part of a step in the time h^2/c_v in which pressures even out over a cell, of that of its soils in which
/// they do last; c_v = M k/gamma_w = M n^2/C with the drag C, of the material as it is given [-].
double part_evened_out(const Problem& problem, double dt, const CellLists& lists, const Particles& particles,
                       std::size_t slot)
{
    const double h = problem.grid.cell_size;
    double longest = 0.0; // [s]
    for (std::int32_t k = lists.cell_start[slot]; k < lists.cell_start[slot + 1]; ++k) {
        const auto p = static_cast<std::size_t>(lists.order[static_cast<std::size_t>(k)]);
        const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
        const double n = material.porosity, C = drag_coefficient(material, *problem.water, n);
        const double M = std::visit([](const auto& law) { return constrained_modulus(law); }, material.law);
        longest = std::max(longest, h * h * C / (n * n * M));
    }
    return dt / (dt + longest);
}

} // namespace

void select_wet(const Problem& problem, const Particles& particles, const CellLists& all, CellLists& wet)
{
    if (wet.changes == all.changes) return;
    wet.changes = all.changes;
    wet.order.clear();
    const std::size_t slots = all.cell_start.size() - 1;
    wet.cell_start.assign(all.cell_start.size(), 0);
    for (std::size_t slot = 0; slot < slots; ++slot) {
        for (std::int32_t k = all.cell_start[slot]; k < all.cell_start[slot + 1]; ++k) {
            const std::int32_t p = all.order[static_cast<std::size_t>(k)];
            const auto material = static_cast<std::size_t>(particles.material[static_cast<std::size_t>(p)]);
            if (is_wet(problem.materials[material])) wet.order.push_back(p);
        }
        wet.cell_start[slot + 1] = static_cast<std::int32_t>(wet.order.size());
    }
}

void set_wet_volumes(const Problem& problem, const Particles& particles, Scalars& volumes)
{
    volumes = particles.volume;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_wet(problem.materials[static_cast<std::size_t>(particles.material[p])])) volumes[p] = 0.0;
    }
}

void carry_moisture(const Problem& problem, Particles& particles)
{
    const Gradients& Cs = particles.affine_velocity_solid;
    Gradients& Cw = particles.affine_velocity_fluid;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (problem.materials[static_cast<std::size_t>(particles.material[p])].saturated) continue;
        particles.velocity_fluid.set(p, particles.velocity_solid[p]);
        Cw.xx[p] = Cs.xx[p], Cw.xy[p] = Cs.xy[p];
        Cw.yx[p] = Cs.yx[p], Cw.yy[p] = Cs.yy[p];
    }
}

CellMeans make_cell_means(const Problem& problem)
{
    const Scalars zeros(problem.grid.cell_count(), 0.0);
    CellMeans means{zeros, zeros, zeros, {zeros, zeros}, {}, {}, {}, logarithms_of_conductivity(problem)};
    if (problem.water->cavitation_pressure) means.tension_deficit = zeros;
    if (!means.of_material.empty()) means.least_conductive = means.most_conductive = zeros;
    return means;
}

void explicit_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                         const Particles& particles, const Scalars& flux_divergence, Scalars& increment)
{
    increments_of(
        problem, dt, lists, tile, particles, [&](std::size_t p) { return flux_divergence[p]; }, increment);
}

void undrained_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                          const Particles& particles, Scalars& increment)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const bool large = problem.strain == StrainForm::large;
    increments_of(
        problem, dt, lists, tile, particles,
        [&](std::size_t p) { return L.xx[p] + L.yy[p] + (large ? growth_of_turn(dt, L, p) : 0.0); },
        increment);
}

void prepare_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                        const Particles& particles, Scalars& storage, Scalars& expected)
{
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        double pores = 0.0, volume = 0.0, rate = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            const double V = particles.volume[p];
            volume += V;
            pores += V * particles.porosity[p];
            rate += V * particles.pore_pressure_rate[p];
        }
        storage[slot] = pores / (acting_weight * problem.water->bulk_modulus);
        expected[slot] = acting_weight * dt * rate / volume;
    });
}

void sum_growth_of_turns(double dt, const CellLists& lists, const Tile& tile, const Particles& particles,
                         Scalars& growth)
{
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        double sum = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            sum += particles.volume[p] * growth_of_turn(dt, particles.affine_velocity_solid, p);
        }
        growth[slot] = dt * sum;
    });
}

void prepare_cavities(const Problem& problem, const CellLists& lists, const Tile& tile,
                      const Particles& particles, const Scalars& expected, Scalars& deficit,
                      Scalars& lowest_increment)
{
    const Scalars& height = place_in_equations(problem, particles).y;
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        double volume = 0.0, missing = 0.0, above = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            const auto p = static_cast<std::size_t>(lists.order[k]);
            const double V = particles.volume[p];
            volume += V;
            missing += V * particles.tension_deficit[p];
            above += V * (particles.pore_pressure[p] - lowest_excess(problem, height[p]));
        }
        deficit[slot] = acting_weight * missing / volume;
        const double to_limit = -above / volume;
        lowest_increment[slot] = std::max(to_limit, acting_weight * to_limit - expected[slot]);
    });
}

void apply_increments(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                      const Scalars& increment, Particles& particles, CellMeans& means)
{
    const Vectors& place = place_in_equations(problem, particles);
    const double weight_density = static_gradient(problem);
    for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c)
        means.volume[static_cast<std::size_t>(c)] = 0.0;
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        const CellSums sums = sum_cell(problem, lists, first, last, particles, place);
        means.volume[slot] = sums.volume;
        means.centre.set(slot, sums.moment / sums.volume);
        if (!means.of_material.empty()) note_conductivities(lists, slot, first, last, particles, means);
        const double slope = means.centre.y[slot] < problem.water->level ? weight_density : 0.0;
        means.pore_pressure[slot] = (sums.pressure + dt * slope * sums.rise) / sums.volume + increment[slot];
        if (problem.water->cavitation_pressure) {
            const double wanted = means.pore_pressure[slot];
            const double y = means.centre.y[slot];
            means.pore_pressure[slot] =
                std::max(wanted, lowest_excess(problem, y) + lift_above_level(problem, y));
            means.tension_deficit[slot] = wanted - means.pore_pressure[slot];
        }
    });
}

double following_part(double dt, double last_step)
{
    constexpr double least_part = 0.5; // of the last step, with which rates follow wholly
    const double part = last_step > 0.0 ? std::min(1.0, dt / (least_part * last_step)) : 1.0;
    return part * part;
}

void follow_solved_pressure(double dt, const CellLists& lists, const Tile& tile, const SolvedPressure& solved,
                            Particles& particles, CellMeans& means)
{
    for_each_filled_cell(lists, tile, [&](std::size_t slot, std::size_t first, std::size_t last) {
        const double increment = solved.increment[slot];
        const double rate = // r + following_part b (dp/dt - r)
            (solved.following_part * increment + solved.expected[slot] / acting_weight) / dt;
        const double change = (increment + solved.expected[slot]) / acting_weight; // dp without deficit
        means.unfelt_change[slot] = change - increment;
        for (std::size_t k = first; k < last; ++k)
            particles.pore_pressure_rate[static_cast<std::size_t>(lists.order[k])] = rate;
    });
}

void reconstruct_pore_pressure(const Problem& problem, const CellLists& lists, const Tile& tile,
                               const CellMeans& means, Particles& particles)
{
    const auto slope_in = [&](std::size_t slot) {
        return FollowedSlope{pressure_slope(problem, lists, means, slot,
                                            [&](std::size_t other) { return means.pore_pressure[other]; })};
    };
    lay_planes(problem, lists, tile, means, particles, slope_in);
}

void reconstruct_solved_pressure(const Problem& problem, double dt, const CellLists& lists, const Tile& tile,
                                 const CellMeans& means, Particles& particles)
{
    const auto part_in = [&](std::size_t slot) {
        return lists.is_below_table(slot) ? part_evened_out(problem, dt, lists, particles, slot) : 1.0;
    };
    const auto slope_in = [&](std::size_t slot) {
        const double old_part = 1.0 - (lists.is_root(slot) ? new_part_of_long_slopes : new_part_of_slopes);
        const auto pressure_of = [&](std::size_t other) {
            return means.pore_pressure[other] - old_part * means.unfelt_change[other];
        };
        return FollowedSlope{pressure_slope(problem, lists, means, slot, pressure_of), part_in(slot)};
    };
    lay_planes(problem, lists, tile, means, particles, slope_in);
}

} // namespace quicksand
