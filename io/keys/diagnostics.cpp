#include "io/keys/diagnostics.hpp"

#include "solver/base/failure.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <tuple>

namespace quicksand {

namespace {

constexpr int most_errors = 20;
constexpr int most_warnings_of_a_kind = 5;
constexpr std::size_t longest_quote = 96; // of a source line [characters]

std::string_view line_of(std::string_view source, int number)
{
    for (int line = 1; line < number; ++line) {
        const auto end = source.find('\n');
        if (end == std::string_view::npos) return {};
        source.remove_prefix(end + 1);
    }
    source = source.substr(0, source.find('\n'));
    if (source.ends_with('\r')) source.remove_suffix(1);
    return source;
}

/// Cut UTF-8 text into characters; a stray byte counts as one.
std::vector<std::string_view> characters(std::string_view text)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        std::size_t length = 1;
        while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
        parts.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return parts;
}

/// As it may be shown on a terminal: control characters as blanks, stray bytes as question marks.
std::string_view printable(std::string_view character)
{
    const auto byte = static_cast<unsigned char>(character[0]);
    if (character.size() == 1 && byte >= 0x80U) return "?";
    return character.size() == 1 && (byte < 0x20U || byte == 0x7FU) ? std::string_view(" ") : character;
}

/// The source line and the caret below it; a long line is cut to the neighbourhood of the mark.
std::string quote(std::string_view line, const SourcePlace& place)
{
    const auto all = characters(line);
    const auto column = std::min(static_cast<std::size_t>(std::max(place.column, 1)) - 1, all.size());
    const std::size_t first = column + 24 > longest_quote ? column - longest_quote / 2 : 0;
    const std::size_t last = std::min(all.size(), first + longest_quote);
    const auto width = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(place.width, 1)), 1,
                                               std::max<std::size_t>(last - std::min(column, last), 1));
    std::string shown = first > 0 ? "..." : "", padding(shown.size(), ' ');
    for (std::size_t k = first; k < last; ++k) {
        shown += printable(all[k]);
        if (k < column) padding += ' ';
    }
    if (last < all.size()) shown += "...";
    std::string number = std::to_string(place.line);
    number.insert(0, number.size() < 5 ? 5 - number.size() : 0, ' ');
    return number + " | " + shown + "\n" + std::string(number.size(), ' ') + " | " + padding + "^" +
           std::string(width - 1, '~') + "\n";
}

void render_finding(const Diagnostic& finding, std::string_view source, const std::string& file,
                    std::ostream& text)
{
    const SourcePlace& place = finding.place;
    text << place.file.string();
    if (place.line > 0) text << ':' << place.line << ':' << place.column;
    text << (finding.severity == Severity::error ? ": error[" : ": warning[") << finding.kind
         << "]: " << finding.what << '\n';
    if (place.line > 0 && !source.empty()) text << quote(line_of(source, place.line), place);
    if (!finding.expected.empty()) text << "expected: " << finding.expected << '\n';
    if (!finding.hint.empty()) text << "hint: " << finding.hint << '\n';
    if (finding.severity == Severity::warning && !finding.key.empty()) {
        const char quote_mark = finding.key.find('"') == std::string::npos ? '"' : '\'';
        text << "to accept it: accept = [" << quote_mark << finding.key << quote_mark
             << "] at the top of the " << file << '\n';
    }
}

std::string count_of(int number, const std::string& thing)
{
    return "... and " + std::to_string(number) + " more " + thing + (number == 1 ? "" : "s");
}

} // namespace

Diagnostic error_at(SourcePlace place, std::string kind, std::string what, std::string expected,
                    std::string hint)
{
    return {Severity::error,
            std::move(kind),
            std::move(place),
            std::move(what),
            std::move(expected),
            std::move(hint),
            ""};
}

Diagnostic warning_at(SourcePlace place, std::string key, std::string kind, std::string what,
                      std::string expected, std::string hint)
{
    return {Severity::warning,   std::move(kind), std::move(place), std::move(what),
            std::move(expected), std::move(hint), std::move(key)};
}

void Diagnostics::add(const Diagnostics& others)
{
    findings_.insert(findings_.end(), others.findings_.begin(), others.findings_.end());
    texts_.insert(others.texts_.begin(), others.texts_.end());
}

void Diagnostics::add_new(const Diagnostic& diagnostic)
{
    const auto is_same = [&](const Diagnostic& other) {
        return other.what == diagnostic.what && other.place.file == diagnostic.place.file &&
               other.place.line == diagnostic.place.line && other.place.column == diagnostic.place.column;
    };
    if (std::none_of(findings_.begin(), findings_.end(), is_same)) add(diagnostic);
}

void Diagnostics::keep_text(const std::filesystem::path& file, std::string_view text)
{
    texts_.emplace(file, text);
}

void Diagnostics::keep_texts_of(const Diagnostics& others)
{
    texts_.insert(others.texts_.begin(), others.texts_.end());
}

void Diagnostics::accept(const std::vector<std::string>& keys)
{
    std::erase_if(findings_, [&](const Diagnostic& finding) {
        return finding.severity == Severity::warning && !finding.key.empty() &&
               std::find(keys.begin(), keys.end(), finding.key) != keys.end();
    });
}

bool Diagnostics::has_errors() const
{
    return std::any_of(findings_.begin(), findings_.end(),
                       [](const Diagnostic& finding) { return finding.severity == Severity::error; });
}

std::string Diagnostics::render(std::string_view source) const
{
    std::vector<const Diagnostic*> order;
    for (const Diagnostic& finding : findings_) order.push_back(&finding);
    const std::filesystem::path of_the_source;
    const auto file_of = [&](const Diagnostic* finding) -> const std::filesystem::path& {
        return texts_.contains(finding->place.file) ? finding->place.file : of_the_source;
    };
    std::stable_sort(order.begin(), order.end(), [&](const Diagnostic* a, const Diagnostic* b) {
        return std::tie(file_of(a), a->place.line, a->place.column) <
               std::tie(file_of(b), b->place.line, b->place.column);
    });

    std::ostringstream text;
    int errors = 0;
    std::map<std::string, int> warnings;
    for (const Diagnostic* finding : order) {
        const bool is_error = finding->severity == Severity::error;
        const int count = is_error ? ++errors : ++warnings[finding->kind];
        if (count <= (is_error ? most_errors : most_warnings_of_a_kind))
            render_finding(*finding, file_of(finding).empty() ? source : texts_.at(finding->place.file),
                           file_, text);
    }
    if (errors > most_errors) text << count_of(errors - most_errors, "error") << '\n';
    for (const auto& [kind, count] : warnings) {
        if (count <= most_warnings_of_a_kind) continue;
        text << count_of(count - most_warnings_of_a_kind, "warning") << " of kind [" << kind << "]\n";
    }
    return text.str();
}

void throw_findings(const Diagnostics& findings, std::string_view source)
{
    std::string message = findings.render(source);
    if (message.ends_with('\n')) message.pop_back();
    throw InputError(message);
}

std::string one_of(const std::vector<std::string>& words)
{
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return words.size() > 1 ? "one of " + list : list;
}

} // namespace quicksand
