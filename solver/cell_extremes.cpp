#include "solver/cell_extremes.hpp"

#include "solver/lanes.hpp"
#include "solver/threads.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace quicksand {

namespace {

/// The soil of one material in a cell, or a part of it.
struct CellSoil {
    double mass = 0.0;      // of the grains [kg/m]
    double volume = 0.0;    // [m3/m]
    double stiffness = 0.0; // sum of V M [N]
    double stiffest = 0.0;  // M of any particle [Pa]
};

/// Particles that follow each other in memory within a chunk and share a cell and a material.
struct CellPart {
    std::size_t cell;
    std::size_t material;
    CellSoil soil;
};

/// What a thread finds in its chunks.
struct Findings {
    double max_speed_squared = 0.0; // [m2/s2]
    std::vector<CellPart> parts;    // in the order of the particles
};

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

/// The end of the particles that share the cell and the material of the first.
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

/// Index of the cell of a place; of one outside of the grid, or nowhere, the first.
std::size_t cell_at(const BackgroundGrid& grid, double x, double y)
{
    const Vector2 rim = grid.rim_origin();
    const double i = (x - rim.x()) / grid.cell_size, j = (y - rim.y()) / grid.cell_size;
    if (!(i >= 0.0 && i < grid.all_cells_x() && j >= 0.0 && j < grid.all_cells_y())) return 0;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.all_cells_x()) +
           static_cast<std::size_t>(i);
}

void add(const CellSoil& part, CellSoil& soil)
{
    soil.mass += part.mass;
    soil.volume += part.volume;
    soil.stiffness += part.stiffness;
    soil.stiffest = std::max(soil.stiffest, part.stiffest);
}

CellPart part_of(const Problem& problem, const Particles& particles, std::size_t first, std::size_t last)
{
    const auto material = static_cast<std::size_t>(particles.material[first]);
    const ParticleModuli moduli =
        std::visit([&](const auto& law) { return particle_moduli(law, first, last, particles); },
                   problem.materials[material].law);
    CellSoil soil;
    for (std::size_t p = first; p < last; ++p) {
        soil.mass += particles.mass_solid[p];
        soil.volume += particles.volume[p];
    }
    soil.stiffness = soil.volume * moduli.mean;
    soil.stiffest = moduli.stiffest;
    return {cell_at(problem.grid, particles.position.x[first], particles.position.y[first]), material, soil};
}

void survey(const Problem& problem, const Particles& particles, std::size_t begin, std::size_t end,
            Findings& findings)
{
    findings.max_speed_squared =
        std::max(findings.max_speed_squared, largest_speed_squared(particles, begin, end));
    for (std::size_t first = begin, last = begin; first < end; first = last) {
        last = end_of_cell(problem.grid, particles, first, end);
        findings.parts.push_back(part_of(problem, particles, first, last));
    }
}

/// What the threads find, each in a row of chunks that follows that of the thread before.
std::vector<Findings> survey_all(const Problem& problem, const Particles& particles)
{
    const auto threads = static_cast<std::size_t>(threads_for(particles.size()));
    const std::size_t chunks = (particles.size() + chunk - 1) / chunk;
    std::vector<Findings> findings(threads);
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads)) if (threads > 1)
    for (std::size_t thread = 0; thread < threads; ++thread) {
        for (std::size_t k = chunks * thread / threads; k < chunks * (thread + 1) / threads; ++k) {
            survey(problem, particles, k * chunk, std::min(particles.size(), (k + 1) * chunk),
                   findings[thread]);
        }
    }
    return findings;
}

/// The soil of every material in every cell: index material x cells + cell.
std::vector<CellSoil> soil_of_cells(const Problem& problem, const std::vector<Findings>& findings)
{
    const std::size_t cells = problem.grid.cell_count();
    std::vector<CellSoil> soils(problem.materials.size() * cells);
    for (const Findings& found : findings)
        for (const CellPart& part : found.parts) add(part.soil, soils[part.material * cells + part.cell]);
    return soils;
}

/// How stiff the soil around a node is: the mean of the four cells that meet there, each moved towards its
/// stiffest particle by the share that is empty; the mean in turn towards the stiffest cell. [Pa]
double modulus_at_node(const CellSoil* lower_left, std::size_t columns, double cell_volume)
{
    double volume = 0.0, stiffness = 0.0, stiffest = 0.0, emptiest = 0.0;
    for (const CellSoil* soil :
         {lower_left, lower_left + 1, lower_left + columns, lower_left + columns + 1}) {
        if (soil->volume <= 0.0) continue;
        const double mean = soil->stiffness / soil->volume;
        const double empty = std::max(0.0, 1.0 - soil->volume / cell_volume);
        const double of_cell = mean + empty * (soil->stiffest - mean);
        volume += soil->volume;
        stiffness += soil->volume * of_cell;
        stiffest = std::max(stiffest, of_cell);
        emptiest = std::max(emptiest, empty);
    }
    if (volume <= 0.0) return 0.0;
    const double mean = stiffness / volume;
    return mean + emptiest * (stiffest - mean);
}

/// The largest modulus at any node inside of the rim [Pa].
double stiffest_node(const BackgroundGrid& grid, const CellSoil* soils)
{
    const auto columns = static_cast<std::size_t>(grid.all_cells_x()),
               rows = static_cast<std::size_t>(grid.all_cells_y());
    const double cell_volume = grid.cell_size * grid.cell_size;
    double stiffest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : stiffest) if (rows * columns > least_parallel_work)
    for (std::size_t j = 0; j < rows - 1; ++j) {
        for (std::size_t i = 0; i + 1 < columns; ++i)
            stiffest = std::max(stiffest, modulus_at_node(soils + j * columns + i, columns, cell_volume));
    }
    return stiffest;
}

void include_porosities(const Material& material, const CellSoil* soils, std::size_t cells,
                        MaterialExtremes& extremes)
{
    for (std::size_t cell = 0; cell < cells; ++cell) {
        const CellSoil& soil = soils[cell];
        if (soil.volume <= 0.0) continue;
        const double porosity = 1.0 - soil.mass / (material.grain_density * soil.volume);
        extremes.min_porosity = std::min(extremes.min_porosity, porosity);
        extremes.max_porosity = std::max(extremes.max_porosity, porosity);
    }
}

} // namespace

CellExtremes find_extremes(const Problem& problem, const Particles& particles)
{
    const std::vector<Findings> findings = survey_all(problem, particles);
    const std::vector<CellSoil> soils = soil_of_cells(problem, findings);
    const std::size_t cells = problem.grid.cell_count();
    CellExtremes extremes{0.0, std::vector<MaterialExtremes>(problem.materials.size())};
    for (const Findings& found : findings)
        extremes.max_speed = std::max(extremes.max_speed, std::sqrt(found.max_speed_squared));
    for (std::size_t m = 0; m < problem.materials.size(); ++m) {
        include_porosities(problem.materials[m], &soils[m * cells], cells, extremes.materials[m]);
        extremes.materials[m].stiffest_modulus = stiffest_node(problem.grid, &soils[m * cells]);
    }
    return extremes;
}

} // namespace quicksand
