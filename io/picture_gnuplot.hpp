// gnuplot as a child process.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

/// Run a script and wait for its end. Throws FileError naming `picture` where gnuplot is missing, or fails,
/// then with its last words.
void run_gnuplot(const std::string& script, const std::filesystem::path& picture);

} // namespace quicksand
