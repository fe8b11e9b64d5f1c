#include "app/commands.hpp"
#include "io/scene_schema.hpp"
#include "solver/failure.hpp"

#include <iostream>

namespace quicksand {

ExitCode list_keys(const KeysChoice& choice)
{
    if (choice.markdown) {
        std::cout << keys_markdown(scene_key_table());
        return ExitCode::good;
    }
    const std::string keys = describe_keys(scene_key_table(), choice.pattern);
    if (keys.empty()) {
        throw InputError("no key of a scene contains '" + choice.pattern +
                         "'\nhint: quicksand keys lists all");
    }
    std::cout << keys;
    return ExitCode::good;
}

} // namespace quicksand
