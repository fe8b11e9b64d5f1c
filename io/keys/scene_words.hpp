// The words of scene keys and what they stand for in the solver.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace quicksand {

template <class Word, std::size_t count>
using WordList = std::array<std::pair<std::string_view, Word>, count>;

/// What a checked word stands for.
template <class Word, std::size_t count>
Word word_of(const WordList<Word, count>& words, const std::string& text)
{
    for (const auto& [name, word] : words) {
        if (name == text) return word;
    }
    return words.front().second;
}

} // namespace quicksand
