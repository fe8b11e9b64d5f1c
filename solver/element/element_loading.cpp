#include "solver/element/element_loading.hpp"

namespace quicksand {

namespace {

struct Performer {
    const SkeletonLaw& law;
    const Consolidation& start;

    CyclicTest operator()(const StressCycles& loading) const { return shear_cyclically(law, start, loading); }
    CyclicTest operator()(const StrainCycles& loading) const { return shear_cyclically(law, start, loading); }
    CyclicTest operator()(const MonotonicShear& loading) const
    {
        return {shear_monotonically(law, start, loading.drainage, loading.largest_gamma), {}, {}, {}};
    }
    CyclicTest operator()(const BiaxialCompression& loading) const
    {
        return {compress_biaxially(law, start, loading.drainage, loading.largest_strain), {}, {}, {}};
    }
    CyclicTest operator()(const OedometerLoading& loading) const
    {
        return {compress_in_oedometer(law, start, loading.vertical_stresses), {}, {}, {}};
    }
    CyclicTest operator()(const IsotropicLoading& loading) const
    {
        return {compress_isotropically(law, start, loading.mean_stresses), {}, {}, {}};
    }
};

} // namespace

CyclicTest perform(const SkeletonLaw& law, const Consolidation& start, const ElementLoading& loading)
{
    return std::visit(Performer{law, start}, loading);
}

} // namespace quicksand
