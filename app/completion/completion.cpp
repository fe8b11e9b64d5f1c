#include "app/completion/completion.hpp"

#include "app/completion/key_completion.hpp"
#include "app/manual/option_value.hpp"
#include "app/run/example_folder.hpp"
#include "app/stress/scenes/designed_set.hpp"
#include "io/element/element_keys.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

/// A command's words before the cursor.
struct LineReading {
    std::vector<std::string> positionals;
    std::set<CLI::Option*> given;
    CLI::Option* awaiting = nullptr; // the option whose value stands at the cursor
};

std::vector<CLI::App*> commands_of(CLI::App& program)
{
    return program.get_subcommands([](CLI::App*) { return true; });
}

bool takes_value(const CLI::Option& option)
{
    return option.get_items_expected_max() > 0;
}

LineReading read_line(CLI::App& command, const std::vector<std::string>& words)
{
    LineReading line;
    for (const std::string& word : words) {
        if (std::exchange(line.awaiting, nullptr) != nullptr) continue;
        const auto equals = word.find('=');
        CLI::Option* option =
            word.starts_with('-') ? command.get_option_no_throw(word.substr(0, equals)) : nullptr;
        if (option == nullptr) {
            line.positionals.push_back(word);
            continue;
        }
        line.given.insert(option);
        if (takes_value(*option) && equals == std::string::npos) line.awaiting = option;
    }
    return line;
}

std::vector<CLI::Option*> positionals_of(CLI::App& command)
{
    return command.get_options([](CLI::Option* option) { return option->get_positional(); });
}

/// The positional that the word of this number is given to; null when there is none.
CLI::Option* positional_at(CLI::App& command, std::size_t number)
{
    const std::vector<CLI::Option*> positionals = positionals_of(command);
    if (number < positionals.size()) return positionals[number];
    const bool repeats = !positionals.empty() && positionals.back()->get_items_expected_max() > 1;
    return repeats ? positionals.back() : nullptr;
}

bool is_element_command(CLI::App& command)
{
    const std::vector<CLI::Option*> positionals = positionals_of(command);
    return !positionals.empty() && positionals.front()->get_name(true) == "TEST";
}

/// The file whose keys --set replaces: the first word that is one, or a folder with such a file.
fs::path key_file(const LineReading& line, const char* usual_name)
{
    for (const fs::path word : line.positionals) {
        if (fs::is_regular_file(word)) return word;
        if (fs::is_regular_file(word / usual_name)) return word / usual_name;
    }
    return {};
}

std::vector<Candidate> candidates_of(const std::vector<std::string>& words)
{
    std::vector<Candidate> candidates;
    for (const std::string& word : words) candidates.push_back({word, ""});
    return candidates;
}

/// What an option or positional may be given.
Completion complete_value(CLI::App& command, CLI::Option& option, const LineReading& line,
                          const std::string& word)
{
    const OptionValue value = value_of(option);
    const auto is_one_of = [&value](const std::initializer_list<const char*>& names) {
        return std::find(names.begin(), names.end(), value.name) != names.end();
    };
    if (!value.words.empty()) return {candidates_of(value.words)};
    if (value.name == "KEY=VALUE") {
        return is_element_command(command)
                   ? Completion{key_candidates(element_key_table(), key_file(line, "test.toml"), word)}
                   : Completion{key_candidates(scene_key_table(), key_file(line, "scene.toml"), word)};
    }
    if (is_one_of({"ROWS", "ROW"})) return {candidates_of(stress_groups())};
    if (value.name == "KIND") return {candidates_of(example_names())};
    if (is_one_of({"PROBLEM", "WORDS"})) return {candidates_of(verification_names()), FileCandidates::scenes};
    if (is_one_of({"SCENE", "SWEEP", "TEST", "SOURCE"})) return {{}, FileCandidates::scenes};
    if (is_one_of({"DIR", "RESULTS"})) return {{}, FileCandidates::folders};
    if (value.name == "FILE") return {{}, FileCandidates::all};
    return {};
}

/// Options that may still be given.
Completion complete_option(CLI::App& command, const LineReading& line)
{
    Completion completion;
    for (CLI::Option* option : command.get_options()) {
        if (line.given.contains(option) && option->get_items_expected_max() <= 1) continue;
        for (const std::string& name : option->get_lnames())
            completion.candidates.push_back({"--" + name, option->get_description()});
    }
    return completion;
}

Completion complete_command(CLI::App& program, const std::string& word)
{
    if (word.starts_with('-')) return complete_option(program, {});
    Completion completion;
    for (const CLI::App* command : commands_of(program))
        completion.candidates.push_back({command->get_name(), command->get_description()});
    return completion;
}

/// For --output=DIR: the value's candidates with the option before them.
Completion complete_joined(CLI::App& command, const LineReading& line, const std::string& word)
{
    const auto equals = word.find('=');
    CLI::Option* option = command.get_option_no_throw(word.substr(0, equals));
    if (option == nullptr || !takes_value(*option)) return {};
    Completion completion = complete_value(command, *option, line, word.substr(equals + 1));
    for (Candidate& candidate : completion.candidates)
        candidate.word = word.substr(0, equals + 1) + candidate.word;
    return completion;
}

Completion complete_word(CLI::App& command, const LineReading& line, const std::string& word)
{
    if (line.awaiting != nullptr) return complete_value(command, *line.awaiting, line, word);
    if (word.starts_with("--") && word.find('=') != std::string::npos)
        return complete_joined(command, line, word);
    if (word.starts_with('-')) return complete_option(command, line);
    CLI::Option* positional = positional_at(command, line.positionals.size());
    return positional == nullptr ? complete_option(command, line)
                                 : complete_value(command, *positional, line, word);
}

} // namespace

Completion complete(CLI::App& program, const std::vector<std::string>& words)
{
    if (words.empty()) return complete(program, {""});
    const std::string& word = words.back();
    Completion completion;
    if (words.size() == 1) completion = complete_command(program, word);
    for (CLI::App* command : commands_of(program)) {
        if (words.size() == 1 || command->get_name() != words.front()) continue;
        const LineReading line = read_line(*command, {words.begin() + 1, words.end() - 1});
        completion = complete_word(*command, line, word);
    }
    std::erase_if(completion.candidates,
                  [&word](const Candidate& candidate) { return !candidate.word.starts_with(word); });
    return completion;
}

std::string answer_text(const Completion& completion)
{
    constexpr std::array names = {"none", "all", "folders", "scenes"};
    std::string text = std::string(names[static_cast<std::size_t>(completion.files)]) + "\n";
    for (const Candidate& candidate : completion.candidates) {
        text += candidate.word + (candidate.about.empty() ? "" : "\t" + candidate.about) + "\n";
    }
    return text;
}

} // namespace quicksand
