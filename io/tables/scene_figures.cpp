#include "io/tables/scene_figures.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/scene_value_reader.hpp"
#include "io/keys/scene_words.hpp"
#include "io/laws/soil_laws.hpp"

#include <algorithm>

namespace quicksand {

namespace {

constexpr WordList<FigureKind, 3> figure_kind_words = {{
    {"history", FigureKind::history},
    {"isochrones", FigureKind::isochrones},
    {"field", FigureKind::field},
}};

void check_probes(const SceneValues& values, const NamedTable& table, const SceneFigure& figure,
                  Diagnostics& findings)
{
    const SourcePlace place = values.place(table.path + ".probes");
    const bool of_profile = figure.kind == FigureKind::isochrones;
    std::vector<std::string> suitable;
    for (const NamedTable& probe : values.tables_named("probes")) {
        if ((values.text(probe.path + ".kind") == "profile") == of_profile) suitable.push_back(probe.name);
    }
    for (const std::string& name : figure.probes) {
        if (std::find(suitable.begin(), suitable.end(), name) != suitable.end()) continue;
        const std::string nearest = nearest_name(name, suitable);
        findings.add(error_at(place, "figure",
                              "there is no probe \"" + name + "\" that " +
                                  (of_profile ? "is a profile" : "has a history"),
                              one_of(suitable), nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
    }
    if (!values.given(table.path + ".probes")) return;
    if (figure.probes.empty() || (of_profile && figure.probes.size() > 1)) {
        findings.add(error_at(place, "figure",
                              "the figure is of " + std::to_string(figure.probes.size()) + " probes",
                              of_profile ? "one profile" : "one probe or more"));
    }
}

void check_range(const SceneValues& values, const NamedTable& table, const SceneFigure& figure,
                 Diagnostics& findings)
{
    const std::vector<double>& range = figure.range;
    if (range.empty() || (range.size() == 2 && range[0] < range[1])) return;
    findings.add(error_at(values.place(table.path + ".range"), "figure", "this is no range of colours",
                          "[low, high] in the SI unit of the field"));
}

/// Those that the results of some scene have; vectors also as a whole, by their amount.
std::vector<std::string> names_of_fields()
{
    std::vector<std::string> names{"velocity", "velocity_x", "velocity_y", "material", "region"};
    for (const Quantity* quantity : quantities_of(on_particles)) {
        if (quantity->form == QuantityForm::vector) names.emplace_back(quantity->name);
        for (std::size_t c = 0; c < component_count(quantity->form); ++c)
            names.push_back(component_name(*quantity, c));
    }
    for (const SoilLaw& law : soil_laws())
        for (const MemoryNumber& number : memory_of(law.form))
            if (number.shown) names.emplace_back(number.name);
    return names;
}

void check_field(const SceneValues& values, const NamedTable& table, const SceneFigure& figure,
                 Diagnostics& findings)
{
    const std::vector<std::string> known = names_of_fields();
    if (figure.field.empty() || std::find(known.begin(), known.end(), figure.field) != known.end()) return;
    const std::string nearest = nearest_name(figure.field, known);
    findings.add(error_at(values.place(table.path + ".field"), "figure",
                          "no results have a field \"" + figure.field + "\"", one_of(known),
                          nearest.empty() ? "" : "did you mean \"" + nearest + "\"?"));
}

void check_name(const NamedTable& table, Diagnostics& findings)
{
    if (!table.name.empty() && !table.name.starts_with('.') &&
        table.name.find_first_of("/\\:*?\"<>|") == std::string::npos)
        return;
    findings.add(error_at(table.place, "name", "the figure's name cannot be that of a file",
                          "none of / \\ : * ? \" < > |, no leading dot"));
}

/// "velocity" of velocity_solid: the grains' is the one that probes have.
std::string without_phase(std::string_view name)
{
    constexpr std::string_view phase = "_solid";
    return std::string(name.substr(0, name.size() - (name.ends_with(phase) ? phase.size() : 0)));
}

std::vector<FigureQuantity> list_figure_quantities()
{
    std::vector<FigureQuantity> all;
    for (const Quantity* quantity : quantities_of(at_probes)) {
        if (quantity->found_by == FoundBy::place) continue;
        const bool scalar = quantity->form == QuantityForm::scalar;
        for (std::size_t c = 0; c < component_count(quantity->form); ++c) {
            const std::string name =
                scalar ? std::string(quantity->name)
                       : (c == 0 ? "horizontal_" : "vertical_") + without_phase(quantity->name);
            all.push_back({name, quantity, c, 1.0, component_label(*quantity, c)});
        }
        if (quantity->name == "displacement") all.push_back({"settlement", quantity, 1, -1.0, "Settlement"});
        if (quantity->name == "total_displacement")
            all.push_back({"total_settlement", quantity, 1, -1.0, "Total settlement"});
    }
    return all;
}

} // namespace

const std::vector<FigureQuantity>& figure_quantities()
{
    static const std::vector<FigureQuantity> all = list_figure_quantities();
    return all;
}

const FigureQuantity* find_figure_quantity(std::string_view name)
{
    for (const FigureQuantity& known : figure_quantities())
        if (known.name == name) return &known;
    return nullptr;
}

std::vector<SceneFigure> read_figures(const SceneValues& values, Diagnostics& findings)
{
    std::vector<SceneFigure> figures;
    for (const NamedTable& table : values.tables_named("figures")) {
        const auto key = [&](const char* name) { return table.path + "." + name; };
        SceneFigure figure;
        figure.name = table.name;
        figure.kind = word_of(figure_kind_words, values.text(key("kind")));
        figure.title = values.text(key("title"));
        figure.probes =
            values.find<std::vector<std::string>>(key("probes")).value_or(std::vector<std::string>());
        figure.quantity = find_figure_quantity(values.text(key("quantity")));
        figure.scale = values.find<double>(key("scale")).value_or(1.0);
        figure.times = values.find<std::vector<double>>(key("times")).value_or(std::vector<double>());
        figure.field = values.text(key("field"));
        figure.time = values.find<double>(key("time"));
        figure.range = values.find<std::vector<double>>(key("range")).value_or(std::vector<double>());
        check_name(table, findings);
        if (figure.kind == FigureKind::field) {
            check_field(values, table, figure, findings);
            check_range(values, table, figure, findings);
        } else {
            check_probes(values, table, figure, findings);
        }
        figures.push_back(std::move(figure));
    }
    return figures;
}

} // namespace quicksand
