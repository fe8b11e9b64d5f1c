// gnuplot as a child process.
#pragma once

#include <filesystem>
#include <string>

namespace quicksand {

/// Run a script and wait for its end. Throws FileError naming `picture` where gnuplot is missing, or fails,
/// then with its last words.
void run_gnuplot(const std::string& script, const std::filesystem::path& picture);

/// Text in gnuplot's single quotes, on one line.
std::string gnuplot_text(const std::string& text);

/// "NaN" leaves a gap.
std::string gnuplot_number(double value);

} // namespace quicksand
