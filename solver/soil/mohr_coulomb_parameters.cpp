#include "solver/soil/mohr_coulomb_parameters.hpp"

#include "solver/soil/linear_elastic.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

double surface_tip(const MohrCoulomb& law)
{
    const double tangent = std::tan(law.friction_angle);
    return tangent > 0.0 ? law.cohesion / tangent : std::numeric_limits<double>::infinity();
}

MohrCoulomb reduced(const MohrCoulomb& law, double factor)
{
    MohrCoulomb weaker = law;
    weaker.cohesion = law.cohesion / factor;
    weaker.tension_strength = law.tension_strength / factor;
    weaker.friction_angle = std::atan(std::tan(law.friction_angle) / factor);
    weaker.dilation_angle = std::min(law.dilation_angle, weaker.friction_angle);
    return weaker;
}

double lame_modulus(const MohrCoulomb& law)
{
    return lame_modulus(LinearElastic{law.shear_modulus, law.poisson_ratio});
}

double constrained_modulus(const MohrCoulomb& law)
{
    return constrained_modulus(LinearElastic{law.shear_modulus, law.poisson_ratio});
}

double shear_modulus(const MohrCoulomb& law)
{
    return law.shear_modulus;
}

} // namespace quicksand
