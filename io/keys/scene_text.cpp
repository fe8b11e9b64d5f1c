#include "io/keys/scene_text.hpp"

#include "geometry/drawing/text_file.hpp"
#include "solver/base/failure.hpp"

#include <array>
#include <cstdint>
#include <system_error>

namespace quicksand {

namespace {

constexpr std::uintmax_t largest_file = 64ULL << 20U; // [byte]

/// Bytes of the UTF-8 character at the start of the text; 0 when it is none.
std::size_t character_length(std::string_view text)
{
    const auto byte = [&](std::size_t k) {
        return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
    };
    const auto follows = [&](std::size_t k) { return (byte(k) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80U) return 1;
    if (first >= 0xC2U && first < 0xE0U) return follows(1) ? 2 : 0;
    if (first >= 0xE0U && first < 0xF0U) {
        const bool overlong = first == 0xE0U && second < 0xA0U, surrogate = first == 0xEDU && second >= 0xA0U;
        return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0U && first < 0xF5U) {
        const bool overlong = first == 0xF0U && second < 0x90U, beyond = first == 0xF4U && second >= 0x90U;
        return follows(1) && follows(2) && follows(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

/// Follows the quotes and comments of a TOML text, character by character.
class QuoteTracker {
public:
    bool outside() const { return !in_comment_ && delimiter_.empty(); }

    /// Take the text's first character in; the number of bytes taken.
    std::size_t advance(std::string_view text, std::size_t length)
    {
        const char c = text[0];
        if (in_comment_) {
            in_comment_ = c != '\n';
            return length;
        }
        if (delimiter_.empty()) return open(text, length);
        if (delimiter_[0] == '"' && c == '\\' && text.size() > 1 &&
            static_cast<unsigned char>(text[1]) < 0x80U && text[1] != '\n') {
            return 2;
        }
        if (text.starts_with(delimiter_)) {
            const std::size_t taken = delimiter_.size();
            delimiter_ = {};
            return taken;
        }
        if (c == '\n' && delimiter_.size() == 1) delimiter_ = {};
        return length;
    }

private:
    std::size_t open(std::string_view text, std::size_t length)
    {
        in_comment_ = text[0] == '#';
        for (const std::string_view mark : {"\"\"\"", "'''", "\"", "'"}) {
            if (!text.starts_with(mark)) continue;
            delimiter_ = mark;
            return mark.size();
        }
        return length;
    }

    bool in_comment_ = false;
    std::string_view delimiter_; // of the open quotes, empty outside
};

std::string advice_on(std::string_view character)
{
    if (character == "\u201c" || character == "\u201d" || character == "\u201e" || character == "\u2019") {
        return "typographic quotes are no quotes here: use \"";
    }
    if (character == "\u2212" || character == "\u2013") return "use the plain minus sign -";
    if (character == "\u00a0") return "use a plain space";
    return "put names with such characters in quotes";
}

} // namespace

std::optional<std::string> read_text_file(const std::filesystem::path& file, const SourcePlace& place,
                                          Diagnostics& findings)
{
    const auto refuse = [&](const std::string& what, const std::string& hint) {
        const std::string subject = place.line > 0 ? "'" + file.string() + "' " : "";
        findings.add(error_at(place, "file", subject + what, "", hint));
        return std::nullopt;
    };
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return refuse("does not exist",
                      place.line > 0 ? "the path is relative to the file that names it" : "");
    }
    if (std::filesystem::is_directory(status)) return refuse("is a folder, not a file", "name a file in it");
    if (!std::filesystem::is_regular_file(status)) return refuse("is not a regular file", "");
    if (std::filesystem::file_size(file, error) > largest_file)
        return refuse("is larger than 64 MiB", "is it the right file?");
    std::string text;
    try {
        text = read_text(file);
    } catch (const FileError&) {
        return refuse("cannot be read", "check its permissions");
    }
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        return refuse("is UTF-16 text", "save it as UTF-8");
    }
    if (text.find('\0') != std::string::npos) return refuse("is not a text file", "is it the right file?");
    return text;
}

void check_characters(const std::filesystem::path& file, std::string_view text, Diagnostics& findings)
{
    SourcePlace place{file, 1, 1};
    QuoteTracker quotes;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            findings.add(error_at(place, "encoding", "this is not UTF-8 text", "", "save the file as UTF-8"));
            return;
        }
        if (length > 1 && quotes.outside()) {
            const auto character = text.substr(0, length);
            findings.add(error_at(place, "syntax",
                                  "the character '" + std::string(character) +
                                      "' is allowed in quotes and comments only",
                                  "", advice_on(character)));
        }
        const std::size_t taken = quotes.advance(text, length);
        place.column += taken > length ? static_cast<int>(taken) : 1;
        if (text[0] == '\n') {
            ++place.line;
            place.column = 1;
        }
        text.remove_prefix(taken);
    }
}

} // namespace quicksand
