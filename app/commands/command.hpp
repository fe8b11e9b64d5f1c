// The commands of the program: what their words are, and what they do.
#pragma once

#include "app/run/choices.hpp"

#include <CLI/App.hpp>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

/// A command's parser and what to do once it has been parsed.
struct Command {
    CLI::App* parser = nullptr;
    std::function<ExitCode()> execute;
};

using Commands = std::vector<Command>;

/// A parser of the program's own. Its making compiles much of the library: here once, not in every source.
CLI::App* add_parser(CLI::App& program, const char* name, const char* about);

template <class Choice>
using Execute = ExitCode (*)(const Choice&);

/// Give the program a command; the returned choice is filled when the command line is parsed.
template <class Choice>
std::pair<CLI::App*, std::shared_ptr<Choice>> add_command(CLI::App& program, Commands& commands,
                                                          const char* name, const char* about,
                                                          Execute<Choice> execute)
{
    CLI::App* parser = add_parser(program, name, about);
    auto choice = std::make_shared<Choice>();
    commands.push_back({parser, [choice, execute] { return execute(*choice); }});
    return {parser, choice};
}

void add_threads(CLI::App& parser, int& threads);
void add_overrides(CLI::App& parser, std::vector<std::string>& overrides,
                   const std::string& about = "Replace a key of the scene: --set motion.amplitude=\"0.2 g\"");

/// Scenes: run, sweep, check, stability, new, element, motion, validity, calibrate.
void add_scene_commands(CLI::App& program, Commands& commands);

/// Results: probe, picture, figures, compare, report.
void add_results_commands(CLI::App& program, Commands& commands);

/// The program itself: demo, verify, bench, stress.
void add_measuring_commands(CLI::App& program, Commands& commands);

/// Commands about the program itself: keys, manual, version.
void add_reference_commands(CLI::App& program, Commands& commands);

} // namespace quicksand
