#include "app/commands/command_line.hpp"

#include "app/bench/benchmarks.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/number_check.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/diagnostics.hpp"
#include "solver/base/failure.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

namespace quicksand {

namespace {

constexpr const char* description =
    "Quicksand: liquefaction of saturated sand and the deformation of dikes in earthquakes.";
constexpr const char* footer =
    "Start with:  quicksand demo      (two minutes, then open its files)\n"
    "             quicksand new dike my_dike\n"
    "Exit codes:  0 good, 2 input, 3 numerical, 4 files and disk, 5 a bug of ours,\n"
    "             6 verify: an error is above its limit\n"
    "Help on a command:  quicksand COMMAND --help";

/// A command's parser and what to do once it has been parsed.
struct Command {
    CLI::App* parser = nullptr;
    std::function<ExitCode()> execute;
};

using Commands = std::vector<Command>;

template <class Choice>
using Execute = ExitCode (*)(const Choice&);

/// Give the program a command; the returned choice is filled when the command line is parsed.
template <class Choice>
std::pair<CLI::App*, std::shared_ptr<Choice>> add_command(CLI::App& program, Commands& commands,
                                                          const char* name, const char* about,
                                                          Execute<Choice> execute)
{
    CLI::App* parser = program.add_subcommand(name, about);
    auto choice = std::make_shared<Choice>();
    commands.push_back({parser, [choice, execute] { return execute(*choice); }});
    return {parser, choice};
}

void add_threads(CLI::App& parser, int& threads)
{
    parser.add_option("--threads", threads, "Threads; all of the machine's when not given")
        ->check(number_in(thread_number))
        ->type_name("N");
}

void add_overrides(CLI::App& parser, std::vector<std::string>& overrides,
                   const std::string& about = "Replace a key of the scene: --set motion.amplitude=\"0.2 g\"")
{
    parser.add_option("--set", overrides, about)
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false); // the word after it may be a scene
}

void add_scene(CLI::App& parser, SceneChoice& choice)
{
    parser.add_option("SCENE", choice.scene, "Scene file, or a folder that holds scene.toml")->required();
    add_threads(parser, choice.threads);
    parser.add_option("--until", choice.until, "End of the run in s, in place of run.end_time")
        ->check(number_in(positive_number))
        ->type_name("T");
    add_overrides(parser, choice.overrides);
}

void add_run(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] =
        add_command<RunChoice>(program, commands, "run", "Run a scene and write its results", run_scene);
    add_scene(*parser, choice->scene);
    parser->add_option("-o,--output", choice->directory, "Results folder; results/<scene> when not given")
        ->type_name("DIR");
    CLI::Option* overwrite =
        parser->add_flag("--overwrite", choice->overwrite, "Replace the results of a former run");
    parser->add_flag("--resume", choice->resume, "Go on from the last checkpoint")->excludes(overwrite);
}

void add_check(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<CheckChoice>(
        program, commands, "check", "Say what a run of the scene will be, and write its initial frame",
        check_scene);
    add_scene(*parser, choice->scene);
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the frame; results/<scene>-check when not given")
        ->type_name("DIR");
}

void add_stability(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<StabilityChoice>(
        program, commands, "stability",
        "Find the factor of safety of a slope by reducing its strength, with the way it fails",
        assess_stability);
    add_scene(*parser, choice->scene);
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder; results/<scene>-stability when not given")
        ->type_name("DIR");
    parser->add_option("--tolerance", choice->tolerance, "Width of the bracket over the factor; 0.005")
        ->check(number_in({.lower = 1e-4, .upper = 0.5}))
        ->type_name("W");
    parser
        ->add_option("--seismic-coefficient", choice->seismic_coefficient,
                     "Horizontal force over weight, positive towards +x (pseudo-static)")
        ->check(number_in({.lower = -2.0, .upper = 2.0}))
        ->type_name("K");
}

void add_keys(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] =
        add_command<KeysChoice>(program, commands, "keys", "List the keys of a scene", list_keys);
    parser->add_option("PATTERN", choice->pattern, "Only keys that contain this text");
    parser->add_flag("--markdown", choice->markdown, "As the reference page");
    CLI::Option* element =
        parser->add_flag("--element", choice->of_element_tests, "The keys of element tests");
    parser->add_flag("--results", choice->of_results, "The quantities and files of results")
        ->excludes(element);
}

void add_element(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<ElementChoice>(
        program, commands, "element", "Test a soil in the element laboratory: simple shear and others",
        run_element_tests);
    parser->add_option("TEST", choice->file, "File of tests, or a folder that holds test.toml")->required();
    add_overrides(*parser, choice->overrides, "Replace a key of the file: --set materials.sand.n1_60=10");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder, replaced if there; results/<file> when not given")
        ->type_name("DIR");
}

void add_new(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<NewChoice>(
        program, commands, "new", "Make a folder with a commented scene and drawing to start from",
        create_scene);
    parser->add_option("KIND", choice->example, "dike or column")->required();
    parser->add_option("NAME", choice->folder, "The folder to make")->required();
}

void add_probe(CLI::App& program, Commands& commands)
{
    struct Words {
        std::vector<double> at;
        std::string kind = "fixed";
    };
    CLI::App* parser = program.add_subcommand("probe", "Take a history at a point out of written frames");
    auto choice = std::make_shared<ProbeChoice>();
    auto words = std::make_shared<Words>();
    parser->add_option("RESULTS", choice->results, "Results folder of a run")->required();
    parser->add_option("--at", words->at, "Place in m")
        ->check(number_in(any_number))
        ->delimiter(',')
        ->expected(2)
        ->allow_extra_args(false)
        ->required()
        ->type_name("X,Y");
    parser->add_option("--fields", choice->fields, "Fields, as excess_pore_pressure,ru")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->required()
        ->type_name("A,B");
    parser->add_option("--kind", words->kind, "fixed in space, or riding with the material")
        ->check(CLI::IsMember({"fixed", "material"}));
    parser->add_option("-o,--output", choice->file, "CSV file to write")->required()->type_name("FILE");
    commands.push_back({parser, [choice, words] {
                            choice->at = {words->at[0], words->at[1]};
                            choice->rides_with_soil = words->kind == "material";
                            return extract_probe(*choice);
                        }});
}

void add_picture(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<PictureChoice>(
        program, commands, "picture", "Draw the results of a run as PNG files, no display needed",
        draw_pictures);
    parser->add_option("RESULTS", choice->results, "Results folder of a run")->required();
    parser
        ->add_option("-o,--output", choice->output,
                     "A .png file or a folder; RESULTS/pictures when not given")
        ->type_name("FILE");
    parser->add_option("--field", choice->field, "Only this field, as excess_pore_pressure or displacement")
        ->type_name("NAME");
    parser
        ->add_option("--time", choice->time, "Time in s, the nearest frame is drawn; the last when not given")
        ->check(number_in(any_number))
        ->type_name("T");
    parser->add_option("--range", choice->range, "Limits of the colours, in the SI unit of the field")
        ->type_name("LOW:HIGH");
    parser->add_option("--exaggeration", choice->exaggeration, "Factor on the displacements drawn")
        ->check(number_in(positive_number))
        ->type_name("F");
}

void add_figures(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<FiguresChoice>(
        program, commands, "figures", "Draw the figures that a scene asks for from its finished run",
        draw_scene_figures);
    parser->add_option("SOURCE", choice->source, "Scene, its folder, or the results folder of a run")
        ->required();
    parser->add_option("--results", choice->results, "Results of the scene; results/<scene> when not given")
        ->type_name("DIR");
    parser
        ->add_option("-o,--output", choice->output, "Folder of the PNG files; RESULTS/figures when not given")
        ->type_name("DIR");
}

void add_bench(CLI::App& program, Commands& commands)
{
    using Measure = ExitCode (*)(const BenchChoice&);
    static const std::map<std::string, Measure> subjects = {{"kernel", measure_kernel},
                                                            {"error", measure_errors},
                                                            {"grid", measure_grids},
                                                            {"scale", measure_scale},
                                                            {"skip", measure_skips}};
    CLI::App* parser = program.add_subcommand("bench", "Measure speed, memory, and run time against error");
    auto subject = std::make_shared<std::string>();
    auto choice = std::make_shared<BenchChoice>();
    parser
        ->add_option(
            "SUBJECT", *subject,
            "kernel: the phases of a step; error: run time against error; grid: a scene's answers over cell "
            "size and particles per cell; scale: over particles and threads; skip: what scenes save "
            "by what they leave out")
        ->required()
        ->check(CLI::IsMember({"kernel", "error", "grid", "scale", "skip"}));
    parser->add_option(
        "WORDS", choice->words,
        "Scenes, or for error problems of verify; those that come with the program when not given");
    add_overrides(*parser, choice->overrides, "Replace a key of the scenes");
    parser->add_option("-o,--output", choice->directory, "Folder of tables and figures")
        ->type_name("DIR")
        ->capture_default_str();
    parser->add_option("--until", choice->until, "End of the runs of scenes in s, for error and grid")
        ->type_name("T")
        ->check(number_in(positive_number));
    parser->add_option("--largest", choice->largest, "Particles of the largest body of scale")
        ->check(number_in({.lower = 1e3, .upper = 1e8}))
        ->type_name("N")
        ->capture_default_str();
    parser->add_option("--threads", choice->threads, "Threads; kernel measures 1 and 2 when not given")
        ->check(number_in(thread_number))
        ->type_name("N");
    commands.push_back({parser, [subject, choice] { return subjects.at(*subject)(*choice); }});
}

void add_verify(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<VerifyChoice>(
        program, commands, "verify", "Measure errors and orders on problems with known solutions",
        verify_problems);
    parser->add_option("PROBLEM", choice->problems,
                       "Names in examples/verification, or scenes with [verification]; all when not given");
    parser->add_flag("--short", choice->shortened, "Only the coarse grids, in less than a minute");
    add_overrides(*parser, choice->overrides);
    parser
        ->add_option("--threads", choice->threads,
                     "Runs at the same time; all of the machine's when not given")
        ->check(number_in(thread_number))
        ->type_name("N");
    parser
        ->add_option("-o,--output", choice->directory,
                     "Folder of the table and the figures; results/verification when not given")
        ->type_name("DIR");
}

void add_demo(CLI::App& program, Commands& commands)
{
    const auto [parser, choice] = add_command<DemoChoice>(
        program, commands, "demo", "Run the dike example, shortened to about two minutes", run_demo);
    add_threads(*parser, choice->threads);
    parser
        ->add_option("-o,--output", choice->directory,
                     "Results folder, replaced if there; results/demo when not given")
        ->type_name("DIR");
}

Commands add_commands(CLI::App& program)
{
    Commands commands;
    add_run(program, commands);
    add_check(program, commands);
    add_stability(program, commands);
    add_new(program, commands);
    add_element(program, commands);
    add_keys(program, commands);
    add_probe(program, commands);
    add_picture(program, commands);
    add_figures(program, commands);
    add_demo(program, commands);
    add_verify(program, commands);
    add_bench(program, commands);
    commands.push_back({program.add_subcommand("version", "Print the version"), print_version});
    program.set_version_flag("--version", version_text(), "Print the version");
    return commands;
}

std::string hint_for(const std::string& word, const std::vector<std::string>& names)
{
    const std::string nearest = nearest_name(word, names);
    return nearest.empty() ? "" : "\nhint: did you mean " + nearest + "?";
}

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// The command line's first word must be a command.
void require_command(const std::string& word, const Commands& commands)
{
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.parser->get_name());
    if (std::find(names.begin(), names.end(), word) != names.end()) return;
    throw InputError("error[command-line]: there is no command '" + word + "'\nexpected: " + joined(names) +
                     hint_for(word, names));
}

/// The command line has words that the command does not know.
[[noreturn]] void refuse_words(const CLI::App& parser, const std::vector<std::string>& words)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : parser.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::string word = words.front().substr(0, words.front().find('='));
    const bool option = word.starts_with("-");
    throw InputError("error[command-line]: " + parser.get_name() + " knows no " +
                     (option ? "option '" : "further word '") + word + "'\nexpected: " +
                     (option ? joined(names) : "quicksand " + parser.get_name() + " --help shows its form") +
                     (option ? hint_for(word, names) : ""));
}

const Command* chosen(const Commands& commands)
{
    for (const Command& command : commands) {
        if (command.parser->parsed()) return &command;
    }
    return nullptr;
}

/// Parse; true when the line was a question that has been answered, such as --help.
bool parse(CLI::App& program, const Commands& commands, int argument_count, char** arguments)
{
    try {
        program.parse(argument_count, arguments);
    } catch (const CLI::Success& question) {
        program.exit(question);
        return true;
    } catch (const CLI::ParseError& error) {
        const Command* command = chosen(commands);
        const std::vector<std::string> unknown = program.remaining(true);
        const CLI::App& parser = command ? *command->parser : program;
        if (!unknown.empty()) refuse_words(parser, unknown);
        throw InputError(std::string("error[command-line]: ") + error.what() + "\nhint: quicksand " +
                         (command ? parser.get_name() + " " : "") + "--help shows what is allowed");
    }
    return false;
}

} // namespace

ExitCode execute_command_line(int argument_count, char** arguments)
{
    CLI::App program(description, "quicksand");
    program.footer(footer);
    program.get_formatter()->column_width(36);
    const Commands commands = add_commands(program);
    if (argument_count > 1 && arguments[1][0] != '-') require_command(arguments[1], commands);
    if (parse(program, commands, argument_count, arguments)) return ExitCode::good;
    if (const Command* command = chosen(commands)) return command->execute();
    std::cout << program.help();
    return ExitCode::good;
}

} // namespace quicksand
