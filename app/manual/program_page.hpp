// The manual page quicksand(1).
#pragma once

#include <CLI/App.hpp>

#include <string>

namespace quicksand {

/// The page in troff: every command with every option of the parser, exit codes, files, environment,
/// examples.
std::string program_page(CLI::App& program);

} // namespace quicksand
