#include "io/results/verification_csv.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/csv_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

namespace {

std::string finite_number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

} // namespace

void write_verification_csv(const std::filesystem::path& file, const std::vector<Convergence>& results)
{
    std::string text = "problem,quantity,norm,cells,error,limit,order,least_order,seconds,reference\n";
    for (const Convergence& result : results) {
        for (std::size_t k = 0; k < result.cells.size(); ++k) {
            text += csv_text(result.problem) + ',' + csv_text(result.quantity) + ',' + csv_text(result.norm) +
                    ',' + std::to_string(result.cells[k]) + ',' + finite_number(result.errors[k]) + ',' +
                    finite_number(result.limits[k]) + ',' + finite_number(measured_order(result)) + ',' +
                    finite_number(result.least_order) + ',' + finite_number(result.seconds[k]) + ',' +
                    csv_text(result.reference) + '\n';
        }
    }
    write_atomically(file, text);
}

} // namespace quicksand
