#include "solver/soil/maxwell_elements.hpp"

#include "solver/base/lanes.hpp"

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

VibrationDamping vibration_damping(double damping_ratio, double frequency)
{
    return {damping_ratio, frequency / std::sqrt(band), frequency * std::sqrt(band),
            make_maxwell_elements(damping_ratio, frequency).relaxed};
}

LawMemory memory_of_maxwell_elements()
{
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

namespace {

/// What one element, of the stress q, adds to that of the particles [first, last) in a step:
/// (kept - 1) q + share C L dt, and what its spring alone adds with relaxed C L dt.
VECTOR_KERNEL
void add_element(double kept, double share, double relaxed, double lambda, double G, double dt,
                 std::size_t first, std::size_t last, double* mean, double* half_difference, double* shear,
                 double* out_of_plane, const Gradients& L, SymmetricTensors& stress)
{
    const double *L_xx = L.xx.data(), *L_xy = L.xy.data(), *L_yx = L.yx.data(), *L_yy = L.yy.data();
    double *xx = stress.xx.data(), *yy = stress.yy.data(), *zz = stress.zz.data(), *xy = stress.xy.data();
#pragma GCC ivdep // the arrays do not overlap
    for (std::size_t p = first; p < last; ++p) {
        const double growth = dt * (L_xx[p] + L_yy[p]);
        const double in_plane = (lambda + G) * growth, across = lambda * growth;
        const double half = G * dt * (L_xx[p] - L_yy[p]), slip = G * dt * (L_xy[p] + L_yx[p]);
        const double d_mean = (kept - 1.0) * mean[p] + share * in_plane;
        const double d_half = (kept - 1.0) * half_difference[p] + share * half;
        const double d_shear = (kept - 1.0) * shear[p] + share * slip;
        const double d_across = (kept - 1.0) * out_of_plane[p] + share * across;
        mean[p] += d_mean;
        half_difference[p] += d_half;
        shear[p] += d_shear;
        out_of_plane[p] += d_across;
        xx[p] += d_mean + d_half + relaxed * (in_plane + half);
        yy[p] += d_mean - d_half + relaxed * (in_plane - half);
        xy[p] += d_shear + relaxed * slip;
        zz[p] += d_across + relaxed * across;
    }
}

} // namespace

void add_damped(const MaxwellStep& step, double lambda, double G, double dt, std::size_t first,
                std::size_t last, Particles& particles)
{
    for (std::size_t k = 0; k < maxwell_elements; ++k) {
        Scalars* q = &particles.memory[numbers * k];
        add_element(step.kept[k], step.share[k], k == 0 ? step.relaxed : 0.0, lambda, G, dt, first, last,
                    q[0].data(), q[1].data(), q[2].data(), q[3].data(), particles.velocity_gradient_solid,
                    particles.stress);
    }
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
