// What a .geo file would do and which parameters it offers, found in its text before gmsh runs it.
//
// A .geo file is a program that may start other programs and write files; opening one runs it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// The text with comments and the insides of strings turned into blanks; line breaks and length stay.
std::string blank_comments_and_strings(std::string_view text);

/// Names in the file's and its included files' DefineConstant, and those asked for with Exists().
std::vector<std::string> declared_parameters(const std::filesystem::path& file);

/// The file and those that it includes or merges, as far as they are there. Throws InputError.
std::vector<std::filesystem::path> opened_files(const std::filesystem::path& file);

/// Throws InputError where the file, one that it includes or merges, or gmsh options beside them (NAME.opt)
/// would start a program or write a file.
void refuse_side_effects(const std::filesystem::path& file);

/// Throws InputError where a file's last line has no line end: gmsh passes over such a line without a word.
void refuse_unfinished_line(const std::filesystem::path& file);

} // namespace quicksand
