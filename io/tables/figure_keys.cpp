#include "io/tables/figure_keys.hpp"

#include "io/tables/scene_figures.hpp"

namespace quicksand {

std::vector<SceneKey> figure_keys()
{
    using enum ValueType;
    const Condition of_probes{"kind", {"history", "isochrones"}};
    const Condition field_only{"kind", {"field"}};
    std::vector<std::string_view> quantities;
    for (const FigureQuantity& quantity : figure_quantities()) quantities.push_back(quantity.name);
    // One row, one key: the formatter would make it ten lines.
    // clang-format off
    return {
        {.pattern = "figures", .type = named_tables, .doc = "What quicksand figures draws from a finished run."},
        {.pattern = "figures.*", .type = table, .doc = "One figure; its name is that of its PNG file."},
        {.pattern = "figures.*.kind", .type = word, .default_value = "history",
         .words = {"history", "isochrones", "field"},
         .doc = "A quantity over time at probes, along a profile at several times, or a field over the section."},
        {.pattern = "figures.*.title", .type = text, .default_value = "", .doc = "What stands above the figure."},
        {.pattern = "figures.*.probes", .type = text_list, .required = true, .when = of_probes,
         .doc = "Names of the probes in the figure; of one profile for isochrones."},
        {.pattern = "figures.*.quantity", .type = word, .required = true, .words = quantities, .when = of_probes,
         .doc = "What is drawn; settlement is the displacement downward, total that of all stages."},
        {.pattern = "figures.*.scale", .default_value = 1.0, .allowed = {.lower = 0.0, .lower_open = true},
         .plausible = {1.0, 300.0}, .when = of_probes,
         .doc = "Full scale over that of a centrifuge model: lengths and times are drawn this much larger."},
        {.pattern = "figures.*.times", .type = number_list, .dimension = Dimension::time,
         .default_note = "eight, evenly", .allowed = {.lower = 0.0}, .when = {"kind", {"isochrones"}},
         .doc = "Times of the isochrones, those of the run."},
        {.pattern = "figures.*.field", .type = text, .required = true, .when = field_only,
         .doc = "Field that is drawn, as quicksand picture --field names it."},
        {.pattern = "figures.*.time", .dimension = Dimension::time, .default_note = "the last frame",
         .allowed = {.lower = 0.0}, .when = field_only, .doc = "Time of the field; the nearest frame is drawn."},
        {.pattern = "figures.*.range", .type = number_list, .default_note = "round limits around the values",
         .when = field_only, .doc = "Limits of the colours, [low, high] in the SI unit of the field."},
    };
    // clang-format on
}

} // namespace quicksand
