#include "io/results/results_reference.hpp"

#include "io/laws/soil_laws.hpp"
#include "io/results/run_manifest.hpp"
#include "io/results/steps_csv.hpp"
#include "solver/measure/body_quantities.hpp"
#include "solver/measure/quantities.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace quicksand {

namespace {

constexpr std::array run_files = {
    DocumentedName{"run_manifest.json", "what was run, on what, how it ended; see below"},
    DocumentedName{"scene.toml", "copy of the scene"},
    DocumentedName{"log.txt", "what the run said"},
    DocumentedName{"fields.pvd, fields/*.vtu",
                   "the particles every output.frame_interval: polygons with the arrays below"},
    DocumentedName{"grid.pvd, grid/*.vtu",
                   "the background grid at the same times: averages of the particles at its nodes"},
    DocumentedName{
        "settling.pvd, settling/*.vtu, settling.png",
        "the particles, and a picture of their displacement, where the soil did not come to rest or was "
        "stopped while it settled"},
    DocumentedName{"probes/NAME.csv", "the probes of the scene every output.probe_interval"},
    DocumentedName{"history.csv", "the whole body every output.history_interval"},
    DocumentedName{"steps.csv", "the time steps and what they cost, at the same times"},
    DocumentedName{
        "checkpoint/state.h5",
        "the whole state every output.checkpoint_interval and at the end; run --resume goes on from it"},
};

constexpr std::array other_files = {
    DocumentedName{"run of a scene with stages",
                   "a folder as above for each, stages.csv (stage, kind, status, start_s, duration_s, "
                   "factor_of_safety), and stages.pvd with the frames of all of them on one clock"},
    DocumentedName{"check", "fields.pvd and grid.pvd of the start in results/SCENE-check"},
    DocumentedName{"stability",
                   "stability.txt, stability.csv (factor, displacement_m, out_of_balance, stands, steps), "
                   "fields.pvd and grid.pvd of the failure in results/SCENE-stability or RESULTS/stability"},
    DocumentedName{"picture", "pictures/*.png: fields of the last frame, probes and history"},
    DocumentedName{"figures", "figures/NAME.png, one a table [figures.NAME] of the scene"},
    DocumentedName{"probe", "one CSV file with the time and the fields asked for; columns as above"},
    DocumentedName{"element",
                   "a folder a test: CSV files whose first lines explain their columns, and PNG pages"},
    DocumentedName{"verify", "verification.csv and a figure a problem"},
};

std::string table_of(const auto& rows, std::string_view first, std::string_view second)
{
    std::string text = fmt::format("| {} | {} |\n|---|---|\n", first, second);
    for (const DocumentedName& row : rows) text += fmt::format("| `{}` | {} |\n", row.name, row.meaning);
    return text;
}

/// "ux_m, uy_m"; "" where probes do not have the quantity.
std::string probe_column_list(const Quantity& quantity)
{
    std::string text;
    for (std::size_t c = 0; (quantity.places & at_probes) != 0 && c < component_count(quantity.form); ++c)
        text += (c == 0 ? "" : ", ") + probe_column(quantity, c);
    return text;
}

/// What the quantity is and which scenes have it.
std::string meaning_of(const Quantity& quantity)
{
    std::string text(quantity.meaning);
    if (quantity.scatters) text += "; at probes on particles, of a plane through those of its soil around";
    if (quantity.of == QuantityOf::wet_soil) text += "; with water";
    if (quantity.of == QuantityOf::staged_soil) text += "; with stages";
    if (quantity.of == QuantityOf::moving_water) text += "; with water that flows by itself";
    return text;
}

/// As code, where there is a text.
std::string in_code(const std::string& text)
{
    return text.empty() ? "" : "`" + text + "`";
}

/// With the bars escaped that would end the cell of a table.
std::string markdown_cell(std::string_view text)
{
    std::string cell;
    for (const char letter : text) {
        if (letter == '|') cell += '\\';
        cell += letter;
    }
    return cell;
}

std::string array_of(const Quantity& quantity, QuantityPlace place)
{
    if ((quantity.places & place) == 0) return "";
    std::string text = fmt::format("`{}`", quantity.name);
    if (quantity.form == QuantityForm::tensor) text += " XX YY ZZ XY";
    return text;
}

std::string point_quantities()
{
    std::string text = "| quantity | symbol | unit | `fields.pvd` | `grid.pvd` | probes | meaning |\n"
                       "|---|---|---|---|---|---|---|\n";
    for (const Quantity& quantity : all_quantities())
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", quantity.label, quantity.symbol,
                            quantity.unit, array_of(quantity, on_particles), array_of(quantity, on_nodes),
                            in_code(probe_column_list(quantity)), meaning_of(quantity));
    return text;
}

std::string laws_memory()
{
    std::string text = "| `model` | array | unit | meaning |\n|---|---|---|---|\n";
    for (const SoilLaw& law : soil_laws())
        for (const MemoryNumber& number : memory_of(law.form))
            if (number.shown)
                text += fmt::format("| `{}` | `{}` | {} | {} |\n", law.word, number.name, number.unit,
                                    number.meaning);
    return text;
}

std::string use_of(BodyQuantityOf of)
{
    switch (of) {
    case BodyQuantityOf::any_body:
    case BodyQuantityOf::balanced_body:
        break;
    case BodyQuantityOf::small_body:
        return "; with `strain = \"small\"`";
    case BodyQuantityOf::wet_body:
    case BodyQuantityOf::balanced_wet_body:
        return "; with water";
    case BodyQuantityOf::balanced_stiff_body:
        return "; with `scheme = \"implicit\"`";
    }
    return "";
}

std::string body_columns()
{
    std::string text = "| column | meaning |\n|---|---|\n";
    for (const BodyQuantity& quantity : all_body_quantities())
        text += fmt::format("| `{}` | {}{} |\n", column_name(quantity), markdown_cell(quantity.meaning),
                            use_of(quantity.of));
    return text;
}

} // namespace

std::string results_markdown()
{
    return "# Results\n\n"
           "Every file that Quicksand writes, and what stands in it. Numbers are SI; y is up; lengths are "
           "those of "
           "the drawing; masses, energies and forces are per metre of thickness. `quicksand keys --results "
           "ru` "
           "looks a quantity up.\n\n"
           "## A run\n\n`quicksand run SCENE` writes to `results/SCENE`:\n\n" +
           table_of(run_files, "file", "holds") + "\n## Quantities of a point\n\n" + point_quantities() +
           "\nVectors have the components X, Y, Z (Z = 0) in frames. `fields.pvd` has `material`, `region` "
           "and "
           "`particle_id` as well: numbers of the names in the file's `material_names` and `region_names`, "
           "and a "
           "number that stays with the particle. `grid.pvd` has `soil_volume` [m3/m] and `node_id`. A value "
           "is NaN "
           "(an empty cell in CSV) where there is none. At fixed points and on nodes values are averages of "
           "the "
           "particles around, and `ru` counts the stress of half a cell of water at least.\n\n"
           "## What soil laws remember\n\nArrays of `fields.pvd`, from the start of the shaking on:\n\n" +
           laws_memory() + "\n## history.csv\n\n" + body_columns() + "\n## steps.csv\n\n" +
           table_of(step_columns(), "column", "meaning") + "\n## run_manifest.json\n\n" +
           table_of(manifest_fields(), "field", "meaning") + "\n## Other commands\n\n" +
           table_of(other_files, "command", "writes");
}

std::string describe_quantities(std::string_view pattern)
{
    std::string text;
    const auto holds = [&](std::string_view where) { return where.find(pattern) != std::string_view::npos; };
    for (const Quantity& quantity : all_quantities()) {
        const std::string columns = probe_column_list(quantity);
        if (!holds(quantity.name) && !holds(columns) && !holds(quantity.meaning)) continue;
        text += fmt::format("{}\n    {}\n    symbol   {}\n    unit     {}\n", quantity.name,
                            meaning_of(quantity), quantity.symbol, quantity.unit);
        if ((quantity.places & (on_particles | on_nodes)) != 0)
            text +=
                fmt::format("    frames   {}{}\n", (quantity.places & on_particles) != 0 ? "fields.pvd " : "",
                            (quantity.places & on_nodes) != 0 ? "grid.pvd" : "");
        if (!columns.empty()) text += "    probes   " + columns + "\n";
    }
    for (const BodyQuantity& quantity : all_body_quantities()) {
        const std::string column = column_name(quantity);
        if (holds(column) || holds(quantity.meaning))
            text +=
                fmt::format("{}\n    {}{}\n    history.csv\n", column, quantity.meaning, use_of(quantity.of));
    }
    return text;
}

} // namespace quicksand
