#include "solver/motion/soil_layers.hpp"

#include "solver/base/slope_fit.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <variant>

namespace quicksand {

namespace {

using Entries = std::span<const std::int32_t>; // particles of a cell

Entries entries_of(const CellLists& lists, std::size_t slot)
{
    const auto first = static_cast<std::size_t>(lists.cell_start[slot]);
    return Entries(lists.order).subspan(first, static_cast<std::size_t>(lists.cell_start[slot + 1]) - first);
}

/// The soils of particles.
struct Soils {
    const SoilOfMaterial& of_material;
    const Particles& particles;
    std::int32_t operator[](std::int32_t p) const
    {
        return of_material[static_cast<std::size_t>(particles.material[static_cast<std::size_t>(p)])];
    }
};

/// Whether a cell has several soils, and no solid.
bool is_shared(Entries cell, const Soils& soils)
{
    bool shared = false;
    for (const std::int32_t p : cell) {
        const std::int32_t soil = soils[p];
        if (soil < 0) return false;
        shared = shared || soil != soils[cell.front()];
    }
    return shared;
}

/// The soil with the largest volume in the cell.
std::int32_t main_soil(Entries cell, const Soils& soils)
{
    std::int32_t main = 0;
    double largest = 0.0; // [m3/m]
    for (const std::int32_t first : cell) {
        double volume = 0.0;
        for (const std::int32_t p : cell)
            if (soils[p] == soils[first]) volume += soils.particles.volume[static_cast<std::size_t>(p)];
        if (volume > largest || (volume == largest && soils[first] < main))
            largest = volume, main = soils[first];
    }
    return main;
}

/// The part of a cell's soil that is `soil`; below zero without any soil [-].
double part_of(std::int32_t soil, Entries cell, const Soils& soils)
{
    double part = 0.0, all = 0.0; // [m3/m]
    for (const std::int32_t p : cell) {
        if (soils[p] < 0) continue;
        const double volume = soils.particles.volume[static_cast<std::size_t>(p)];
        all += volume;
        if (soils[p] == soil) part += volume;
    }
    return all > 0.0 ? part / all : -1.0;
}

/// The parts of a soil in a cell and those around it, by row and column; below zero without soil.
std::array<std::array<double, 3>, 3> parts_around(const BackgroundGrid& grid, const CellLists& lists,
                                                  std::size_t slot, std::int32_t soil, const Soils& soils)
{
    const int columns = grid.all_cells_x(), rows = grid.all_cells_y();
    const int cell = lists.cell_of_slot[slot], i = cell % columns, j = cell / columns;
    std::array<std::array<double, 3>, 3> parts;
    for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) {
            const int column = i + a - 1, row = j + b - 1;
            const bool inside = column >= 0 && column < columns && row >= 0 && row < rows;
            const auto neighbour = static_cast<std::size_t>(row * columns + column);
            parts[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)] =
                inside ? part_of(soil,
                                 entries_of(lists, static_cast<std::size_t>(lists.slot_of_cell[neighbour])),
                                 soils)
                       : -1.0;
        }
    }
    return parts;
}

/// Normal of the face between a soil and the others in a cell; zero where no direction stands out.
Vector2 normal_of_face(const std::array<std::array<double, 3>, 3>& parts)
{
    const double here = parts[1][1];
    double xx = 0.0, xy = 0.0, yy = 0.0; // sum of g g^T
    for (const std::size_t b : {0U, 2U}) {
        for (const std::size_t a : {0U, 2U}) {
            const double x = static_cast<double>(a) - 1.0, y = static_cast<double>(b) - 1.0; // [cells]
            if (parts[1][a] < 0.0 && parts[b][1] < 0.0) continue; // a diagonal alone tells no direction
            SlopeFit fit;
            if (parts[1][a] >= 0.0) fit.add({x, 0.0}, parts[1][a] - here);
            if (parts[b][1] >= 0.0) fit.add({0.0, y}, parts[b][1] - here);
            if (parts[b][a] >= 0.0) fit.add({x, y}, parts[b][a] - here);
            const Vector2 g = fit.slope(1.0);
            xx += g.x() * g.x();
            xy += g.x() * g.y();
            yy += g.y() * g.y();
        }
    }
    const double apart = xx - yy, between = std::hypot(apart, 2.0 * xy); // of the eigenvalues
    if (!(between > 1e-9 * (xx + yy))) return Vector2::Zero();
    const double cosine = apart / between; // of twice the angle between the eigenvector and x
    return {std::sqrt(0.5 * (1.0 + cosine)), std::copysign(std::sqrt(0.5 * (1.0 - cosine)), xy)};
}

/// What the soil of one side has in a cell: sums over its volume.
struct Side {
    double volume = 0.0;                   // [m3/m]
    double constrained = 0.0, shear = 0.0; // M and G of unloading, times volume
    Vector2 traction = Vector2::Zero();    // on the face, at the end of the step while elastic, times volume

    void add(double V, double M, double G, const Vector2& t)
    {
        volume += V;
        constrained += V * M;
        shear += V * G;
        traction += V * t;
    }
};

/// Add a particle of a material to its side of a face of normal n.
void add_particle(const Material& material, double dt, const Vector2& n, const Particles& particles,
                  std::size_t p, Side& side)
{
    const double M =
        std::visit([&](const auto& law) { return expected_moduli(law, dt, p, p + 1, particles).stiffest; },
                   material.law);
    const double G =
        M * std::visit([](const auto& law) { return shear_modulus(law) / constrained_modulus(law); },
                       material.law);
    const Gradients& L = particles.velocity_gradient_solid;
    const SymmetricTensors& s = particles.stress;
    const double pressure = particles.pore_pressure.empty() ? 0.0 : particles.pore_pressure[p];
    const double mean = dt * (M - 2.0 * G) * (L.xx[p] + L.yy[p]) - pressure;
    const double xx = s.xx[p] + mean + 2.0 * G * dt * L.xx[p], yy = s.yy[p] + mean + 2.0 * G * dt * L.yy[p],
                 xy = s.xy[p] + G * dt * (L.xy[p] + L.yx[p]);
    side.add(particles.volume[p], M, G, {xx * n.x() + xy * n.y(), xy * n.x() + yy * n.y()});
}

void part_strain(const Problem& problem, double dt, const CellLists& lists, std::size_t slot,
                 const Soils& soils, Particles& particles)
{
    const Entries cell = entries_of(lists, slot);
    const std::int32_t main = main_soil(cell, soils);
    const Vector2 n = normal_of_face(parts_around(problem.grid, lists, slot, main, soils));
    if (n.isZero(0.0)) return;
    Side a, b;
    for (const std::int32_t k : cell) {
        const auto p = static_cast<std::size_t>(k);
        add_particle(problem.materials[static_cast<std::size_t>(particles.material[p])], dt, n, particles, p,
                     soils[k] == main ? a : b);
    }
    const double f_a = a.volume / (a.volume + b.volume), f_b = 1.0 - f_a;
    const double M = f_b * a.constrained / a.volume + f_a * b.constrained / b.volume,
                 G = f_b * a.shear / a.volume + f_a * b.shear / b.volume;
    const Vector2 r = a.traction / a.volume - b.traction / b.volume;
    const double r_n = r.dot(n);
    const Vector2 j = -(r_n / M * n + (r - r_n * n) / G) / dt; // rate [1/s]
    const double xx = j.x() * n.x(), yy = j.y() * n.y(), xy = 0.5 * (j.x() * n.y() + j.y() * n.x());
    Gradients& L = particles.velocity_gradient_solid;
    for (const std::int32_t k : cell) {
        const auto p = static_cast<std::size_t>(k);
        const double part = soils[k] == main ? f_b : -f_a;
        L.xx[p] += part * xx;
        L.yy[p] += part * yy;
        L.xy[p] += part * xy; // half of the shear in each: the spin stays
        L.yx[p] += part * xy;
    }
}

} // namespace

SoilOfMaterial soils_that_share_cells(const Problem& problem)
{
    SoilOfMaterial soil_of;
    std::set<std::int32_t> soils;
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        const Material& material = problem.materials[m];
        soil_of.push_back(material.has_pores ? static_cast<std::int32_t>(material.part_of.value_or(m)) : -1);
        if (material.has_pores) soils.insert(soil_of.back());
    }
    return soils.size() > 1 ? soil_of : SoilOfMaterial();
}

void part_strains_of_soils(const Problem& problem, double dt, const CellLists& lists,
                           const SoilOfMaterial& soil_of, Particles& particles)
{
    if (soil_of.empty()) return;
    const Soils soils{soil_of, particles};
    for_each_tile(lists, [&](const Tile& tile) {
        for (std::int32_t c = tile.first_cell; c < tile.last_cell; ++c) {
            const auto slot = static_cast<std::size_t>(c);
            if (is_shared(entries_of(lists, slot), soils))
                part_strain(problem, dt, lists, slot, soils, particles);
        }
    });
}

} // namespace quicksand
