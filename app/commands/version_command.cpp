#include "app/commands/commands.hpp"
#include "io/results/run_manifest.hpp"

#include <iostream>

namespace quicksand {

std::string version_text()
{
    return "Quicksand " + program_version();
}

ExitCode print_version()
{
    std::cout << version_text() << '\n';
    return ExitCode::good;
}

} // namespace quicksand
