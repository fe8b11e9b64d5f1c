// PM4Sand for many particles: blocks of lanes that take a substep together, so that the compiler makes
// vectors of the arithmetic. A lane whose strain is done goes on with the next particle.
#if defined(__GNUC__) && !defined(__clang__)
// as in ubcsand_arrays.cpp: choices stay without branches; changes no value
#pragma GCC optimize("no-trapping-math", "no-thread-jumps", "no-tree-loop-distribute-patterns")
#endif

#include "solver/pm4sand/pm4sand_arrays.hpp"

#include "solver/base/lanes.hpp"
#include "solver/pm4sand/pm4sand_blocks.hpp"

namespace quicksand {

namespace {

using namespace pm4sand;

/// Stress (tension positive) and memory of particles, by column.
struct Columns {
    double *xx, *yy, *zz, *xy;
    double* memory[numbers_of_cycles];

    // the bounds of the starts belong to axes that stay: their middle turns with the body, their distance
    // does not
    Pm4SandState state(std::size_t p) const
    {
        const double x = memory[8][p], y = memory[9][p], beyond_x = memory[10][p], beyond_y = memory[11][p];
        return {-xx[p],        -yy[p],        -zz[p],        -xy[p],        memory[0][p],  memory[1][p],
                memory[2][p],  memory[3][p],  memory[4][p],  memory[5][p],  memory[6][p],  memory[7][p],
                x - beyond_x,  y - beyond_y,  x + beyond_x,  y + beyond_y,  memory[12][p], memory[13][p],
                memory[14][p], memory[15][p], memory[16][p], memory[17][p], memory[18][p], memory[19][p],
                memory[20][p], memory[21][p], memory[22][p], memory[23][p]};
    }

    void set(std::size_t p, const Pm4SandState& state) const
    {
        xx[p] = -state.sigma_x, yy[p] = -state.sigma_y, zz[p] = -state.sigma_z, xy[p] = -state.tau_xy;
        memory[0][p] = state.alpha_x;
        memory[1][p] = state.alpha_y;
        memory[2][p] = state.start_x;
        memory[3][p] = state.start_y;
        memory[4][p] = state.turn_x;
        memory[5][p] = state.turn_y;
        memory[6][p] = state.previous_x;
        memory[7][p] = state.previous_y;
        memory[8][p] = 0.5 * (state.least_x + state.most_x);
        memory[9][p] = 0.5 * (state.least_y + state.most_y);
        memory[10][p] = 0.5 * (state.most_x - state.least_x);
        memory[11][p] = 0.5 * (state.most_y - state.least_y);
        memory[12][p] = state.fabric_x;
        memory[13][p] = state.fabric_y;
        memory[14][p] = state.origin_x;
        memory[15][p] = state.origin_y;
        memory[16][p] = state.fabric_path;
        memory[17][p] = state.fabric_peak;
        memory[18][p] = state.peak_stress;
        memory[19][p] = state.peak_product;
        memory[20][p] = state.void_ratio;
        memory[21][p] = state.fabric_limit;
        memory[22][p] = state.dilatancy_factor;
        memory[23][p] = state.least_stress;
    }
};

Columns columns_of(Particles& particles)
{
    SymmetricTensors& stress = particles.stress;
    Columns columns = {stress.xx.data(), stress.yy.data(), stress.zz.data(), stress.xy.data(), {}};
    for (std::size_t k = 0; k < numbers_of_cycles; ++k) columns.memory[k] = particles.memory[k].data();
    return columns;
}

/// The strains of particles, compression positive.
struct Strains {
    const double *xx, *xy, *yx, *yy; // velocity gradient, xx and yy from particle `first` on [1/s]
    std::size_t first;
    double dt; // [s]

    Strain of(std::size_t p) const
    {
        const std::size_t k = p - first;
        return {-dt * (xx[k] - yy[k]), -dt * (xy[p] + yx[p]), -dt * (xx[k] + yy[k])};
    }
};

inline void load(const Columns& columns, const Strains& strains, std::size_t p, std::size_t k, Block& block)
{
    const Strain strain = strains.of(p);
    block.states.set(k, columns.state(p));
    block.strain_x[k] = strain.x, block.strain_y[k] = strain.y,
    block.strain_volumetric[k] = strain.volumetric;
    block.set_progress(k, Progress());
}

inline void reach_surfaces(const Pm4Sand& law, Block& block)
{
    for (std::size_t k = 0; k < width; ++k) {
        const Pm4SandState state = block.states.state(k);
        const double fraction = next_fraction(law, block.progress(k), state);
        const Contact contact = reach_surface(law, state, part_of(block.strain(k), fraction));
        block.fraction[k] = fraction;
        block.contacts.set(k, contact.at);
        block.elastic[k] = contact.elastic;
        block.elastic_error[k] = contact.error;
    }
}

inline void remember_reversals(Block& block)
{
    for (std::size_t k = 0; k < width; ++k) {
        Pm4SandState memory = block.states.state(k);
        const Point contact = block.contacts.point(k);
        remember_reversal(contact, direction_of(contact), memory);
        block.memories.set(k, memory);
    }
}

inline void flow_at_contacts(const Pm4Sand& law, Block& block)
{
    for (std::size_t k = 0; k < width; ++k) {
        const Strain rest = part_of(part_of(block.strain(k), block.fraction[k]), 1.0 - block.elastic[k]);
        // a point that is copied whole would keep the compiler from making vectors
        block.firsts.set(k, plastic_change(law, block.memories.state(k), block.contacts.point(k),
                                           block.contacts.point(k), rest));
    }
}

inline void finish_all(const Pm4Sand& law, Block& block)
{
    for (std::size_t k = 0; k < width; ++k) {
        const Strain strain = block.strain(k);
        const Contact contact = block.contact(k);
        const Pm4SandState before = block.states.state(k), memory = block.memories.state(k);
        const double fraction = block.fraction[k];
        Progress progress = block.progress(k);
        const End end = finish(law, memory, contact, block.firsts.point(k), part_of(strain, fraction));
        const Pm4SandState next = state_at(end, contact.elastic < 1.0, memory, before);
        block.states.set(k, accept(law, strain.volumetric, fraction, end.error, next, progress, before));
        block.set_progress(k, progress);
    }
}

/// Try a substep in every lane; one whose strain is done stays as it is.
inline void try_substep(const Pm4Sand& law, Block& block)
{
    reach_surfaces(law, block);
    remember_reversals(block);
    flow_at_contacts(law, block);
    finish_all(law, block);
}

WIDE_VECTOR_KERNEL
void advance_points(const Pm4Sand& law, const Strains& strains, std::size_t first, std::size_t last,
                    const Columns& columns)
{
    Block block;
    std::size_t particle[width];
    const std::size_t lanes = last - first < width ? last - first : width;
    for (std::size_t k = 0; k < width; ++k) {
        particle[k] = first + (k < lanes ? k : 0);
        load(columns, strains, particle[k], k, block);
    }
    std::size_t next = first + lanes;
    for (std::size_t left = last - first; left > 0;) {
        try_substep(law, block);
        for (std::size_t k = 0; k < lanes; ++k) {
            if (block.done[k] < 1.0 || particle[k] == last) continue;
            columns.set(particle[k], block.states.state(k));
            --left;
            particle[k] = next;
            if (next < last) load(columns, strains, next++, k, block);
        }
    }
}

} // namespace

Pm4SandState state_of(std::size_t p, const Particles& particles)
{
    return columns_of(const_cast<Particles&>(particles)).state(p); // only read
}

void set_state(std::size_t p, const Pm4SandState& state, Particles& particles)
{
    columns_of(particles).set(p, state);
}

void update(const Pm4Sand& law, double dt, std::size_t first, std::size_t last, const double* L_xx,
            const double* L_yy, Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    const Columns columns = columns_of(particles);
    const Strains strains = {L_xx, L.xy.data(), L.yx.data(), L_yy, first, dt};
    if (last > first + 1) return advance_points(law, strains, first, last, columns);
    Pm4SandState state = columns.state(first); // lanes would be empty
    advance_in_substeps(law, strains.of(first), state);
    columns.set(first, state);
}

} // namespace quicksand
