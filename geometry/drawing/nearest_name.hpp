// The name that a user may have meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// The name nearest to `name` within edit distance 3 (and a third of its length), "" when there is none.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

} // namespace quicksand
