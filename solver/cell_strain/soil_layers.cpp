#include "solver/cell_strain/soil_layers.hpp"

#include "solver/cell_strain/cell_walk.hpp"
#include "solver/problem/buoyancy.hpp"
#include "solver/problem/kept_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <variant>

namespace quicksand {

namespace {

/// A stress in the plane [Pa].
struct PlaneStress {
    double xx = 0.0, yy = 0.0, xy = 0.0;

    Vector2 on(const Vector2& n) const { return {xx * n.x() + xy * n.y(), xy * n.x() + yy * n.y()}; }
};

/// What the soil of one side of a face has in a cell: means over its volume.
struct Side {
    double volume = 0.0;                   // [m3/m]
    double density = 0.0;                  // of the grains, per volume of the soil [kg/m3]
    double weight = 0.0;                   // of the soil, below the level of the water less buoyancy [N/m3]
    double constrained = 0.0, shear = 0.0; // M and G of unloading [Pa]
    double resistivity = 0.0;              // largest of wet soil to flow [N s/m4]
    bool yields = false;                   // a particle does
    Vector2 centre = Vector2::Zero();      // [m]
    PlaneStress stress;                    // total, less the static pressure of the water
    PlaneStress change;                    // of it in an elastic step
};

/// Whether a particle strains otherwise than by its moduli of unloading.
bool yields_now(const SkeletonLaw& law, std::size_t p, const Particles& particles)
{
    return damps_vibrations(law) || count_at_failure(law, p, p + 1, particles) > 0;
}

/// Add a particle's part of the sums.
void add_particle(const Problem& problem, double dt, const Particles& particles, std::size_t p, Side& side)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    const double V = particles.volume[p];
    const double M =
        std::visit([&](const auto& law) { return expected_moduli(law, dt, p, p + 1, particles).stiffest; },
                   material.law);
    const double G =
        M * std::visit([](const auto& law) { return shear_modulus(law) / constrained_modulus(law); },
                       material.law);
    const Gradients& L = particles.velocity_gradient_solid;
    const SymmetricTensors& s = particles.stress;
    const double pressure = particles.pore_pressure.empty() ? 0.0 : particles.pore_pressure[p];
    const double mean = dt * (M - 2.0 * G) * (L.xx[p] + L.yy[p]);
    side.volume += V;
    side.constrained += V * M;
    side.shear += V * G;
    side.centre += V * place_in_equations(problem, particles)[p];
    side.stress.xx += V * (s.xx[p] - pressure);
    side.stress.yy += V * (s.yy[p] - pressure);
    side.stress.xy += V * s.xy[p];
    side.change.xx += V * (mean + 2.0 * G * dt * L.xx[p]);
    side.change.yy += V * (mean + 2.0 * G * dt * L.yy[p]);
    side.change.xy += V * G * dt * (L.xy[p] + L.yx[p]);
    side.density += particles.mass_solid[p];
    side.yields = side.yields || yields_now(material.law, p, particles);
    side.weight += problem.gravity * particles.mass_solid[p];
    if (!problem.water || !is_wet(material)) return;
    const double displaced = submerged_part(problem, particles, p) - particles.porosity[p];
    side.weight -= V * displaced * problem.water->density * problem.gravity;
    side.resistivity = std::max(side.resistivity, flow_resistivity(material, *problem.water, particles, p));
}

void make_means(Side& side)
{
    const double scale = 1.0 / side.volume;
    side.centre *= scale;
    for (double* mean : {&side.density, &side.weight, &side.constrained, &side.shear}) *mean *= scale;
    for (PlaneStress* mean : {&side.stress, &side.change}) {
        mean->xx *= scale;
        mean->yy *= scale;
        mean->xy *= scale;
    }
}

struct Sides {
    Side a, b; // the main soil of the cell and all others
};

/// None where all of a soil are slivers.
std::optional<Sides> sides_of(const Problem& problem, double dt, CellEntries cell, std::int32_t main,
                              const Soils& soils)
{
    Sides sides;
    for (const std::int32_t k : cell)
        if (!soils.is_sliver(k))
            add_particle(problem, dt, soils.particles, static_cast<std::size_t>(k),
                         soils[k] == main ? sides.a : sides.b);
    if (sides.a.volume == 0.0 || sides.b.volume == 0.0) return std::nullopt;
    make_means(sides.a);
    make_means(sides.b);
    return sides;
}

/// w, the part of the jump across the face that the water allows [-].
double allowed_by_water(SharedWater water, double dt, double cell_size, double M, const Sides& sides)
{
    const double resistivity = std::max(sides.a.resistivity, sides.b.resistivity);
    if (water == SharedWater::none || resistivity == 0.0) return 1.0;
    if (water == SharedWater::kept) return 0.0;
    return dt / (dt + cell_size * cell_size * resistivity / M);
}

/// Whether both soils may shear in unlike ways: not where the stiffer one, or of equally stiff ones the one
/// that does not yield, has no whole cell around, and the other one has.
bool may_part(const Side& a, const Side& b, const WholeCells& whole)
{
    constexpr double clearly = 1.5; // of moduli
    const bool a_bears =
        a.shear > clearly * b.shear || (b.shear < clearly * a.shear && b.yields && !a.yields);
    const bool b_bears =
        b.shear > clearly * a.shear || (a.shear < clearly * b.shear && a.yields && !b.yields);
    if (a_bears) return whole.of_main || !whole.of_others;
    if (b_bears) return whole.of_others || !whole.of_main;
    return true;
}

/// By how much the tractions on the plane differ between the centres of both soils at rest, where all
/// stresses grow with depth in proportion, as in level ground and along slopes: by weight [Pa].
Vector2 difference_at_rest(const Vector2& n, const Sides& sides)
{
    constexpr double most = 2.0; // of the ratio of horizontal to vertical stress, half of it of shear stress
    const Side &a = sides.a, &b = sides.b;
    const auto mean = [&](double PlaneStress::*part) {
        return (a.volume * a.stress.*part + b.volume * b.stress.*part) / (a.volume + b.volume);
    };
    const double yy = mean(&PlaneStress::yy);
    const double horizontal = yy < 0.0 ? std::clamp(mean(&PlaneStress::xx) / yy, 0.0, most) : 1.0,
                 shear = yy < 0.0 ? std::clamp(mean(&PlaneStress::xy) / yy, -0.5 * most, 0.5 * most) : 0.0;
    const double weight = (a.volume * a.weight + b.volume * b.weight) / (a.volume + b.volume);
    return weight * (a.centre - b.centre).y() * PlaneStress{horizontal, 1.0, shear}.on(n);
}

/// What decays in a step of the difference of the tractions that is left [Pa].
Vector2 decaying_difference(const Vector2& n, const Sides& sides, double dt, double cell_size)
{
    constexpr double waves = 5.0; // through a cell, in which it decays
    const Side &a = sides.a, &b = sides.b;
    const double speed = std::sqrt(std::max(a.constrained / a.density, b.constrained / b.density));
    return dt / (dt + waves * cell_size / speed) *
           (a.stress.on(n) - b.stress.on(n) - difference_at_rest(n, sides));
}

/// j, as a rate [1/s].
Vector2 jump_across(const Vector2& n, const Sides& sides, const WholeCells& whole, SharedWater water,
                    double dt, double cell_size)
{
    const Side &a = sides.a, &b = sides.b;
    const double f_a = a.volume / (a.volume + b.volume), f_b = 1.0 - f_a;
    const double M = f_b * a.constrained + f_a * b.constrained, G = f_b * a.shear + f_a * b.shear;
    const Vector2 r = a.change.on(n) - b.change.on(n) + decaying_difference(n, sides, dt, cell_size);
    const double r_n = r.dot(n), w = allowed_by_water(water, dt, cell_size, M, sides);
    Vector2 j = -w * r_n / M * n;
    if (may_part(a, b, whole)) j -= (r - r_n * n) / G;
    return j / dt;
}

void part_strain(const Problem& problem, double dt, const CellLists& lists, std::size_t slot,
                 const SharedSoils& shared, Particles& particles)
{
    const Soils soils{shared.of_material, shared.slivers, particles};
    const CellEntries cell = entries_of(lists, slot);
    const double h = problem.grid.cell_size;
    const std::int32_t main = main_soil(cell, soils);
    const std::optional<Sides> sides = sides_of(problem, dt, cell, main, soils);
    if (!sides) return;
    const PartsAround parts = parts_around(problem.grid, lists, slot, main, soils);
    const Vector2 n = normal_of_face(parts, sides->a.centre - sides->b.centre, h);
    if (n.isZero(0.0)) return;
    const Vector2 j = jump_across(n, *sides, whole_cells(parts), shared.water, dt, h);
    const double xx = j.x() * n.x(), yy = j.y() * n.y(), xy = 0.5 * (j.x() * n.y() + j.y() * n.x());
    const double f_a = sides->a.volume / (sides->a.volume + sides->b.volume), f_b = 1.0 - f_a;
    Gradients& L = particles.velocity_gradient_solid;
    for (const std::int32_t k : cell) {
        if (soils.is_sliver(k)) continue;
        const auto p = static_cast<std::size_t>(k);
        const double part = soils[k] == main ? f_b : -f_a;
        L.xx[p] += part * xx;
        L.yy[p] += part * yy;
        L.xy[p] += part * xy; // half of the shear in each: the spin stays
        L.yx[p] += part * xy;
    }
}

SharedWater shared_water(const Problem& problem, Stage stage)
{
    if (keeps_water(problem, stage)) return SharedWater::kept;
    const bool flows = stage == Stage::shaking && water_flow(problem) == WaterFlow::coupled;
    return flows ? SharedWater::flows : SharedWater::none;
}

} // namespace

/// The first material that is the same soil but for its name, its weight, its damping of vibrations and how
/// it drains from above.
std::int32_t soil_of(const Problem& problem, std::size_t m)
{
    const std::vector<Material>& all = problem.materials;
    const Material& own = all[all[m].part_of.value_or(m)];
    const SkeletonLaw law = undamped(without_weight(own.law));
    const auto first = std::find_if(all.begin(), all.end(), [&](const Material& other) {
        return !other.part_of && other.has_pores && undamped(without_weight(other.law)) == law &&
               other.volumetric_strain == own.volumetric_strain &&
               other.permeability_law == own.permeability_law &&
               other.hydraulic_conductivity == own.hydraulic_conductivity &&
               other.conductivity_gravity == own.conductivity_gravity;
    });
    return static_cast<std::int32_t>(first - all.begin());
}

SharedSoils make_shared_soils(const Problem& problem, Stage stage)
{
    SharedSoils shared;
    std::set<std::int32_t> soils;
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        const Material& material = problem.materials[m];
        const bool shares = material.has_pores && bears_stress_as_drawn(material.law);
        shared.of_material.push_back(shares ? soil_of(problem, m) : -1);
        if (shares) soils.insert(shared.of_material.back());
    }
    if (soils.size() < 2) shared.of_material.clear();
    for (const Sliver& sliver : problem.cut_domains.slivers) {
        const auto number = static_cast<std::size_t>(sliver.identifier);
        if (shared.slivers.size() <= number) shared.slivers.resize(number + 1, 0);
        shared.slivers[number] = 1;
    }
    shared.water = shared_water(problem, stage);
    if (shared.of_material.empty()) return shared;
    for (const Material& first : problem.materials)
        for (const Material& second : problem.materials)
            shared.contrasts.push_back(contrast_between(first.law, second.law));
    return shared;
}

void part_strains_of_soils(const Problem& problem, double dt, const CellLists& lists,
                           const SharedSoils& shared, Particles& particles)
{
    if (shared.of_material.empty()) return;
    const Soils soils{shared.of_material, shared.slivers, particles};
    for_each_slot(lists, [&](std::size_t slot) {
        if (is_shared(entries_of(lists, slot), soils))
            part_strain(problem, dt, lists, slot, shared, particles);
    });
}

} // namespace quicksand
