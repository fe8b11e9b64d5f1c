// A page of HTML that needs no other file and no network.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// The text with the characters that HTML gives a meaning, and quotes, as references.
std::string html_text(std::string_view text);

/// A table; the cells are texts, the first row its head.
std::string html_table(const std::vector<std::vector<std::string>>& rows);

/// A section with its heading, which is a text; `body` is HTML.
std::string html_section(std::string_view heading, std::string_view body);

/// Text as it stands in a file, behind a line that opens it.
std::string html_source(std::string_view summary, std::string_view text);

/// A PNG file within the page, with its caption. Throws FileError.
std::string html_picture(const std::filesystem::path& png, std::string_view caption);

/// Pictures one at a time, chosen by a slider, each with its caption; the last is shown at first, and without
/// scripts. Throws FileError.
std::string html_animation(const std::vector<std::filesystem::path>& pngs,
                           const std::vector<std::string>& captions);

/// The page around its sections.
std::string html_page(std::string_view title, std::string_view body);

} // namespace quicksand
