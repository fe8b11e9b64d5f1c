#include "solver/motion/wrapping.hpp"

#include <cmath>
#include <cstddef>

namespace quicksand {

void wrap_particles(const Problem& problem, Particles& particles)
{
    if (!problem.tied_sides || problem.tied_sides->period == 0.0 || problem.strain == StrainForm::small)
        return;
    const TiedSides& sides = *problem.tied_sides;
    const double period = sides.period, left = 0.5 * (sides.x_left + sides.x_right - period);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        const double turns = std::floor((particles.position.x[p] - left) / period);
        if (turns == 0.0) continue;
        particles.position.x[p] -= turns * period;
        particles.reference_position.x[p] -= turns * period;
    }
}

} // namespace quicksand
