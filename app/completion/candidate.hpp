// A word that a shell may offer.
#pragma once

#include <string>

namespace quicksand {

struct Candidate {
    std::string word;
    std::string about; // one line, may be empty
};

} // namespace quicksand
