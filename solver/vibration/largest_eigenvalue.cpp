#include "solver/vibration/largest_eigenvalue.hpp"

#include "solver/base/mixed_bits.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace quicksand {

namespace {

using Column = Eigen::Map<const Eigen::VectorXd>;

Column as_column(const Scalars& values)
{
    return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// 1 or -1.
double random_sign(std::uint64_t index)
{
    return (mixed_bits(index * golden_increment) & 1U) != 0 ? 1.0 : -1.0;
}

/// The basis of Lanczos' method: v_j with v_i . S^-1 v_j = delta_ij, z_j = S^-1 v_j, and the coefficients.
struct Basis {
    std::vector<Eigen::VectorXd> v;
    Eigen::VectorXd z, z_before;
    std::vector<double> diagonal, beside; // of the tridiagonal matrix [1/s2]

    /// Scale the next pair to norm 1 and take it in; returns the norm, 0 where nothing is left.
    double append(Eigen::VectorXd velocity, Eigen::VectorXd force)
    {
        const double square = velocity.dot(force);
        if (!(square > 0.0)) return 0.0;
        const double norm = std::sqrt(square);
        v.push_back(std::move(velocity) / norm);
        z_before = std::move(z);
        z = std::move(force) / norm;
        return norm;
    }
};

/// Take S K v_j into the basis; returns whether anything new is left of it.
bool extend(NodalEquations& equations, Scalars& velocity, Scalars& force, Basis& basis)
{
    const std::size_t j = basis.v.size() - 1;
    Eigen::VectorXd::Map(velocity.data(), basis.v[j].size()) = basis.v[j];
    equations.deform(velocity, force);
    const Eigen::VectorXd f = as_column(force);
    const double alpha = basis.v[j].dot(f);
    basis.diagonal.push_back(alpha);
    equations.respond(force, velocity);
    Eigen::VectorXd w = as_column(velocity) - alpha * basis.v[j];
    Eigen::VectorXd z = f - alpha * basis.z;
    if (j > 0) {
        w -= basis.beside.back() * basis.v[j - 1];
        z -= basis.beside.back() * basis.z_before;
    }
    const double beta = basis.append(std::move(w), std::move(z));
    basis.beside.push_back(beta);
    return beta > 0.0;
}

} // namespace

LargestEigenvalue find_largest_eigenvalue(NodalEquations& equations, double tolerance, int max_iterations)
{
    Scalars force = equations.root_masses();
    for (std::size_t k = 0; k < force.size(); ++k) force[k] *= random_sign(k);
    Scalars velocity(force.size(), 0.0);
    equations.respond(force, velocity);

    LargestEigenvalue largest;
    Basis basis;
    if (basis.append(as_column(velocity), as_column(force)) == 0.0) return largest; // nothing can move
    std::vector<double> values;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    for (bool goes_on = true; goes_on && largest.iterations < max_iterations;) {
        goes_on = extend(equations, velocity, force, basis);
        const auto size = static_cast<Eigen::Index>(++largest.iterations);
        const auto beside = Eigen::VectorXd::Map(basis.beside.data(), size - 1);
        solver.computeFromTridiagonal(Eigen::VectorXd::Map(basis.diagonal.data(), size), beside);
        values.push_back(solver.eigenvalues()[size - 1]);
        if (values.size() > 3) goes_on &= values.back() > (1.0 + tolerance) * values[values.size() - 4];
    }
    largest.value = values.back();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(force.size()));
    const Eigen::VectorXd parts = solver.eigenvectors().rightCols<1>();
    for (Eigen::Index j = 0; j < parts.size(); ++j) sum += parts[j] * basis.v[static_cast<std::size_t>(j)];
    largest.eigenvector.assign(sum.data(), sum.data() + sum.size());
    return largest;
}

} // namespace quicksand
