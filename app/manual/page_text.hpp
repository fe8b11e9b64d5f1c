// The parts of a manual page in the man macros of troff.
#pragma once

#include <string>
#include <string_view>

namespace quicksand {

/// Text with every character that troff would take for an instruction, or draw otherwise, guarded.
std::string plain(std::string_view text);
std::string bold(std::string_view text);
std::string italic(std::string_view text);

/// The first lines of a page, with its section NAME. `part` is the manual's: 1 commands, 5 files.
std::string page_head(const std::string& name, int part, std::string_view about);

std::string section(std::string_view title);
std::string subsection(std::string_view title);

/// Text that goes on below the title of its section, or after `next_paragraph`.
std::string line(std::string_view text);
std::string next_paragraph();

/// An entry with an indented explanation; `term` and `text` are already guarded.
std::string entry(const std::string& term, const std::string& text);

} // namespace quicksand
