#include "solver/element/element_laboratory.hpp"

#include "solver/base/failure.hpp"
#include "solver/element/held_stress.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

/// Points of monotonic tests are 1 % of the strain apart, at least 1e-6. Between them the strain is divided
/// finely: a law may be integrated to first order, and first loading is then right to 1e-4.
template <class Apply>
void strain_monotonically(double largest, double strain, Apply&& apply)
{
    const double interval = std::min(std::max(0.01 * strain, 1e-6), largest - strain);
    const double count = std::ceil(interval / std::max(1e-4 * strain, 1e-7));
    for (double k = 0.0; k < count; k += 1.0) apply(interval / count);
}

double sigma_x(const Specimen& specimen)
{
    return specimen.sigma_x();
}

double sigma_y(const Specimen& specimen)
{
    return specimen.sigma_y();
}

double mean_stress(const Specimen& specimen)
{
    return 0.5 * (specimen.sigma_x() + specimen.sigma_y());
}

/// Strain by `apply(step, specimen)` in steps of 1 % of the stress from target to target.
template <class Apply, class Stress>
ElementPath load_through(const SkeletonLaw& law, const Consolidation& start,
                         const std::vector<double>& targets, Apply&& apply, Stress&& stress)
{
    Specimen specimen = consolidate(law, start);
    ElementPath path = {record(specimen, 0.0)};
    for (const double target : targets) {
        if (!(target > 0.0)) throw InputError("element test: a stress to compress to must be positive");
        require_above_floor(law, target);
        for (double next = 0.0; next != target;) {
            const double now = stress(specimen);
            next = now < target ? std::min(target, 1.01 * now) : std::max(target, now / 1.01);
            hold(next, constrained_modulus(specimen), apply, stress, specimen);
            path.push_back(record(specimen, 0.0));
            path.back().ru = 0.0;
        }
    }
    return path;
}

} // namespace

double ElementPoint::deviator_stress() const
{
    const double p = mean_stress(), x = sigma_x - p, y = sigma_y - p, z = sigma_z - p;
    return std::sqrt(1.5 * (x * x + y * y + z * z + 2.0 * tau * tau));
}

ElementPoint record(const Specimen& specimen, double cycle)
{
    return {cycle,
            specimen.gamma,
            specimen.strain_x,
            specimen.strain_y,
            specimen.tau(),
            specimen.sigma_x(),
            specimen.sigma_y(),
            specimen.sigma_z(),
            1.0 - specimen.sigma_y() / specimen.initial_vertical_stress};
}

ElementPath shear_monotonically(const SkeletonLaw& law, const Consolidation& start, Drainage drainage,
                                double largest_gamma)
{
    Specimen specimen = consolidate(law, start);
    ElementPath path = {record(specimen, 0.0)};
    while (specimen.gamma < largest_gamma - 1e-12) {
        strain_monotonically(largest_gamma, specimen.gamma, [&](double step) {
            if (drainage == Drainage::undrained) return strain(0.0, 0.0, step, specimen);
            const auto apply = [&](double vertical, Specimen& s) { strain(0.0, vertical, step, s); };
            hold(start.vertical_stress, constrained_modulus(specimen), apply, sigma_y, specimen);
        });
        path.push_back(record(specimen, 0.0));
    }
    return path;
}

ElementPath compress_biaxially(const SkeletonLaw& law, const Consolidation& start, Drainage drainage,
                               double largest_strain)
{
    Specimen specimen = consolidate(law, start);
    ElementPath path = {record(specimen, 0.0)};
    const double cell_pressure = specimen.sigma_x();
    while (specimen.strain_y < largest_strain - 1e-12) {
        strain_monotonically(largest_strain, specimen.strain_y, [&](double step) {
            if (drainage == Drainage::undrained) return strain(-step, step, 0.0, specimen);
            const auto apply = [&](double lateral, Specimen& s) { strain(lateral, step, 0.0, s); };
            hold(cell_pressure, constrained_modulus(specimen), apply, sigma_x, specimen);
        });
        path.push_back(record(specimen, 0.0));
        path.back().ru = (cell_pressure - specimen.sigma_x()) / start.vertical_stress;
    }
    return path;
}

ElementPath compress_in_oedometer(const SkeletonLaw& law, const Consolidation& start,
                                  const std::vector<double>& vertical_stresses)
{
    return load_through(
        law, start, vertical_stresses, [](double step, Specimen& s) { strain(0.0, step, 0.0, s); }, sigma_y);
}

ElementPath compress_isotropically(const SkeletonLaw& law, const Consolidation& start,
                                   const std::vector<double>& mean_stresses)
{
    return load_through(
        law, start, mean_stresses, [](double step, Specimen& s) { strain(step, step, 0.0, s); }, mean_stress);
}

} // namespace quicksand
