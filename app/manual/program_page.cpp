#include "app/manual/program_page.hpp"

#include "app/manual/exit_meanings.hpp"
#include "app/manual/option_value.hpp"
#include "app/manual/page_text.hpp"

#include <array>
#include <utility>

namespace quicksand {

namespace {

using Entry = std::pair<const char*, const char*>;

constexpr const char* purpose = "liquefaction of saturated sand and the deformation of dikes in earthquakes";
constexpr const char* description =
    "Quicksand predicts how saturated sand liquefies and how far dikes slide and settle in an earthquake. A "
    "cross-section is drawn in gmsh and described by a scene, a text file of keys. The soil is a set of "
    "material "
    "points with deforming domains (CPDI) that carry grains and pore water through a background grid; the "
    "sand is "
    "UBCSAND or PM4Sand. Results are opened in ParaView.";

constexpr std::array files = {
    Entry{"scene.toml", "a scene; see quicksand-scene(5)"},
    Entry{"test.toml", "tests of the element laboratory; see quicksand-element(5)"},
    Entry{"results/SCENE/fields.pvd", "the soil for ParaView: every particle is a cell with its own shape"},
    Entry{"results/SCENE/grid.pvd", "the same fields on the nodes of the background grid"},
    Entry{"results/SCENE/probes/NAME.csv", "histories at the probes; every column carries its unit"},
    Entry{"results/SCENE/history.csv",
          "settlement of the crest, extremes, balances of momentum, energy and water"},
    Entry{"results/SCENE/steps.csv", "the time step and what limits it, wall time, mass error"},
    Entry{"results/SCENE/run_manifest.json", "what was run, with which version, and how it ended"},
    Entry{"results/SCENE/checkpoint/state.h5", "the last complete state, from which --resume goes on"},
    Entry{"PREFIX/share/quicksand/examples", "the examples that come with the program, with a tutorial"}};

constexpr std::array environment = {
    Entry{"OMP_NUM_THREADS", "threads where --threads is not given"},
    Entry{"GOMP_SPINCOUNT, OMP_WAIT_POLICY", "how long threads wait actively for each other; when neither is "
                                             "set, the program starts itself once more "
                                             "with GOMP_SPINCOUNT=1000"},
    Entry{"GLIBC_TUNABLES",
          "settings of the memory allocator; when not set, as above with huge pages and one arena"},
    Entry{"TMPDIR", "folder of short-lived files; /tmp when not set"}};

constexpr std::array examples = {
    Entry{"quicksand demo", "the dike example, shortened to two minutes, with pictures"},
    Entry{"quicksand new dike my_dike", "a folder with a commented scene and drawing to start from"},
    Entry{"quicksand check my_dike", "the plan of a run: particles, time step, run time, disk"},
    Entry{"quicksand run my_dike --set motion.amplitude=\"40 g\" --until 0.2",
          "a run with other shaking, 0.2 s long"},
    Entry{"quicksand run my_dike --resume", "go on with a run that was stopped"},
    Entry{"quicksand picture results/my_dike", "PNG files of the last frame"},
    Entry{"quicksand keys porosity", "the keys of a scene that have porosity in their name"}};

template <class Entries>
std::string list_entries(const char* title, const Entries& entries)
{
    std::string text = section(title);
    for (const auto& [term, meaning] : entries) text += entry(bold(term), plain(meaning));
    return text;
}

/// "SCENE", "[WORDS...]"
std::string positional_form(const CLI::Option& option)
{
    const std::string name = italic(option.get_name(true));
    const std::string form = option.get_items_expected_max() > 1 ? name + "..." : name;
    return option.get_required() ? form : "[" + form + "]";
}

/// "-o, --output DIR"
std::string option_form(CLI::Option& option)
{
    std::string names;
    const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + bold(name); };
    for (const std::string& name : option.get_snames()) add("-" + name);
    for (const std::string& name : option.get_lnames()) add("--" + name);
    const OptionValue value = value_of(option);
    if (value.name.empty()) return names;
    std::string words;
    for (const std::string& word : value.words) words += (words.empty() ? "" : "|") + bold(word);
    return names + " " + (words.empty() ? italic(value.name) : words);
}

std::string option_meaning(CLI::Option& option)
{
    const OptionValue value = value_of(option);
    std::string text = option.get_description();
    std::string notes;
    const auto add = [&](const std::string& note) { notes += (notes.empty() ? "" : "; ") + note; };
    if (option.get_required() && !option.get_positional()) add("required");
    if (!value.allowed.empty()) add(value.allowed);
    if (!option.get_default_str().empty()) add(option.get_default_str() + " when not given");
    for (const CLI::Option* other : option.get_excludes()) add("not with " + other->get_name());
    return plain(notes.empty() ? text : text + " (" + notes + ")");
}

bool asks_for_help(const CLI::Option& option)
{
    return option.check_lname("help");
}

std::string command_form(const CLI::App& command)
{
    std::string form = bold(command.get_name());
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) form += " " + positional_form(*option);
    }
    return form;
}

std::string describe_command(CLI::App& command)
{
    std::string text = ".SS " + command_form(command) + "\n" + plain(command.get_description()) + ".\n";
    for (CLI::Option* option : command.get_options()) {
        if (asks_for_help(*option)) continue;
        const std::string form =
            option->get_positional() ? italic(option->get_name(true)) : option_form(*option);
        text += entry(form, option_meaning(*option));
    }
    return text;
}

std::string synopsis(CLI::App& program, const std::vector<CLI::App*>& commands)
{
    const std::string name = bold(program.get_name());
    std::string text = section("SYNOPSIS");
    for (const CLI::App* command : commands)
        text += name + " " + command_form(*command) + " [options]\n.br\n";
    for (CLI::Option* option : program.get_options()) {
        if (!asks_for_help(*option)) text += name + " " + option_form(*option) + "\n.br\n";
    }
    return text + name + " [" + italic("command") + "] " + bold("--help") + "\n";
}

std::string exit_status()
{
    std::string text = section("EXIT STATUS");
    for (const ExitMeaning& exit : exit_meanings()) {
        text += entry(bold(std::to_string(static_cast<int>(exit.code))), plain(exit.meaning));
    }
    return text;
}

} // namespace

std::string program_page(CLI::App& program)
{
    const std::vector<CLI::App*> commands = program.get_subcommands([](CLI::App*) { return true; });
    std::string page = page_head(program.get_name(), 1, purpose) + synopsis(program, commands) +
                       section("DESCRIPTION") + line(description) + section("COMMANDS");
    for (CLI::App* command : commands) page += describe_command(*command);
    page += exit_status() + list_entries("FILES", files) + list_entries("ENVIRONMENT", environment) +
            list_entries("EXAMPLES", examples);
    return page + section("SEE ALSO") + bold("quicksand-scene") + "(5), " + bold("quicksand-element") +
           "(5), " + bold("gmsh") + "(1), " + bold("paraview") + "(1)\n";
}

} // namespace quicksand
