// The examples that come with the program, in the source tree or where it is installed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// Names of the examples.
std::vector<std::string> example_names();

/// Folder of an example with its scene.toml and drawing. Throws FileError when the installation lacks it.
std::filesystem::path example_folder(const std::string& name);

/// Names of the problems below examples/verification, sorted. Throws FileError when there are none.
std::vector<std::string> verification_names();

} // namespace quicksand
