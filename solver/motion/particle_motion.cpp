#include "solver/motion/particle_motion.hpp"

#include "solver/base/lanes.hpp"
#include "solver/base/threads.hpp"
#include "solver/problem/material_runs.hpp"
#include "solver/soil/rotation.hpp"

#include <cstdint>

namespace quicksand {

namespace {

/// edge += dt L other
void add_stretch(double dt, const Gradients& L, std::size_t p, const Vectors& other, Vectors& edge)
{
    const double x = other.x[p], y = other.y[p];
    edge.x[p] += dt * (L.xx[p] * x + L.xy[p] * y);
    edge.y[p] += dt * (L.yx[p] * x + L.yy[p] * y);
}

VECTOR_KERNEL
void advance_chunk(double dt, const Vectors& grid_velocity, std::size_t first, std::size_t last,
                   Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        particles.position.x[p] += dt * grid_velocity.x[p];
        particles.position.y[p] += dt * grid_velocity.y[p];
        add_stretch(dt, L, p, particles.half_edge_1, particles.half_edge_1);
        add_stretch(dt, L, p, particles.half_edge_2, particles.half_edge_2);
        particles.volume[p] *= (1.0 + dt * L.xx[p]) * (1.0 + dt * L.yy[p]) - dt * dt * L.xy[p] * L.yx[p];
    }
}

VECTOR_KERNEL
void take_middle_of_chunk(double dt, std::size_t first, std::size_t last, Gradients& L)
{
#pragma GCC ivdep
    for (std::size_t p = first; p < last; ++p) {
        // with the invariants of L: (L + dt/2 det L I) / det(I + dt/2 L)
        const double half = 0.5 * dt, det = L.xx[p] * L.yy[p] - L.xy[p] * L.yx[p];
        const double scale = 1.0 / (1.0 + half * (L.xx[p] + L.yy[p]) + half * half * det);
        L.xx[p] = scale * (L.xx[p] + half * det);
        L.yy[p] = scale * (L.yy[p] + half * det);
        L.xy[p] *= scale;
        L.yx[p] *= scale;
    }
}

/// The rotations of a chunk's particles in a step.
struct Rotations {
    double cosine[chunk], sine[chunk];
};

/// Turn the stress, and keep the rotations for what laws remember.
VECTOR_KERNEL
void turn_stress(double dt, std::size_t first, std::size_t last, Particles& particles, Rotations& turns)
{
    const Gradients& L = particles.velocity_gradient_solid;
    SymmetricTensors& stress = particles.stress;
#pragma GCC ivdep
    for (std::size_t p = first; p < last; ++p) {
        const Rotation turn = rotation_of(0.5 * dt * (L.yx[p] - L.xy[p]));
        turns.cosine[p - first] = turn.cosine;
        turns.sine[p - first] = turn.sine;
        const double mean = 0.5 * (stress.xx[p] + stress.yy[p]);
        double deviator = 0.5 * (stress.xx[p] - stress.yy[p]), shear = stress.xy[p];
        turn_vector(turn, deviator, shear);
        stress.xx[p] = mean + deviator;
        stress.yy[p] = mean - deviator;
        stress.xy[p] = shear;
    }
}

VECTOR_KERNEL
void turn_vectors(const double* cosine, const double* sine, std::size_t count, double* x, double* y)
{
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) turn_vector({cosine[k], sine[k]}, x[k], y[k]);
}

/// The vectors that laws remember turn with the stress; `turns` are those of the chunk from `chunk_first` on.
void turn_memory(const Rotations& turns, std::size_t chunk_first, LawMemory memory, std::size_t first,
                 std::size_t last, Particles& particles)
{
    const double *cosine = &turns.cosine[first - chunk_first], *sine = &turns.sine[first - chunk_first];
    for (std::size_t k = 0; k < memory.size(); ++k)
        if (memory[k].component == Component::x)
            turn_vectors(cosine, sine, last - first, &particles.memory[k][first],
                         &particles.memory[k + 1][first]);
}

} // namespace

void advance_domains(double dt, const Vectors& grid_velocity, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        advance_chunk(dt, grid_velocity, first, last, particles);
    });
}

void displace_domains(double dt, const Vectors& grid_velocity, Particles& particles)
{
    const Gradients& L = particles.velocity_gradient_solid;
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            particles.position.x[p] += dt * grid_velocity.x[p];
            particles.position.y[p] += dt * grid_velocity.y[p];
            add_stretch(dt, L, p, particles.reference_edge_1, particles.half_edge_1);
            add_stretch(dt, L, p, particles.reference_edge_2, particles.half_edge_2);
        }
    });
}

void take_gradients_of_the_middle(double dt, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        take_middle_of_chunk(dt, first, last, particles.velocity_gradient_solid);
    });
}

void update_porosity(const Problem& problem, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t p = first; p < last; ++p) {
            const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
            particles.porosity[p] =
                1.0 - particles.mass_solid[p] / (material.grain_density * particles.volume[p]);
        }
    });
}

void update_effective_stress(const Problem& problem, double dt, Particles& particles)
{
    for_each_chunk(particles.size(), [&](std::size_t first, std::size_t last) {
        Rotations turns;
        if (problem.strain == StrainForm::large) turn_stress(dt, first, last, particles, turns);
        for_each_material_run(
            problem, particles, first, last,
            [&](const Material& material, std::size_t run_first, std::size_t run_last) {
                if (problem.strain == StrainForm::large)
                    turn_memory(turns, first, memory_of(material.law), run_first, run_last, particles);
                std::visit([&](const auto& law) { update_stress(law, dt, run_first, run_last, particles); },
                           material.law);
            });
    });
}

} // namespace quicksand
