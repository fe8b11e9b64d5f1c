#include "solver/verification/solutions/biot_dispersion.hpp"

#include "solver/verification/solutions/eigenmodes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quicksand {

// Symbols: r_1, r_2 partial densities of solid and fluid; C drag; K stiffness; J = [[1, -1], [-1, 1]]; R
// inertia. A wave e^{st} e^{kappa x} obeys [kappa^2 K - s^2 R - s C J] phi = 0, and kappa^2 = -xi^2.

namespace {

/// Both roots of a z^2 + b z + c, the smaller one first, without cancellation.
std::array<Complex, 2> quadratic_roots(Complex a, Complex b, Complex c)
{
    Complex root = std::sqrt(b * b - 4.0 * a * c);
    if (std::real(std::conj(b) * root) < 0.0) root = -root;
    const Complex sum = -0.5 * (b + root);
    std::array<Complex, 2> roots = {c / sum, sum / a};
    if (std::abs(roots[0]) > std::abs(roots[1])) std::swap(roots[0], roots[1]);
    return roots;
}

Complex polynomial(const Eigen::VectorXd& coefficients, Complex s)
{
    Complex sum = 0.0;
    for (Eigen::Index i = coefficients.size(); i-- > 0;) sum = sum * s + coefficients[i];
    return sum;
}

/// Roots of sum c_i s^i from the companion matrix, polished, since the drag spreads them over many decades.
Eigen::VectorXcd polynomial_roots(const Eigen::VectorXd& coefficients)
{
    const Eigen::Index degree = coefficients.size() - 1;
    // s = scale * t with the leading and the lowest coefficient equal
    const double scale =
        std::pow(std::abs(coefficients[0] / coefficients[degree]), 1.0 / static_cast<double>(degree));
    Eigen::VectorXd scaled(degree + 1), slope(degree);
    for (Eigen::Index i = 0; i <= degree; ++i) {
        scaled[i] = coefficients[i] / coefficients[0] * std::pow(scale, static_cast<double>(i));
        if (i > 0) slope[i - 1] = static_cast<double>(i) * scaled[i];
    }
    Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
    companion.bottomLeftCorner(degree - 1, degree - 1).setIdentity();
    companion.rightCols(1) = -scaled.head(degree) / scaled[degree];
    Eigen::VectorXcd roots = eigenvalues(companion.cast<Complex>());
    for (Complex& root : roots) {
        for (int i = 0; i < 8; ++i) {
            const Complex gradient = polynomial(slope, root);
            if (std::abs(gradient) > 0.0) root -= polynomial(scaled, root) / gradient;
        }
    }
    return scale * roots;
}

/// Take the root of largest |Im| and its conjugate out of a list of roots; the root is returned, Im >= 0.
Complex take_oscillation(std::vector<Complex>& roots)
{
    const auto faster = [](Complex a, Complex b) { return std::abs(a.imag()) > std::abs(b.imag()); };
    std::sort(roots.begin(), roots.end(), faster);
    const Complex root(roots[0].real(), std::abs(roots[0].imag()));
    roots.erase(roots.begin(), roots.begin() + 2);
    return root;
}

} // namespace

std::array<LongitudinalWave, 2> longitudinal_waves(const SaturatedSoil& soil, Complex s)
{
    const Eigen::Matrix2d K = soil.longitudinal_stiffness();
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid(), C = soil.drag();
    const double undrained = soil.undrained_modulus();
    const double det_K = soil.porosity * soil.constrained_modulus * soil.water_bulk_modulus;
    const double mixed = K(0, 0) * r2 + K(1, 1) * r1;
    // det (z K - s^2 R - s C J) / s, expanded by hand: the drag's own determinant is zero
    const Complex b = -(s * mixed + C * undrained);
    const Complex c = s * s * (s * (r1 * r2) + C * (r1 + r2));
    const auto roots = quadratic_roots(det_K / s, b, c);
    std::array<LongitudinalWave, 2> waves;
    for (std::size_t i = 0; i < 2; ++i) {
        const Complex z = roots[i];
        waves[i].kappa_squared = z;
        waves[i].mode = {z * K(0, 1) + s * C, s * s * r1 + s * C - z * K(0, 0)};
    }
    return waves;
}

Complex shear_wave_number_squared(const SaturatedSoil& soil, Complex s, Complex shear_modulus)
{
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid(), C = soil.drag();
    return -s * s * (r1 + r2 * C / (C + s * r2)) / shear_modulus;
}

UndraggedSpeeds undragged_speeds(const SaturatedSoil& soil)
{
    const Eigen::Matrix2d K = soil.longitudinal_stiffness();
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid();
    // c^2 are the eigenvalues of R^-1 K
    const double half_trace = 0.5 * (K(0, 0) / r1 + K(1, 1) / r2);
    const double determinant = K.determinant() / (r1 * r2);
    const double fast = half_trace + std::sqrt(half_trace * half_trace - determinant);
    return {std::sqrt(fast), std::sqrt(determinant / fast), std::sqrt(soil.shear_modulus / r1)};
}

LongitudinalModes longitudinal_modes(const SaturatedSoil& soil, double wave_number)
{
    const Eigen::Matrix2d K = soil.longitudinal_stiffness();
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid(), C = soil.drag();
    const double xi2 = wave_number * wave_number;
    // det (s^2 R + s C J + xi^2 K)
    Eigen::VectorXd coefficients(5);
    coefficients << xi2 * xi2 * K.determinant(), C * xi2 * soil.undrained_modulus(),
        xi2 * (K(0, 0) * r2 + K(1, 1) * r1), C * soil.density(), r1 * r2;
    const Eigen::VectorXcd found = polynomial_roots(coefficients);
    std::vector<Complex> roots(found.begin(), found.end());
    LongitudinalModes modes;
    modes.fast = take_oscillation(roots);
    const bool travelling = std::abs(roots[0].imag()) > 1e-9 * std::abs(roots[0]);
    const bool ordered = travelling ? roots[0].imag() > roots[1].imag() : roots[0].real() > roots[1].real();
    modes.slow = ordered ? roots[0] : roots[1];
    modes.relative = ordered ? roots[1] : roots[0];
    return modes;
}

ShearModes shear_modes(const SaturatedSoil& soil, double wave_number)
{
    const double r1 = soil.partial_density_solid(), r2 = soil.partial_density_fluid(), C = soil.drag();
    const double stiffness = soil.shear_modulus * wave_number * wave_number;
    // (s^2 r_1 + s C + G xi^2) (s^2 r_2 + s C) - s^2 C^2, without its root s = 0
    Eigen::VectorXd coefficients(4);
    coefficients << stiffness * C, stiffness * r2, C * soil.density(), r1 * r2;
    const Eigen::VectorXcd found = polynomial_roots(coefficients);
    std::vector<Complex> roots(found.begin(), found.end());
    ShearModes modes;
    modes.shear = take_oscillation(roots);
    modes.relative = roots[0];
    return modes;
}

Complex shear_fluid_ratio(const SaturatedSoil& soil, Complex s)
{
    return soil.drag() / (soil.drag() + s * soil.partial_density_fluid());
}

} // namespace quicksand
