// Damping of an elastic skeleton that hardly depends on the frequency: Maxwell elements beside its spring
// (Emmerich and Korn 1987).
//
//   s' = r C e' + sum_k q_k'      q_k' = w_k C e' - q_k / t_k
//
// C is the elastic stiffness, e the strain, q_k the stress of element k, t_k its time. The weights w_k are
// such that the damping ratio is the one asked for at three frequencies 1/(2 pi t_k), spread over a band of
// 1 : 40; between them it lies within 5 % of it, within 15 % of one of 0.2. r is such that at the middle of
// the band the skeleton is as stiff as C says. At high frequencies it is stiffer, (r + sum w_k) C, for long
// loads it is softer, r C. The same elements resist changes of volume and of shape.
#pragma once

#include "solver/particles/particles.hpp"
#include "solver/soil/law_interface.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace quicksand {

inline constexpr std::size_t maxwell_elements = 3;

/// Middle of a band from 0.5 to 20 Hz, which has the energy of earthquakes [Hz].
inline constexpr double usual_damping_frequency = 3.0;

struct MaxwellElements {
    std::array<double, maxwell_elements> weight{}; // w_k [-]
    std::array<double, maxwell_elements> rate{};   // 1 / t_k [1/s]
    double relaxed = 1.0;                          // r [-]

    /// r + sum w_k: stiffness without time to relax, over C [-].
    double unrelaxed() const;
};

/// Of a damping ratio and the frequency at the middle of the band [Hz].
MaxwellElements make_maxwell_elements(double damping_ratio, double frequency);

/// What the elements do in a step of dt in which strain grows evenly: q_k becomes kept_k q_k + share_k C de.
struct MaxwellStep {
    std::array<double, maxwell_elements> kept{};  // exp(-dt / t_k) [-]
    std::array<double, maxwell_elements> share{}; // w_k (1 - kept_k) t_k / dt [-]
    double relaxed = 1.0;                         // r [-]

    /// Change of the stress over C de, from elements without stress [-].
    double stiffness() const;
};
MaxwellStep maxwell_step(const MaxwellElements& elements, double dt);

/// What is remembered of each element: a StressParts.
LawMemory memory_of_maxwell_elements();
/// Of a damping ratio, the band around a frequency [Hz].
VibrationDamping vibration_damping(double damping_ratio, double frequency);

/// A law with elements; a damping ratio of 0 is none of them.
template <class Law>
concept LawWithMaxwellElements = requires(const Law& law)
{
    law.damping_ratio;     // [-]
    law.damping_frequency; // [Hz]
};

template <LawWithMaxwellElements Law>
LawMemory memory_of(const Law& law)
{
    return law.damping_ratio > 0.0 ? memory_of_maxwell_elements() : LawMemory{};
}

template <LawWithMaxwellElements Law>
std::optional<VibrationDamping> vibration_damping_of(const Law& law)
{
    if (law.damping_ratio == 0.0) return std::nullopt;
    return vibration_damping(law.damping_ratio, law.damping_frequency);
}

template <LawWithMaxwellElements Law>
Law undamped(const Law& law)
{
    Law still = law;
    still.damping_ratio = 0.0;
    return still;
}

template <LawWithMaxwellElements Law>
Law settling_form(const Law& law, double)
{
    return undamped(law);
}

/// Stiffness without time to relax over the elastic one [-].
template <LawWithMaxwellElements Law>
double unrelaxed_stiffness(const Law& law)
{
    return law.damping_ratio > 0.0
               ? make_maxwell_elements(law.damping_ratio, law.damping_frequency).unrelaxed()
               : 1.0;
}

/// None without damping.
template <LawWithMaxwellElements Law>
std::optional<MaxwellStep> maxwell_step_of(const Law& law, double dt)
{
    if (law.damping_ratio == 0.0) return std::nullopt;
    return maxwell_step(make_maxwell_elements(law.damping_ratio, law.damping_frequency), dt);
}

/// A stress without its place: mean in the plane, ((s_xx - s_yy)/2, s_xy), and out of the plane [Pa].
struct StressParts {
    double mean = 0.0, half_difference = 0.0, shear = 0.0, out_of_plane = 0.0;

    friend StressParts operator-(const StressParts& a, const StressParts& b)
    {
        return {a.mean - b.mean, a.half_difference - b.half_difference, a.shear - b.shear,
                a.out_of_plane - b.out_of_plane};
    }
};

/// Add the stress of the strain L dt to the particles [first, last), with Lame's moduli lambda and G [Pa],
/// and what elements lose of theirs.
void add_damped(const MaxwellStep& step, double lambda, double G, double dt, std::size_t first,
                std::size_t last, Particles& particles);

/// Plastic strain takes the stress `change` off the particle; the elements lose their shares of it.
void share_plastic_change(const MaxwellStep& step, const StressParts& change, std::size_t p,
                          SoilMemory& memory);

} // namespace quicksand
