#include "solver/element/sand_survey.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr double cycles_of_strength = 15.0;
constexpr Consolidation usual{}; // 100 kPa, K0 = 1/2

std::optional<double> ratio(std::optional<double> other, std::optional<double> reference)
{
    if (!other || !reference) return std::nullopt;
    return *other / *reference;
}

/// sigma'_z over N_phi times the least stress in the plane; 0 for a law without such a limit [-].
double out_of_plane_over_limit(const SkeletonLaw& law, const ElementPoint& point)
{
    const auto line = failure_line_of(law);
    if (!line || line->slope >= 1.0) return 0.0;
    const double N = (1.0 + line->slope) / (1.0 - line->slope), a = line->at_zero / line->slope;
    const double s = 0.5 * (point.sigma_x + point.sigma_y);
    const double t = std::hypot(0.5 * (point.sigma_x - point.sigma_y), point.tau);
    return (point.sigma_z + a) / (N * (s + a - t));
}

/// Cycles at the strength, and five more after ru = 0.95.
void follow_liquefaction(const SkeletonLaw& law, double csr, SandSurvey& survey)
{
    constexpr double barely_more = 1.001, cycles_after = 6.0, without_end = 1e9;
    const StressCycles loading = {barely_more * csr, 2.0 * cycles_of_strength + cycles_after, without_end,
                                  cycles_after};
    const CyclicTest test = shear_cyclically(law, usual, loading);
    if (!test.cycles_to_ru_95) return;
    const double begin = *test.cycles_to_ru_95 - 0.25; // the leg of the event begins there
    survey.strain_of_cycles.assign(6, 0.0);
    for (const ElementPoint& point : test.path) {
        if (point.cycle < begin) continue;
        const auto cycle = static_cast<std::size_t>(point.cycle - begin);
        if (cycle >= survey.strain_of_cycles.size()) break;
        double& largest = survey.strain_of_cycles[cycle];
        largest = std::max(largest, std::abs(point.gamma));
        survey.most_out_of_plane = std::max(survey.most_out_of_plane, out_of_plane_over_limit(law, point));
    }
}

ShearCurvePoint measure_shear(const SkeletonLaw& law, double gamma)
{
    StrainCycles loading;
    loading.gamma = gamma;
    loading.cycles = 3.0;
    loading.drainage = Drainage::drained;
    const double largest = shear_modulus(consolidate(law, usual));
    const CycleSummary second = summarize_cycles(shear_cyclically(law, usual, loading).path).at(1);
    return {second.secant_modulus / largest, second.damping_ratio};
}

/// With the post-shaking option, where the law has nothing else.
SkeletonLaw settling_after_shaking(SkeletonLaw law)
{
    auto* sand = std::get_if<Pm4Sand>(&law);
    if (sand != nullptr && reconsolidation_slope(*sand) == 0.0) sand->reconsolidation = 1.0;
    return law;
}

} // namespace

SandSurvey survey(const SkeletonLaw& law)
{
    SandSurvey survey{};
    survey.strength = cyclic_strength(law, usual);
    if (survey.strength) {
        const double csr = survey.strength->csr_15;
        survey.k_sigma = ratio(csr_to_ru_95(law, {800e3, 0.5, 0.0}, cycles_of_strength), csr);
        survey.k_0 = ratio(csr_to_ru_95(law, {100e3, 1.0, 0.0}, cycles_of_strength), csr);
        survey.k_alpha = ratio(csr_to_liquefaction(law, {100e3, 0.5, 10e3}, cycles_of_strength), csr);
        follow_liquefaction(law, csr, survey);
    }
    const CyclicTest drained = reconsolidate(law, settling_after_shaking(law), usual, {0.08, 10.0});
    survey.reconsolidation = drained.path.back().volumetric_strain();
    survey.k_0_after = drained.path.back().sigma_x / drained.path.back().sigma_y;
    for (std::size_t k = 0; k < survey_strains.size(); ++k)
        survey.curve[k] = measure_shear(law, survey_strains[k]);
    return survey;
}

} // namespace quicksand
