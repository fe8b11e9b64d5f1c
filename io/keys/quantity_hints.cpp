#include "io/keys/quantity_hints.hpp"

#include "geometry/drawing/lower_case.hpp"
#include "io/keys/diagnostics.hpp"

namespace quicksand {

std::string list_units(Dimension dimension)
{
    std::vector<std::string> symbols;
    for (const Unit& unit : units_of(dimension)) symbols.emplace_back(unit.symbol);
    return one_of(symbols);
}

std::string unit_in_other_case(std::string_view text, Dimension dimension)
{
    for (const Unit& unit : units_of(dimension)) {
        if (lower_case(std::string(unit.symbol)) == lower_case(std::string(text)))
            return std::string(unit.symbol);
    }
    return "";
}

std::string number_form(Dimension dimension)
{
    if (dimension == Dimension::none) return "a number";
    const auto& units = units_of(dimension);
    return "a number in " + std::string(units[0].symbol) + ", or a quantity in quotes as \"1 " +
           std::string(units[1].symbol) + "\"";
}

std::string likely_quantity(const WrittenQuantity& written, Dimension dimension, const Interval& wanted)
{
    if (dimension == Dimension::none) {
        const bool percent = written.number > 1.0 && wanted.contains(written.number / 100.0);
        return percent ? number_text(written.number / 100.0) + " (" + number_text(written.number) + " %)"
                       : "";
    }
    for (const Unit& unit : units_of(dimension)) {
        if (unit.symbol == written.unit || (written.unit.empty() && unit.multiply == unit.divide)) continue;
        if (wanted.contains(written.number * unit.multiply / unit.divide)) {
            return '"' + number_text(written.number) + " " + std::string(unit.symbol) + '"';
        }
    }
    return "";
}

} // namespace quicksand
