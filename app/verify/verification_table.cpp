#include "app/verify/verification_table.hpp"

#include "app/run/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace quicksand {

namespace {

using Row = std::vector<std::string>;

/// "0.62 %" in per cent, or as it is where it is tiny.
std::string error_text(double error)
{
    if (!std::isfinite(error)) return "failed";
    return error != 0.0 && error < 1e-6 ? short_number(error, 2) : fmt::format("{:.3g} %", 100.0 * error);
}

std::string errors_text(const std::vector<double>& errors)
{
    std::string text;
    for (const double error : errors) text += (text.empty() ? "" : "  ") + error_text(error);
    return text;
}

std::string cells_text(const std::vector<int>& cells)
{
    std::string text;
    for (const int count : cells) text += (text.empty() ? "" : "/") + std::to_string(count);
    return text;
}

std::string required_text(const Convergence& result)
{
    std::string text;
    if (std::isfinite(result.limits.back())) text = fmt::format("<= {:.3g} %", 100.0 * result.limits.back());
    if (std::isfinite(result.least_order) && result.cells.size() > 1) {
        text += fmt::format("{}order >= {:.3g}", text.empty() ? "" : ", ", result.least_order);
    }
    return text;
}

/// Which grids, or the order, miss what is required.
std::string verdict(const Convergence& result)
{
    if (meets_requirements(result)) return "";
    std::vector<int> missed;
    for (std::size_t k = 0; k < result.cells.size(); ++k) {
        if (!(result.errors[k] <= result.limits[k])) missed.push_back(result.cells[k]);
    }
    return "MISSED on " + (missed.empty() ? std::string("the order") : cells_text(missed));
}

Row row_of(const Convergence& result)
{
    const double order = measured_order(result);
    const double seconds = std::accumulate(result.seconds.begin(), result.seconds.end(), 0.0);
    return {result.problem,
            result.quantity,
            result.norm,
            cells_text(result.cells),
            errors_text(result.errors),
            std::isfinite(order) ? fmt::format("{:.2f}", order) : "-",
            required_text(result),
            verdict(result),
            duration_text(seconds),
            result.reference};
}

} // namespace

std::string describe_convergence(const std::vector<Convergence>& results)
{
    std::vector<Row> rows = {{"problem", "quantity", "norm", "cells", "error on each grid", "order",
                              "required", "", "time", "reference"}};
    for (const Convergence& result : results) rows.push_back(row_of(result));
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < row.size(); ++c) {
            if (widths[c] > 0) line += fmt::format("{:<{}}  ", row[c], widths[c]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

} // namespace quicksand
