#include "solver/verification/solutions/column_response.hpp"

#include <cmath>

namespace quicksand {

namespace {

/// sinh(kappa x) / [kappa cosh(kappa H)] and its derivative in x, safe for any kappa with Re kappa >= 0.
struct Profile {
    Complex value, slope;
};

Profile profile(Complex kappa, double x, double height)
{
    if (std::abs(kappa) * height < 1e-6) return {x, 1.0}; // the wave without inertia: uniform strain
    if (kappa.real() * height < 20.0) {
        const Complex top = std::cosh(kappa * height);
        return {std::sinh(kappa * x) / (kappa * top), std::cosh(kappa * x) / top};
    }
    const Complex up = std::exp(kappa * (x - height)), down = std::exp(-kappa * (x + height));
    return {(up - down) / kappa, up + down};
}

} // namespace

ColumnResponse::ColumnResponse(const SaturatedSoil& soil, double height, Complex s)
    : height_(height), storage_modulus_(soil.storage_modulus())
{
    const auto waves = longitudinal_waves(soil, s);
    const double n = soil.porosity;
    std::array<Complex, 2> outflow;
    for (std::size_t j = 0; j < 2; ++j) {
        kappa_[j] = std::sqrt(waves[j].kappa_squared);
        outflow[j] = (1.0 - n) * waves[j].mode[0] + n * waves[j].mode[1];
    }
    // M (a_1 phi_1s + a_2 phi_2s) = -1 and a_1 d_1 + a_2 d_2 = 0, d the outflow
    const Complex solid_strain = outflow[1] * waves[0].mode[0] - outflow[0] * waves[1].mode[0];
    const Complex common = -1.0 / (soil.constrained_modulus * solid_strain);
    const std::array<Complex, 2> fraction = {outflow[1] * common, -outflow[0] * common};
    for (std::size_t j = 0; j < 2; ++j) {
        mode_[j] = fraction[j] * waves[j].mode;
        outflow_[j] = fraction[j] * outflow[j];
    }
}

ColumnAmplitude ColumnResponse::amplitude(double x) const
{
    ColumnAmplitude sum;
    for (std::size_t j = 0; j < 2; ++j) {
        const Profile shape = profile(kappa_[j], x, height_);
        sum.displacement_solid += mode_[j][0] * shape.value;
        sum.displacement_fluid += mode_[j][1] * shape.value;
        sum.pore_pressure -= storage_modulus_ * outflow_[j] * shape.slope;
    }
    return sum;
}

} // namespace quicksand
