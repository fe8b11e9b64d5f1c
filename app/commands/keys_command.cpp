#include "app/commands/commands.hpp"
#include "io/element/element_keys.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/results/results_reference.hpp"
#include "solver/base/failure.hpp"

#include <iostream>

namespace quicksand {

namespace {

ExitCode list_results(const KeysChoice& choice)
{
    const std::string text = choice.markdown ? results_markdown() : describe_quantities(choice.pattern);
    if (text.empty())
        throw InputError("no quantity of results contains '" + choice.pattern +
                         "'\nhint: quicksand keys --results lists all");
    std::cout << text;
    return ExitCode::good;
}

} // namespace

ExitCode list_keys(const KeysChoice& choice)
{
    if (choice.of_results) return list_results(choice);
    const KeyTable& table = choice.of_element_tests ? element_key_table() : scene_key_table();
    if (choice.markdown) {
        std::cout << keys_markdown(table);
        return ExitCode::good;
    }
    const std::string keys = describe_keys(table, choice.pattern);
    if (keys.empty()) {
        throw InputError("no key of a " + std::string(table.file) + " contains '" + choice.pattern +
                         "'\nhint: quicksand keys" + (choice.of_element_tests ? " --element" : "") +
                         " lists all");
    }
    std::cout << keys;
    return ExitCode::good;
}

} // namespace quicksand
