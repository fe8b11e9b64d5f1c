// A name in a file of results and what it stands for.
#pragma once

#include <string_view>

namespace quicksand {

struct DocumentedName {
    std::string_view name, meaning;
};

} // namespace quicksand
