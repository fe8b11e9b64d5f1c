#include "solver/motion/wrapping.hpp"

#include <cmath>
#include <cstddef>

namespace quicksand {

void wrap_particles(const Problem& problem, Particles& particles)
{
    if (!problem.tied_sides || !problem.tied_sides->wraps || problem.strain == StrainForm::small) return;
    const double left = problem.tied_sides->x_left, width = problem.tied_sides->x_right - left;
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double turns = std::floor((particles.position.x[p] - left) / width);
        if (turns == 0.0) continue;
        particles.position.x[p] -= turns * width;
        particles.reference_position.x[p] -= turns * width;
    }
}

} // namespace quicksand
