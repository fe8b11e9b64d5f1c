// The words of scene keys and what they stand for in the solver.
#pragma once

#include "solver/base/failure.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace quicksand {

template <class Word, std::size_t count>
using WordList = std::array<std::pair<std::string_view, Word>, count>;

/// What a checked word stands for; the first where the file has an error in its place. A word that the list
/// lacks although its row has it is a program bug and throws InternalError.
template <class Word, std::size_t count>
Word word_of(const WordList<Word, count>& words, const std::string& text)
{
    for (const auto& [name, word] : words) {
        if (name == text) return word;
    }
    if (!text.empty()) throw InternalError("the word " + text + " stands for nothing");
    return words.front().second;
}

/// Whether the word is in the list.
bool contains(const auto& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace quicksand
