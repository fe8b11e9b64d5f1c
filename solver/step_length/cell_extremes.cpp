#include "solver/step_length/cell_extremes.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

VECTOR_KERNEL
double largest_speed_squared(const Particles& particles, std::size_t first, std::size_t last)
{
    const double *x = particles.velocity_solid.x.data(), *y = particles.velocity_solid.y.data();
    Lanes most = all_lanes(0.0);
    std::size_t p = first;
    for (; p + 4 <= last; p += 4) {
        const Lanes vx = load_lanes(x + p), vy = load_lanes(y + p), squared = vx * vx + vy * vy;
        most = squared > most ? squared : most;
    }
    double result = std::max({most[0], most[1], most[2], most[3]});
    for (; p < last; ++p) result = std::max(result, x[p] * x[p] + y[p] * y[p]);
    return result;
}

/// The end of the successive particles with the cell and the material of the first.
std::size_t end_of_cell(const BackgroundGrid& grid, const Particles& particles, std::size_t first,
                        std::size_t last)
{
    const double *x = particles.position.x.data(), *y = particles.position.y.data();
    const double h = grid.cell_size;
    const double left = grid.origin.x() + h * std::floor((x[first] - grid.origin.x()) / h);
    const double bottom = grid.origin.y() + h * std::floor((y[first] - grid.origin.y()) / h);
    std::size_t p = first + 1;
    while (p < last && x[p] >= left && x[p] < left + h && y[p] >= bottom && y[p] < bottom + h &&
           particles.material[p] == particles.material[first])
        ++p;
    return p;
}

/// Whether the particles are those of a cell that an outline cuts: some are pieces, and the cell is not full.
bool is_cut(const Problem& problem, const Particles& particles, std::size_t first, std::size_t last,
            double empty)
{
    constexpr double full = 0.01; // fraction of the cell
    const CutDomains& cut = problem.cut_domains;
    if (!cut.has_pieces() || empty <= full) return false;
    const auto numbers = particles.identifier.begin();
    return std::any_of(numbers + static_cast<std::ptrdiff_t>(first),
                       numbers + static_cast<std::ptrdiff_t>(last),
                       [&](std::int32_t number) { return cut.is_piece(number); });
}

/// G / density of the mixture of a cell, from its P-wave modulus [m2/s2].
double shear_speed_squared(const Problem& problem, const Material& material, double modulus, double porosity)
{
    const double shear_fraction = std::visit(
        [](const auto& law) { return shear_modulus(law) / constrained_modulus(law); }, material.law);
    return shear_fraction * modulus / mixture_density(problem, material, porosity);
}

/// A volume and its integrals of the speed of shear waves squared, G / density, and of its inverse.
struct ShearSum {
    double volume = 0.0;        // [m3/m]
    double speed_squared = 0.0; // [m3/m m2/s2]
    double slowness = 0.0;      // [m3/m s/m]

    ShearSum& operator+=(const ShearSum& other)
    {
        volume += other.volume;
        speed_squared += other.speed_squared;
        slowness += other.slowness;
        return *this;
    }
    double speed() const { return std::sqrt(speed_squared / volume); }
};

/// Solids apart: waves cross them within any step that follows the soil.
struct ShearSums {
    ShearSum soil, solids;

    ShearSums& operator+=(const ShearSums& other)
    {
        soil += other.soil;
        solids += other.solids;
        return *this;
    }
};

void include_cell(const Problem& problem, const Particles& particles, std::size_t first, std::size_t last,
                  MaterialExtremes& extremes, ShearSums& shear)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[first])];
    double mass = 0.0, volume = 0.0;
    for (std::size_t p = first; p < last; ++p) {
        mass += particles.mass_solid[p];
        volume += particles.volume[p];
    }
    const double porosity = 1.0 - mass / (material.grain_density * volume);
    extremes.min_porosity = std::min(extremes.min_porosity, porosity);
    extremes.max_porosity = std::max(extremes.max_porosity, porosity);
    const ParticleModuli moduli = std::visit(
        [&](const auto& law) { return particle_moduli(law, first, last, particles); }, material.law);
    const double h = problem.grid.cell_size, empty = std::max(0.0, 1.0 - volume / (h * h));
    const double speed_squared = shear_speed_squared(problem, material, moduli.mean, porosity);
    (material.has_pores ? shear.soil : shear.solids) +=
        ShearSum{volume, volume * speed_squared, volume / std::sqrt(speed_squared)};
    const double modulus = moduli.mean + empty * (moduli.stiffest - moduli.mean);
    extremes.stiffest_modulus = std::max(extremes.stiffest_modulus, modulus);
    if (is_cut(problem, particles, first, last, empty))
        extremes.stiffest_cut_modulus = std::max(extremes.stiffest_cut_modulus, modulus);
}

ShearSums include_chunk(const Problem& problem, const Particles& particles, std::size_t begin,
                        std::size_t end, CellExtremes& extremes)
{
    ShearSums shear;
    extremes.max_speed =
        std::max(extremes.max_speed, std::sqrt(largest_speed_squared(particles, begin, end)));
    for (std::size_t first = begin, last = begin; first < end; first = last) {
        last = end_of_cell(problem.grid, particles, first, end);
        include_cell(problem, particles, first, last,
                     extremes.materials[static_cast<std::size_t>(particles.material[first])], shear);
    }
    return shear;
}

void include(const MaterialExtremes& other, MaterialExtremes& extremes)
{
    extremes.min_porosity = std::min(extremes.min_porosity, other.min_porosity);
    extremes.max_porosity = std::max(extremes.max_porosity, other.max_porosity);
    extremes.stiffest_modulus = std::max(extremes.stiffest_modulus, other.stiffest_modulus);
    extremes.stiffest_cut_modulus = std::max(extremes.stiffest_cut_modulus, other.stiffest_cut_modulus);
}

} // namespace

double mixture_density(const Problem& problem, const Material& material, double porosity)
{
    const std::optional<Water>& water = water_of(problem, material);
    return (1.0 - porosity) * material.grain_density + (water ? porosity * water->density : 0.0);
}

CellExtremes find_extremes(const Problem& problem, const Particles& particles)
{
    const CellExtremes none{0.0, 0.0, 0.0, std::vector<MaterialExtremes>(problem.materials.size())};
    const std::size_t chunks = (particles.size() + chunk - 1) / chunk;
    std::vector<CellExtremes> parts(chunks, none);
    std::vector<ShearSums> shears(chunks);
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        shears[first / chunk] = include_chunk(problem, particles, first, last, parts[first / chunk]);
    });
    CellExtremes extremes = none;
    for (const CellExtremes& part : parts) {
        extremes.max_speed = std::max(extremes.max_speed, part.max_speed);
        for (std::size_t m = 0; m < extremes.materials.size(); ++m)
            include(part.materials[m], extremes.materials[m]);
    }
    ShearSums shear;
    for (const ShearSums& part : shears) shear += part;
    const ShearSum& counted = shear.soil.volume > 0.0 ? shear.soil : shear.solids;
    if (counted.volume > 0.0) {
        extremes.shear_speed = counted.speed();
        extremes.shear_slowness = counted.slowness / counted.volume;
    }
    return extremes;
}

} // namespace quicksand
