// What can stand at the end of an unfinished command line.
#pragma once

#include "app/completion/candidate.hpp"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace quicksand {

/// Names in the file system that the shell itself offers besides the candidates.
enum class FileCandidates { none, all, folders, scenes };

struct Completion {
    std::vector<Candidate> candidates;
    FileCandidates files = FileCandidates::none;
};

/// What may take the place of the last of `words`, which may be empty; the program's name is not among them.
/// Throws FileError where it would offer the names of examples that are not installed.
Completion complete(CLI::App& program, const std::vector<std::string>& words);

/// The answer to a shell's script: none, all, folders or scenes in the first line; in each further one a word
/// and, behind a tabulator, what it is about.
std::string answer_text(const Completion& completion);

} // namespace quicksand
