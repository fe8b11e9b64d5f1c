#include "io/tables/scene_verification.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quicksand {

namespace {

void check_cells(const SceneValues& values, const SceneVerification& verification, Diagnostics& findings)
{
    const std::vector<int>& cells = verification.cells;
    if (!std::is_sorted(cells.begin(), cells.end(), std::less_equal<>())) {
        findings.add(error_at(values.place("verification.cells"), "range",
                              "verification.cells does not go from coarse to fine",
                              "whole numbers that increase, as [10, 20, 40]"));
    }
    for (const int count : verification.short_cells) {
        if (std::find(cells.begin(), cells.end(), count) != cells.end()) continue;
        findings.add(error_at(values.place("verification.short_cells"), "range",
                              fmt::format("verification.short_cells has {}, which is not in cells", count),
                              "some of " + value_text(SceneValue(cells))));
    }
    if (values.given("grid.cells")) {
        findings.add(error_at(values.place("grid.cells"), "verification",
                              "grid.cells fixes the number of cells that verify is to vary", "",
                              "remove it; the grid then covers the section"));
    }
}

void check_limits(const SceneValues& values, const SceneVerification& verification, Diagnostics& findings)
{
    for (const auto& [quantity, limits] : verification.limits) {
        if (limits.size() == verification.cells.size()) continue;
        findings.add(error_at(values.place("verification.limits"), "verification",
                              fmt::format("the limits of \"{}\" are {}, the grids of verification.cells {}",
                                          quantity, limits.size(), verification.cells.size()),
                              "one limit for each grid"));
    }
}

void check_parameters(const SceneValues& values, const SceneVerification& verification, Diagnostics& findings)
{
    const auto parameters = values.find<std::map<std::string, double>>("geometry.parameters")
                                .value_or(std::map<std::string, double>());
    for (const std::string& name : verification.one_cell) {
        if (parameters.contains(name)) continue;
        findings.add(
            error_at(values.place("verification.one_cell"), "verification",
                     "verification.one_cell names \"" + name + "\", which is not in geometry.parameters",
                     "parameters of the drawing that the scene gives a value"));
    }
}

void check_flow(const SceneValues& values, Diagnostics& findings)
{
    const std::string flow = values.text("water.flow");
    if (flow.empty() || flow == "coupled") return;
    findings.add(error_at(values.place("water.flow"), "verification",
                          "the problems of verify have coupled flow in their solutions, not " + flow,
                          "water.flow = \"coupled\""));
}

} // namespace

std::optional<SceneVerification> read_verification(const SceneValues& values, Diagnostics& findings)
{
    if (!values.has_table("verification") || !values.has("verification.cells")) return std::nullopt;
    SceneVerification verification;
    verification.problem = values.text("verification.problem");
    verification.parameters.amplitude = values.find<double>("verification.amplitude");
    verification.length = values.number("verification.length");
    verification.cells = *values.find<std::vector<int>>("verification.cells");
    verification.short_cells = values.find<std::vector<int>>("verification.short_cells")
                                   .value_or(std::vector<int>{verification.cells.front()});
    verification.one_cell =
        values.find<std::vector<std::string>>("verification.one_cell").value_or(std::vector<std::string>());
    using Limits = std::map<std::string, std::vector<double>>;
    using Orders = std::map<std::string, double>;
    verification.limits = values.find<Limits>("verification.limits").value_or(Limits());
    verification.orders = values.find<Orders>("verification.orders").value_or(Orders());
    verification.place = values.tables.at("verification");
    verification.limits_place = values.place("verification.limits");
    verification.orders_place = values.place("verification.orders");
    check_flow(values, findings);
    check_cells(values, verification, findings);
    check_limits(values, verification, findings);
    check_parameters(values, verification, findings);
    return verification;
}

std::vector<std::string> resolution_overrides(const SceneVerification& verification, int cells)
{
    const double cell_size = verification.length / cells;
    std::vector<std::string> overrides = {fmt::format("grid.cell_size={}", cell_size)};
    for (const std::string& name : verification.one_cell) {
        overrides.push_back(fmt::format("geometry.parameters.{}={}", join_path({name}), cell_size));
    }
    return overrides;
}

} // namespace quicksand
