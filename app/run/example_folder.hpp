// The examples that come with the program, in the source tree or where it is installed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace quicksand {

/// An example that new scenes start from.
struct ExampleKind {
    std::string word;               // after `new`
    std::string folder;             // in examples/
    std::string drawing;            // in the folder, which its scene.toml names
    std::vector<std::string> files; // that come with them
};

const std::vector<ExampleKind>& example_kinds();

/// Their words.
std::vector<std::string> example_names();

/// Folder of an example with its scene.toml and drawing. Throws FileError when the installation lacks it.
std::filesystem::path example_folder(const std::string& name);

/// Names of the problems below examples/verification, sorted. Throws FileError when there are none.
std::vector<std::string> verification_names();

} // namespace quicksand
