// From the words of the command line to a command and its exit code.
#pragma once

#include "app/run/choices.hpp"

namespace quicksand {

/// Parse and do the command. Throws what the command throws; a mistake in the command line itself is an
/// InputError that says what is allowed.
ExitCode execute_command_line(int argument_count, char** arguments);

} // namespace quicksand
