#include "io/element/element_data.hpp"

#include "io/files/csv_file.hpp"
#include "io/keys/scene_text.hpp"
#include "io/keys/scene_units.hpp"

#include <cmath>
#include <sstream>

namespace quicksand {

namespace {

constexpr const char* form =
    "one line of column names with CSR and N, then rows of positive numbers, as 0.15,12";

/// The cells of a line without its blanks.
CsvRow cells_of(std::string line)
{
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
    return csv_cells(line);
}

/// Numbers of the wanted columns in the header; -1 where one is missing.
struct Columns {
    int csr = -1, cycles = -1, value = -1;
    std::size_t count = 0;
};

Columns find_columns(const std::vector<std::string>& names, const std::string& varied)
{
    Columns columns;
    columns.count = names.size();
    for (std::size_t k = 0; k < names.size(); ++k) {
        const int column = static_cast<int>(k);
        if (names[k] == "CSR" || names[k] == "csr") columns.csr = column;
        if (names[k] == "N" || names[k] == "n") columns.cycles = column;
        if (!varied.empty() && names[k] == varied) columns.value = column;
    }
    return columns;
}

/// The point of a row; nothing where it is none.
std::optional<StrengthDatum> read_row(const std::vector<std::string>& cells, const Columns& columns)
{
    if (cells.size() != columns.count) return std::nullopt;
    const auto number = [&](int column) {
        const auto quantity = split_quantity(cells[static_cast<std::size_t>(column)]);
        return quantity && quantity->unit.empty() ? quantity->number : std::nan("");
    };
    StrengthDatum datum = {number(columns.csr), number(columns.cycles), {}};
    if (columns.value >= 0) datum.value = number(columns.value);
    const bool good = datum.csr > 0.0 && datum.cycles > 0.0 && std::isfinite(datum.csr) &&
                      std::isfinite(datum.cycles) && std::isfinite(datum.value.value_or(0.0));
    return good ? std::optional(datum) : std::nullopt;
}

} // namespace

std::optional<StrengthData> read_strength_data(const std::filesystem::path& file, const std::string& varied,
                                               const SourcePlace& place, Diagnostics& findings)
{
    const auto text = read_text_file(file, place, findings);
    if (!text) return std::nullopt;
    const auto refuse = [&](const std::string& what) {
        findings.add(error_at(place, "data", "'" + file.string() + "': " + what, form));
        return std::nullopt;
    };
    StrengthData data = {file.stem().string(), {}};
    std::optional<Columns> columns;
    std::istringstream stream(*text);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos || line.starts_with('#')) continue;
        const std::vector<std::string> cells = cells_of(line);
        if (!columns) {
            columns = find_columns(cells, varied);
            if (columns->csr < 0 || columns->cycles < 0) return refuse("it has no columns CSR and N");
            continue;
        }
        const auto datum = read_row(cells, *columns);
        if (!datum) return refuse("line " + std::to_string(number) + " is no point: " + line.substr(0, 60));
        if (datum->csr > largest_stress_ratio)
            return refuse("line " + std::to_string(number) + ": a CSR of " +
                          cells[static_cast<std::size_t>(columns->csr)] + no_ratio);
        data.points.push_back(*datum);
    }
    if (data.points.empty()) return refuse("it holds no points");
    return data;
}

} // namespace quicksand
