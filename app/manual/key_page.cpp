#include "app/manual/key_page.hpp"

#include "app/manual/page_text.hpp"

#include <array>
#include <utility>

namespace quicksand {

namespace {

std::string describe_format(const KeyTable& table)
{
    return section("DESCRIPTION") +
           line("A " + std::string(table.file) +
                " is a text file in TOML: keys with values, in tables whose names stand in brackets. NAME in "
                "the name of a table is a name of your choice. A key that is left out has its default.") +
           next_paragraph() +
           line("Mistakes are shown with their line, what is allowed and what was probably meant, all at "
                "once. A value outside its range is refused; one outside what is usual gives a warning.") +
           next_paragraph() +
           line("The option --set KEY=VALUE of a command replaces a key for one call; KEY is then the name "
                "with those of its tables, as in --set materials.sand.porosity=0.42.");
}

/// The units that a text may carry, "100 kPa", by what they measure.
std::string describe_units()
{
    constexpr std::array<std::pair<Dimension, const char*>, 9> dimensions = {
        {{Dimension::length, "length"},
         {Dimension::time, "time"},
         {Dimension::frequency, "frequency"},
         {Dimension::acceleration, "acceleration"},
         {Dimension::velocity, "velocity"},
         {Dimension::density, "density"},
         {Dimension::pressure, "pressure and stress"},
         {Dimension::angle, "angle"},
         {Dimension::none, "ratio"}}};
    std::string text = section("UNITS") +
                       line("Numbers are in the first unit of each line. A text with a number and a unit, as "
                            "\"100 kPa\", is converted.");
    for (const auto& [dimension, name] : dimensions) {
        std::string symbols(si_symbol(dimension).empty() ? "without unit" : "");
        for (const Unit& unit : units_of(dimension))
            symbols += (symbols.empty() ? "" : ", ") + std::string(unit.symbol);
        text += entry(plain(name), plain(symbols));
    }
    return text;
}

std::string describe_key(const SceneKey& key)
{
    std::string text = plain(key.doc);
    for (const KeyProperty& property : key_properties(key)) {
        text += "\n.br\n" + italic(property.name) + ": " + plain(property.text);
    }
    return entry(bold(last_part(key.pattern)), text);
}

std::string describe_table(const SceneKey& table)
{
    std::string text = subsection("[" + shown_path(table.pattern) + "]") + plain(table.doc) + "\n";
    if (!table.default_note.empty())
        text += ".br\n" + italic("absent") + ": " + plain(table.default_note) + "\n";
    return text;
}

} // namespace

std::string key_page(const std::string& name, const KeyTable& table)
{
    std::string page = page_head(name, 5, "keys of a " + std::string(table.file) + " of Quicksand") +
                       describe_format(table) + describe_units() + section("KEYS");
    for (const SceneKey& key : table.keys) page += is_table(key) ? describe_table(key) : describe_key(key);
    return page + section("SEE ALSO") + bold("quicksand") + "(1)\n";
}

} // namespace quicksand
