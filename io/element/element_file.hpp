// Reading a file of element tests: TOML text to a checked programme, by the key table of element_keys.hpp.
#pragma once

#include "io/element/element_programme.hpp"
#include "io/scene/scene_file.hpp"

#include <optional>
#include <string_view>

namespace quicksand {

struct ElementReading {
    ElementProgramme programme;
    std::vector<ResolvedKey> keys;
    Diagnostics warnings;
};

/// Read a file of tests; every `--set path=value` of `overrides` replaces a key first.
/// Throws InputError with all errors at once.
ElementReading read_element_file(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides);

/// The criterion of a word of tests.*.criterion; none of another word.
std::optional<LiquefactionCriterion> find_criterion(std::string_view word);

} // namespace quicksand
