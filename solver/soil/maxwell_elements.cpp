#include "solver/soil/maxwell_elements.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <numeric>

namespace quicksand {

namespace {

constexpr double band = 40.0;      // largest over smallest frequency [-]
constexpr std::size_t numbers = 4; // of a StressParts

/// q of an element.
struct ElementStress {
    ElementStress(std::size_t element, std::size_t p, SoilMemory& memory)
        : mean(memory[numbers * element][p]), half_difference(memory[numbers * element + 1][p]),
          shear(memory[numbers * element + 2][p]), out_of_plane(memory[numbers * element + 3][p])
    {
    }
    double &mean, &half_difference, &shear, &out_of_plane;
};

} // namespace

double MaxwellElements::unrelaxed() const
{
    return std::accumulate(weight.begin(), weight.end(), relaxed);
}

// At the frequency f, x_k = 2 pi f t_k, stiffness over C is
//   r + sum w_k (x_k^2 + i x_k) / (1 + x_k^2),   r = 1 - sum w_k x_0k^2 / (1 + x_0k^2), x_0 at the middle.
// Its imaginary part is twice the damping ratio times the real one: linear equations for w.
MaxwellElements make_maxwell_elements(double damping_ratio, double frequency)
{
    constexpr auto count = static_cast<int>(maxwell_elements);
    using Matrix = Eigen::Matrix<double, count, count>;
    using Vector = Eigen::Matrix<double, count, 1>;
    const auto ratio = [](int k) { return std::pow(band, static_cast<double>(k) / (count - 1) - 0.5); };
    const auto stored = [](double x) { return x * x / (1.0 + x * x); };
    Matrix equations;
    for (int f = 0; f < count; ++f)
        for (int k = 0; k < count; ++k) {
            const double x = ratio(f) / ratio(k), x_0 = 1.0 / ratio(k);
            equations(f, k) = x / (1.0 + x * x) - 2.0 * damping_ratio * (stored(x) - stored(x_0));
        }
    const Vector weights = equations.partialPivLu().solve(Vector::Constant(2.0 * damping_ratio));
    MaxwellElements elements;
    for (int k = 0; k < count; ++k) {
        const auto element = static_cast<std::size_t>(k);
        elements.weight[element] = weights[k];
        elements.rate[element] = 2.0 * std::numbers::pi * frequency * ratio(k);
        elements.relaxed -= weights[k] * stored(1.0 / ratio(k));
    }
    return elements;
}

double unrelaxed_stiffness(double damping_ratio, double frequency)
{
    return damping_ratio > 0.0 ? make_maxwell_elements(damping_ratio, frequency).unrelaxed() : 1.0;
}

MaxwellStep maxwell_step(const MaxwellElements& elements, double dt)
{
    MaxwellStep step;
    step.relaxed = elements.relaxed;
    for (std::size_t k = 0; k < maxwell_elements; ++k) {
        const double x = dt * elements.rate[k];
        step.kept[k] = std::exp(-x);
        step.share[k] = elements.weight[k] * -std::expm1(-x) / x;
    }
    return step;
}

double MaxwellStep::stiffness() const
{
    return std::accumulate(share.begin(), share.end(), relaxed);
}

std::optional<VibrationDamping> vibration_damping(double damping_ratio, double frequency)
{
    if (damping_ratio == 0.0) return std::nullopt;
    return VibrationDamping{damping_ratio, frequency / std::sqrt(band), frequency * std::sqrt(band)};
}

LawMemory memory_of_damping(double damping_ratio)
{
    if (damping_ratio == 0.0) return {};
    static constexpr auto memory = [] {
        constexpr std::array<MemoryNumber, numbers> of_element = {
            {{"damping_mean", "Pa", "Mean stress in the plane of a Maxwell element."},
             {"damping_half_difference", "Pa", "Half the difference of its normal stresses.", Component::x},
             {"damping_shear", "Pa", "Its shear stress.", Component::y},
             {"damping_out_of_plane", "Pa", "Its stress out of the plane."}}};
        std::array<MemoryNumber, numbers * maxwell_elements> all{};
        for (std::size_t k = 0; k < all.size(); ++k) all[k] = of_element[k % numbers];
        return all;
    }();
    return memory;
}

void add_damped(const MaxwellStep& step, const StressParts& change, std::size_t p, Particles& particles)
{
    StressParts sum{step.relaxed * change.mean, step.relaxed * change.half_difference,
                    step.relaxed * change.shear, step.relaxed * change.out_of_plane};
    const auto advance = [&](std::size_t k, double of_change, double& stress, double& total) {
        const double before = stress;
        stress = step.kept[k] * before + step.share[k] * of_change;
        total += stress - before;
    };
    for (std::size_t k = 0; k < maxwell_elements; ++k) {
        const ElementStress element(k, p, particles.memory);
        advance(k, change.mean, element.mean, sum.mean);
        advance(k, change.half_difference, element.half_difference, sum.half_difference);
        advance(k, change.shear, element.shear, sum.shear);
        advance(k, change.out_of_plane, element.out_of_plane, sum.out_of_plane);
    }
    SymmetricTensors& stress = particles.stress;
    stress.xx[p] += sum.mean + sum.half_difference;
    stress.yy[p] += sum.mean - sum.half_difference;
    stress.xy[p] += sum.shear;
    stress.zz[p] += sum.out_of_plane;
}

void share_plastic_change(const MaxwellStep& step, const StressParts& change, std::size_t p,
                          SoilMemory& memory)
{
    for (std::size_t k = 0; k < maxwell_elements; ++k) {
        const ElementStress element(k, p, memory);
        const double share = step.share[k] / step.stiffness();
        element.mean += share * change.mean;
        element.half_difference += share * change.half_difference;
        element.shear += share * change.shear;
        element.out_of_plane += share * change.out_of_plane;
    }
}

} // namespace quicksand
