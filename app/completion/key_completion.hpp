// The keys that can follow --set.
#pragma once

#include "app/completion/candidate.hpp"
#include "io/keys/scene_schema.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// Keys one level below the tables that `word` names, a table with a dot and a key with an equals sign at its
/// end; behind the equals sign the words that the key allows. Names of the user's are those of `file`, which
/// may be empty.
std::vector<Candidate> key_candidates(const KeyTable& table, const std::filesystem::path& file,
                                      const std::string& word);

} // namespace quicksand
