// The reference of results: every file, array and column that commands write.
#pragma once

#include <string>
#include <string_view>

namespace quicksand {

/// As Markdown: io/RESULTS.md.
std::string results_markdown();

/// The quantities whose name, column or meaning contains the text, a paragraph each; "" without any.
std::string describe_quantities(std::string_view pattern);

} // namespace quicksand
