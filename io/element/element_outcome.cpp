#include "io/element/element_outcome.hpp"

#include "io/keys/scene_units.hpp"

#include <fmt/format.h>

namespace quicksand {

namespace {

struct Labeller {
    std::string operator()(const StressCycles& loading) const { return "CSR " + number_text(loading.csr); }
    std::string operator()(const StrainCycles& loading) const
    {
        return fmt::format("gamma {:.4g} %", 100.0 * loading.gamma);
    }
    std::string operator()(const Reconsolidation& loading) const
    {
        return fmt::format("gamma {:.4g} %", 100.0 * loading.gamma);
    }
    template <class Loading>
    std::string operator()(const Loading&) const
    {
        return "";
    }
};

std::string drainage_name(Drainage drainage)
{
    return drainage == Drainage::drained ? "drained" : "undrained";
}

struct Namer {
    std::string operator()(const StressCycles&) const
    {
        return "undrained cyclic simple shear at constant volume, stress-controlled";
    }
    std::string operator()(const StrainCycles& loading) const
    {
        return loading.drainage == Drainage::drained
                   ? "drained cyclic simple shear at constant vertical stress, strain-controlled"
                   : "undrained cyclic simple shear at constant volume, strain-controlled";
    }
    std::string operator()(const Reconsolidation&) const
    {
        return "undrained strain-controlled cyclic simple shear, then drainage without lateral strain";
    }
    std::string operator()(const MonotonicShear& loading) const
    {
        return drainage_name(loading.drainage) + " monotonic simple shear";
    }
    std::string operator()(const BiaxialCompression& loading) const
    {
        return drainage_name(loading.drainage) + " compression in plane strain at constant cell pressure";
    }
    std::string operator()(const OedometerLoading&) const { return "compression in the oedometer"; }
    std::string operator()(const IsotropicLoading&) const { return "isotropic compression in plane strain"; }
};

} // namespace

std::string loading_label(const ElementLoading& loading)
{
    return std::visit(Labeller(), loading);
}

std::string run_label(const ElementOutcome& outcome, const ElementRun& run)
{
    const std::string specimen = outcome.specimen(run).label, loading = loading_label(outcome.loading(run));
    return specimen.empty() || loading.empty() ? specimen + loading : specimen + ", " + loading;
}

std::string loading_name(const ElementLoading& loading)
{
    return std::visit(Namer(), loading);
}

std::optional<double> cycles_to_liquefaction(const ElementOutcome& outcome, const ElementRun& run)
{
    switch (outcome.test.criterion) {
    case LiquefactionCriterion::ru_95:
        return run.result.cycles_to_ru_95;
    case LiquefactionCriterion::strain_3_percent:
        return run.result.cycles_to_3_percent;
    case LiquefactionCriterion::strain_375_percent:
        return run.result.cycles_to_375_percent;
    case LiquefactionCriterion::double_amplitude_75_percent:
        return run.result.cycles_to_75_double;
    }
    return std::nullopt;
}

std::string short_text(std::optional<double> number, int digits)
{
    return number ? fmt::format("{:.{}g}", *number, digits) : "-";
}

} // namespace quicksand
