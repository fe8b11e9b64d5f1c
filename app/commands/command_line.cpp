#include "app/commands/command_line.hpp"

#include "app/commands/command.hpp"
#include "app/completion/completion.hpp"
#include "app/manual/exit_meanings.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/diagnostics.hpp"
#include "solver/base/failure.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <string_view>
#include <vector>

namespace quicksand {

namespace {

constexpr std::string_view completion_word = "complete"; // asked by the shells' scripts, not by users
constexpr const char* description =
    "Quicksand: liquefaction of saturated sand and the deformation of dikes in earthquakes.";

/// The help's last lines.
std::string footer()
{
    std::string text = "Start with:  quicksand demo      (two minutes, then open its files)\n"
                       "             quicksand new dike my_dike\n"
                       "Exit codes:\n";
    for (const ExitMeaning& exit : exit_meanings()) {
        text += "  " + std::to_string(static_cast<int>(exit.code)) + "  " + std::string(exit.meaning) + "\n";
    }
    return text + "Help on a command:  quicksand COMMAND --help";
}

Commands add_commands(CLI::App& program)
{
    Commands commands;
    add_scene_commands(program, commands);
    add_results_commands(program, commands);
    add_measuring_commands(program, commands);
    add_reference_commands(program, commands);
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

/// `help` and `help COMMAND` in the form of an option, as CLI11 knows it.
std::vector<char*> with_help_as_option(int count, char** arguments)
{
    static char option[] = "--help";
    std::vector<char*> words(arguments, arguments + count);
    if (count < 2 || std::string_view(words[1]) != "help") return words;
    words.erase(words.begin() + 1);
    words.push_back(option);
    return words;
}

} // namespace

CLI::App* add_parser(CLI::App& program, const char* name, const char* about)
{
    return program.add_subcommand(name, about);
}

ExitCode execute_command_line(int argument_count, char** arguments)
{
    CLI::App program(description, "quicksand");
    program.footer(footer());
    program.get_formatter()->column_width(36);
    const Commands commands = add_commands(program);
    if (argument_count > 1 && arguments[1] == completion_word) {
        std::cout << answer_text(complete(program, {arguments + 2, arguments + argument_count}));
        return ExitCode::good;
    }
    std::vector<char*> words = with_help_as_option(argument_count, arguments);
    if (words.size() > 1 && words[1][0] != '-') require_command(words[1], commands);
    if (parse(program, commands, static_cast<int>(words.size()), words.data())) return ExitCode::good;
    if (const Command* command = chosen(commands)) return command->execute();
    std::cout << program.help();
    return ExitCode::good;
}

} // namespace quicksand
