#include "solver/soil/mohr_coulomb_parameters.hpp"

#include "solver/soil/elastic_keys.hpp"
#include "solver/soil/linear_elastic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

std::span<const LawKey<MohrCoulomb>> keys_of(const MohrCoulomb&)
{
    constexpr double radians = std::numbers::pi / 180.0; // per degree
    constexpr Interval angles = {.lower = 0.0, .upper = 90.0, .upper_open = true};
    static constexpr std::array<LawKey<MohrCoulomb>, 8> keys = {{
        {shear_modulus_key, &MohrCoulomb::shear_modulus},
        {poisson_ratio_key, &MohrCoulomb::poisson_ratio},
        {{.name = "cohesion",
          .unit = "Pa",
          .meaning = "Effective cohesion c; with friction_angle = 0 the undrained strength.",
          .allowed = {.lower = 0.0},
          .usual = {0.0, 1e6},
          .standard = 0.0},
         &MohrCoulomb::cohesion},
        {{.name = "friction_angle",
          .unit = "deg",
          .meaning = "Effective angle of friction phi.",
          .allowed = angles,
          .usual = {0.0, 50.0}},
         &MohrCoulomb::friction_angle,
         radians},
        {{.name = "dilation_angle",
          .unit = "deg",
          .meaning = "Angle of dilation psi, at most the angle of friction; 0 flows at constant volume.",
          .allowed = angles,
          .usual = {0.0, 20.0},
          .standard = 0.0},
         &MohrCoulomb::dilation_angle,
         radians},
        {{.name = "tension_strength",
          .unit = "Pa",
          .meaning = "Largest tension the soil bears; 0 for soil that cracks.",
          .allowed = {.lower = 0.0},
          .usual = {0.0, 1e6},
          .absent = "the tip of the surface, cohesion / tan(friction_angle)"},
         &MohrCoulomb::tension_strength},
        {damping_ratio_key, &MohrCoulomb::damping_ratio},
        {damping_frequency_key, &MohrCoulomb::damping_frequency},
    }};
    return keys;
}

} // namespace quicksand
