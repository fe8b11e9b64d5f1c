#include "app/commands.hpp"
#include "io/run_manifest.hpp"

#include <iostream>

namespace quicksand {

ExitCode print_version()
{
    std::cout << "Quicksand " << program_version() << '\n';
    return ExitCode::good;
}

} // namespace quicksand
