#include "solver/element/element_loading.hpp"

namespace quicksand {

namespace {

struct Performer {
    const SkeletonLaw& law;
    const Consolidation& start;

    CyclicTest operator()(const StressCycles& loading) const { return shear_cyclically(law, start, loading); }
    CyclicTest operator()(const StrainCycles& loading) const { return shear_cyclically(law, start, loading); }
    CyclicTest operator()(const Reconsolidation& loading) const
    {
        return reconsolidate(law, law, start, loading);
    }
    CyclicTest operator()(const MonotonicShear& loading) const
    {
        return {shear_monotonically(law, start, loading.drainage, loading.largest_gamma), {}, {}, {}, 0};
    }
    CyclicTest operator()(const BiaxialCompression& loading) const
    {
        return {compress_biaxially(law, start, loading.drainage, loading.largest_strain), {}, {}, {}, 0};
    }
    CyclicTest operator()(const OedometerLoading& loading) const
    {
        return {compress_in_oedometer(law, start, loading.vertical_stresses), {}, {}, {}, 0};
    }
    CyclicTest operator()(const IsotropicLoading& loading) const
    {
        return {compress_isotropically(law, start, loading.mean_stresses), {}, {}, {}, 0};
    }
};

} // namespace

CyclicTest perform(const SkeletonLaw& law, const Consolidation& start, const ElementLoading& loading)
{
    return std::visit(Performer{law, start}, loading);
}

} // namespace quicksand
