#include "app/commands/command.hpp"
#include "app/commands/commands.hpp"
#include "app/manual/key_page.hpp"
#include "app/manual/program_page.hpp"
#include "io/element/element_keys.hpp"

#include <iostream>

namespace quicksand {

namespace {

ExitCode print_manual(CLI::App& program, const std::string& page)
{
    if (page == "quicksand-scene") {
        std::cout << key_page(page, scene_key_table());
    } else if (page == "quicksand-element") {
        std::cout << key_page(page, element_key_table());
    } else {
        std::cout << program_page(program);
    }
    return ExitCode::good;
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

void add_manual(CLI::App& program, Commands& commands)
{
    CLI::App* parser =
        program.add_subcommand("manual", "Print a manual page, to read with: quicksand manual | man -l -");
    auto page = std::make_shared<std::string>("quicksand");
    parser
        ->add_option(
            "PAGE", *page,
            "quicksand: the commands; quicksand-scene: the keys of a scene; quicksand-element: the keys of "
            "element tests")
        ->check(CLI::IsMember({"quicksand", "quicksand-scene", "quicksand-element"}))
        ->capture_default_str();
    commands.push_back({parser, [&program, page] { return print_manual(program, *page); }});
}

void add_version(CLI::App& program, Commands& commands)
{
    commands.push_back({program.add_subcommand("version", "Print the version"), print_version});
    program.set_version_flag("--version", version_text(), "Print the version");
}

} // namespace

void add_reference_commands(CLI::App& program, Commands& commands)
{
    add_keys(program, commands);
    add_manual(program, commands);
    add_version(program, commands);
}

} // namespace quicksand
