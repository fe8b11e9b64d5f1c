// Letters without capitals, for names that the user may write either way.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace quicksand {

/// The text with its capitals of ASCII made small.
inline std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace quicksand
