#include "io/verification_csv.hpp"

#include "io/atomic_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

namespace {

/// Text in quotes, so that it may hold commas.
std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char letter : text) result += letter == '"' ? "\"\"" : std::string(1, letter);
    return result + '"';
}

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
            text += quoted(result.problem) + ',' + quoted(result.quantity) + ',' + quoted(result.norm) + ',' +
                    std::to_string(result.cells[k]) + ',' + finite_number(result.errors[k]) + ',' +
                    finite_number(result.limits[k]) + ',' + finite_number(measured_order(result)) + ',' +
                    finite_number(result.least_order) + ',' + finite_number(result.seconds[k]) + ',' +
                    quoted(result.reference) + '\n';
        }
    }
    write_atomically(file, text);
}

} // namespace quicksand
