#include "io/motions/peer_record.hpp"

#include "io/keys/scene_units.hpp"
#include "io/motions/record_limits.hpp"
#include "io/motions/record_unit.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace quicksand {

namespace {

constexpr std::size_t longest_header = 12;       // lines in which the count may stand [-]
constexpr std::int64_t most_values = 10'000'000; // of a record [-]
constexpr std::string_view blanks = " \t\r";

std::string upper_case(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

/// The lines without their ends, be these LF, CR LF or CR CR LF.
std::vector<std::string_view> split_lines(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        while (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
    }
    return lines;
}

/// A part of a line that is to be a number.
struct Word {
    std::string_view text;
    std::size_t column = 0; // from 0
};

/// The next word at or after `from`: up to a blank or a comma. Empty at the end of the line.
Word next_word(std::string_view line, std::size_t from)
{
    const std::size_t begin = std::min(line.find_first_not_of(blanks, from), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t\r,", begin), line.size());
    return {line.substr(begin, end - begin), begin};
}

std::optional<double> number_of(std::string_view text)
{
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

class PeerReader {
public:
    PeerReader(const std::filesystem::path& file, std::string_view text, Diagnostics& findings)
        : file_(file), text_(text), lines_(split_lines(text)), findings_(findings)
    {
    }

    std::optional<PeerRecord> read();

private:
    bool read_unit();
    bool read_count_and_interval();
    bool read_values();
    bool refuse(std::size_t line, const Word& word, std::string what, std::string expected = "",
                std::string hint = "");

    const std::filesystem::path& file_;
    std::string_view text_;
    std::vector<std::string_view> lines_;
    Diagnostics& findings_;
    PeerRecord record_;
    std::size_t count_line_ = 0; // of the number of values, from 0
    Word count_word_;
    std::int64_t count_ = 0; // of values, as the header says [-]
};

bool PeerReader::refuse(std::size_t line, const Word& word, std::string what, std::string expected,
                        std::string hint)
{
    const SourcePlace place{file_, static_cast<int>(line) + 1, static_cast<int>(word.column) + 1,
                            std::max(static_cast<int>(word.text.size()), 1)};
    findings_.keep_text(file_, text_);
    findings_.add(error_at(place, "record", std::move(what), std::move(expected), std::move(hint)));
    return false;
}

bool PeerReader::read_count_and_interval()
{
    constexpr const char* forms = "`NPTS=  4000, DT= .01000 SEC` or `4096  0.0100  NPTS, DT`";
    const std::size_t last = std::min(lines_.size(), longest_header);
    std::size_t line = 0;
    while (line < last && upper_case(lines_[line]).find("NPTS") == std::string::npos) ++line;
    if (line == last)
        return refuse(0, {}, "the header has no line with the number of values and their interval", forms,
                      "or give the record as two columns: time in s, acceleration");
    const std::string header = upper_case(lines_[line]);
    const auto after = [&](std::string_view name) {
        const std::size_t equals = header.find('=', header.find(name));
        return next_word(lines_[line], equals == std::string::npos ? header.size() : equals + 1);
    };
    Word interval_word;
    if (header.find('=') != std::string::npos) {
        count_word_ = after("NPTS");
        if (header.find("DT") != std::string::npos) interval_word = after("DT");
    } else {
        count_word_ = next_word(lines_[line], 0);
        interval_word = next_word(lines_[line], count_word_.column + count_word_.text.size());
    }
    count_line_ = line;
    const auto count = number_of(count_word_.text), interval = number_of(interval_word.text);
    if (!count || *count != std::floor(*count) || *count < 2.0 || *count > static_cast<double>(most_values))
        return refuse(line, count_word_, "the number of values is no whole number of 2 or more", forms);
    if (!interval || *interval <= 0.0)
        return refuse(line, interval_word, "the interval is no number of seconds above 0", forms);
    if (*interval > longest_interval)
        return refuse(line, interval_word,
                      "an interval of " + number_text(*interval) + " s is not that of an earthquake's record",
                      "at most " + number_text(longest_interval) + " s");
    count_ = static_cast<std::int64_t>(*count);
    record_.interval = *interval;
    return true;
}

bool PeerReader::read_unit()
{
    constexpr std::string_view phrase = "UNITS OF";
    for (std::size_t line = 0; line < count_line_; ++line) {
        const std::string header = upper_case(lines_[line]);
        const std::size_t found = header.find(phrase);
        if (found == std::string::npos) continue;
        if (header.find("VELOCITY") < found || header.find("DISPLACEMENT") < found)
            return refuse(line, next_word(lines_[line], 0), "this is no record of accelerations",
                          "ACCELERATION TIME SERIES IN UNITS OF G", "take the file that ends with .AT2");
        Word word = next_word(lines_[line], found + phrase.size());
        while (word.text.ends_with('.') || word.text.ends_with(';')) word.text.remove_suffix(1);
        record_.unit_name = std::string(word.text);
        if (const auto unit = record_unit(word.text)) record_.unit = unit->value;
        if (record_.unit == 0.0)
            return refuse(line, word, "the unit '" + record_.unit_name + "' is not known",
                          "UNITS OF G, of CM/S/S or of M/S/S");
        return true;
    }
    return refuse(count_line_, {}, "no line above states the unit of the values",
                  "a line with UNITS OF G, of CM/S/S or of M/S/S",
                  "or give the record as two columns and its unit as motion.unit");
}

bool PeerReader::read_values()
{
    record_.accelerations.reserve(static_cast<std::size_t>(count_));
    for (std::size_t line = count_line_ + 1; line < lines_.size(); ++line) {
        Word word = next_word(lines_[line], 0);
        while (!word.text.empty()) {
            const auto value = number_of(word.text);
            if (!value)
                return refuse(line, word, "'" + std::string(word.text.substr(0, 40)) + "' is no number",
                              "the values only, separated by blanks");
            if (!(std::abs(record_.unit * *value) <= largest_acceleration))
                return refuse(line, word,
                              "no earthquake has an acceleration of " + number_text(*value) + ' ' +
                                  record_.unit_name,
                              allowed_accelerations);
            record_.accelerations.push_back(record_.unit * *value);
            word = next_word(lines_[line], word.column + word.text.size());
        }
        if (word.column < lines_[line].size()) // stopped at a comma
            return refuse(line, {lines_[line].substr(word.column, 1), word.column},
                          "a comma among the values", "the values only, separated by blanks");
    }
    const auto held = static_cast<std::int64_t>(record_.accelerations.size());
    if (held == count_) return true;
    return refuse(count_line_, count_word_,
                  "the header says " + std::to_string(count_) + " values, the file holds " +
                      std::to_string(held),
                  "", held < count_ ? "is the file complete?" : "is more than one record in the file?");
}

std::optional<PeerRecord> PeerReader::read()
{
    if (!read_count_and_interval() || !read_unit() || !read_values()) return std::nullopt;
    return std::move(record_);
}

} // namespace

bool is_peer_record(const std::filesystem::path& file, std::string_view text)
{
    if (upper_case(file.extension().string()) == ".AT2") return true;
    std::size_t line = 0;
    while (!text.empty() && line++ < longest_header) {
        const std::size_t end = text.find('\n');
        const std::string header = upper_case(text.substr(0, end));
        if (header.find("NPTS") != std::string::npos && header.find("DT") != std::string::npos) return true;
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return false;
}

std::optional<PeerRecord> parse_peer_record(const std::filesystem::path& file, std::string_view text,
                                            Diagnostics& findings)
{
    return PeerReader(file, text, findings).read();
}

} // namespace quicksand
