// Where in a text file something stands.
#pragma once

#include <filesystem>

namespace quicksand {

/// Place of a value in a text file, 1-based. Line 0 when it is not in the file: then `file` still says where
/// to look, for a value of the command line as --set 'text'.
struct SourcePlace {
    std::filesystem::path file;
    int line = 0;
    int column = 0;
    int width = 1; // of the text to mark [characters]
};

} // namespace quicksand
