#include "geometry/drawing/geo_script.hpp"

#include "geometry/drawing/text_file.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace quicksand {

namespace {

struct Command {
    std::string_view word;
    std::string_view effect;
};

// Printf is looked at apart: it writes a file only when a > follows.
constexpr Command refused_commands[] = {
    {"SystemCall", "starts another program"},
    {"NonBlockingSystemCall", "starts another program"},
    {"System", "starts another program"},
    {"OnelabRun", "starts another program"},
    {"ExternalProcess", "starts another program"},
    {"Plugin", "may write files"},
    {"Parse", "runs text that cannot be looked at beforehand"},
    {"Print", "writes a file"},
    {"Save", "writes a file"},
    {"CreateDir", "makes a folder"},
};

/// A file that gmsh opens.
struct OpenedFile {
    std::filesystem::path file;
    bool may_hold_data = true; // merged; an included one is run whatever it looks like
    std::string named_by;      // how its name stands in front of what is wrong with it
};

/// One .geo file as read, twice: `code` without comments and strings, of the same length.
struct Script {
    std::filesystem::path file;
    std::string text;
    std::string code;

    std::ptrdiff_t line_of(std::size_t at) const
    {
        return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    }
};

bool is_name_character(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// gmsh takes both; the other one may stand within.
bool is_quote(char c)
{
    return c == '"' || c == '\'';
}

std::size_t skip_blanks(const std::string& code, std::size_t at)
{
    while (at < code.size() && std::isspace(static_cast<unsigned char>(code[at]))) ++at;
    return at;
}

/// Positions of a word that stands alone and is not part of an option such as Print.Text.
std::vector<std::size_t> find_word(const std::string& code, std::string_view word)
{
    std::vector<std::size_t> places;
    for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + word.size())) {
        const char before = at > 0 ? code[at - 1] : ' ';
        const std::size_t end = at + word.size();
        const char after = end < code.size() ? code[end] : ' ';
        if (!is_name_character(before) && before != '.' && !is_name_character(after) && after != '.')
            places.push_back(at);
    }
    return places;
}

/// The position after the bracket that closes the one at `open`.
std::size_t skip_brackets(const std::string& code, std::size_t open)
{
    int depth = 0;
    for (std::size_t at = open; at < code.size(); ++at) {
        if (code[at] == '(' || code[at] == '[' || code[at] == '{') ++depth;
        if (code[at] == ')' || code[at] == ']' || code[at] == '}') --depth;
        if (depth == 0) return at + 1;
    }
    return code.size();
}

/// A missing file reads as an empty one: gmsh says so itself, and an If may stand around it.
std::string read_opened(const OpenedFile& opened)
{
    std::error_code ignored;
    if (!std::filesystem::exists(opened.file, ignored)) return "";
    if (!std::filesystem::is_regular_file(opened.file, ignored)) {
        throw InputError(fmt::format("{} is a folder or a device, not a file\n"
                                     "hint: name a file, such as \"layers.geo\"",
                                     opened.named_by));
    }
    return read_text(opened.file);
}

/// The name in quotes after an Include or Merge; none where an expression stands.
std::optional<std::string> quoted_name(const Script& script, std::size_t at)
{
    const std::size_t open = skip_blanks(script.code, at);
    if (open >= script.code.size() || !is_quote(script.code[open])) return std::nullopt;
    const std::size_t close = script.code.find(script.code[open], open + 1);
    const std::size_t end = close == std::string::npos ? close : skip_blanks(script.code, close + 1);
    if (end == std::string::npos || (end < script.code.size() && script.code[end] != ';'))
        return std::nullopt;
    return script.text.substr(open + 1, close - open - 1);
}

/// CAD and mesh files hold data, not commands. gmsh knows these spellings only and runs any other file.
bool holds_data(const Script& script)
{
    constexpr std::string_view data_extensions[] = {
        ".step", ".STEP", ".stp", ".STP", ".iges", ".IGES", ".igs", ".IGS", ".brep", ".brp",
        ".BRP",  ".stl",  ".STL", ".unv", ".UNV",  ".vtk",  ".VTK", ".med", ".MED"};
    const bool is_data = std::count(std::begin(data_extensions), std::end(data_extensions),
                                    script.file.extension().string()) > 0;
    return is_data || script.text.starts_with("$MeshFormat");
}

/// Add the files that a script opens with `word`.
void add_opened(const Script& script, std::string_view word, std::vector<OpenedFile>& waiting)
{
    for (const std::size_t at : find_word(script.code, word)) {
        const std::optional<std::string> name = quoted_name(script, at + word.size());
        const std::string place = fmt::format("{}:{}: {}", script.file.string(), script.line_of(at), word);
        if (name) {
            waiting.push_back({script.file.parent_path() / *name, word != "Include",
                               fmt::format("{} \"{}\"", place, *name)});
        } else if (word != "ShapeFromFile") {
            throw InputError(fmt::format("{} names its file by an expression, which cannot be followed\n"
                                         "hint: write the file's name itself: {} \"layers.geo\";",
                                         place, word));
        }
    }
}

/// The file and everything that it includes or merges, each once; data without its text.
std::vector<Script> read_scripts(const std::filesystem::path& file)
{
    std::vector<Script> scripts;
    std::set<std::pair<std::filesystem::path, bool>> seen;
    // gmsh opens the first file as it opens a merged one
    std::vector<OpenedFile> waiting = {{file, true, file.string()}};
    while (!waiting.empty()) {
        const OpenedFile next = waiting.back();
        waiting.pop_back();
        if (!seen.emplace(next.file.lexically_normal(), next.may_hold_data).second) continue;
        // gmsh runs the options that it finds beside a file
        const std::filesystem::path options = next.file.string() + ".opt";
        std::error_code ignored;
        if (next.may_hold_data && std::filesystem::exists(options, ignored))
            waiting.push_back({options, true, options.string()});
        Script script{next.file, read_opened(next), {}};
        if (next.may_hold_data && holds_data(script)) {
            scripts.push_back({next.file, {}, {}});
            continue;
        }
        script.code = blank_comments_and_strings(script.text);
        for (const std::string_view word : {"Include", "Merge", "MergeWithBoundingBox", "ShapeFromFile"})
            add_opened(script, word, waiting);
        scripts.push_back(std::move(script));
    }
    return scripts;
}

[[noreturn]] void refuse(const Script& script, std::size_t at, std::string_view word, std::string_view effect)
{
    throw InputError(fmt::format("{}:{}: {} {}; Quicksand refuses to open the file\n"
                                 "hint: a section needs geometry only; take the line out",
                                 script.file.string(), script.line_of(at), word, effect));
}

/// gmsh ends a string after 1023 characters, and strings and comments at a zero byte; it would run the rest.
void refuse_broken_strings(const Script& script)
{
    constexpr std::size_t longest_string = 1023;
    if (script.text.find('\0') != std::string::npos)
        throw InputError(fmt::format("{}: is not a text file", script.file.string()));
    std::size_t open = script.code.find_first_of("\"'");
    while (open != std::string::npos) {
        const std::size_t close = std::min(script.code.find(script.code[open], open + 1), script.code.size());
        if (close - open - 1 > longest_string) {
            throw InputError(fmt::format("{}:{}: the string is longer than the {} characters of gmsh\n"
                                         "hint: is its closing quote missing?",
                                         script.file.string(), script.line_of(open), longest_string));
        }
        open = script.code.find_first_of("\"'", close + 1);
    }
}

void refuse_side_effects_of(const Script& script)
{
    refuse_broken_strings(script);
    for (const Command& command : refused_commands) {
        for (const std::size_t at : find_word(script.code, command.word)) {
            const std::size_t next = skip_blanks(script.code, at + command.word.size());
            const bool is_variable = next < script.code.size() && script.code[next] == '=';
            if (!is_variable) refuse(script, at, command.word, command.effect);
        }
    }
    for (const std::size_t at : find_word(script.code, "Printf")) {
        const std::size_t open = skip_blanks(script.code, at + 6);
        const std::size_t next = skip_blanks(script.code, skip_brackets(script.code, open));
        if (next < script.code.size() && script.code[next] == '>')
            refuse(script, at, "Printf with >", "writes a file");
    }
}

/// The name that starts at the first non-blank; empty where none does.
std::string name_at(const std::string& code, std::size_t at)
{
    const std::size_t begin = skip_blanks(code, at);
    std::size_t end = begin;
    while (end < code.size() && is_name_character(code[end])) ++end;
    return code.substr(begin, end - begin);
}

/// Names in front of the values of DefineConstant[ a = 1, b = {2, Min 0} c = {3} ].
std::vector<std::string> names_in_list(const std::string& code, std::size_t open)
{
    std::vector<std::string> names;
    const std::size_t close = skip_brackets(code, open);
    std::size_t at = open + 1;
    while (at < close) {
        names.push_back(name_at(code, at));
        while (at < close && code[at] != ',' && code[at] != '{') {
            const bool opens = code[at] == '(' || code[at] == '[';
            at = opens ? skip_brackets(code, at) : at + 1;
        }
        // gmsh does without a comma after a value in braces
        if (at < close && code[at] == '{') at = skip_blanks(code, skip_brackets(code, at));
        if (at < close && code[at] == ',') ++at;
    }
    return names;
}

} // namespace

std::string blank_comments_and_strings(std::string_view text)
{
    enum class Inside { code, line_comment, block_comment, string };
    std::string code(text);
    Inside inside = Inside::code;
    char quote = '"'; // that opened the string at hand
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view pair = text.substr(at, 2);
        if (inside == Inside::code) {
            if (is_quote(text[at])) {
                inside = Inside::string;
                quote = text[at];
            }
            if (pair == "//") inside = Inside::line_comment;
            if (pair == "/*") {
                inside = Inside::block_comment;
                code[at] = code[at + 1] = ' ';
                ++at;
            }
            if (inside == Inside::line_comment) code[at] = ' ';
            continue;
        }
        const bool line_ends = text[at] == '\n';
        if (inside == Inside::string && text[at] == quote) {
            inside = Inside::code;
        } else if (inside == Inside::line_comment && line_ends) {
            inside = Inside::code;
        } else if (inside == Inside::block_comment && pair == "*/") {
            inside = Inside::code;
            code[at] = code[at + 1] = ' ';
            ++at;
        } else if (!line_ends) {
            code[at] = ' ';
        }
    }
    return code;
}

std::vector<std::string> declared_parameters(const std::filesystem::path& file)
{
    std::vector<std::string> names;
    for (const Script& script : read_scripts(file)) {
        for (const std::size_t at : find_word(script.code, "DefineConstant")) {
            const std::size_t open = skip_blanks(script.code, at + std::string_view("DefineConstant").size());
            const std::vector<std::string> listed = names_in_list(script.code, open);
            names.insert(names.end(), listed.begin(), listed.end());
        }
        for (const std::size_t at : find_word(script.code, "Exists")) {
            const std::size_t open = skip_blanks(script.code, at + std::string_view("Exists").size());
            names.push_back(name_at(script.code, open + 1));
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    std::erase(names, "");
    return names;
}

std::vector<std::filesystem::path> opened_files(const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> files;
    for (const Script& script : read_scripts(file)) {
        std::error_code ignored;
        if (std::filesystem::exists(script.file, ignored)) files.push_back(script.file);
    }
    return files;
}

void refuse_side_effects(const std::filesystem::path& file)
{
    for (const Script& script : read_scripts(file)) refuse_side_effects_of(script);
}

void refuse_unfinished_line(const std::filesystem::path& file)
{
    for (const Script& script : read_scripts(file)) {
        const std::size_t last = script.code.find_last_not_of(" \t\r\f");
        if (last == std::string::npos || script.code[last] == '\n') continue;
        throw InputError(fmt::format("{}:{}: the last line has no line end, and gmsh would pass over it\n"
                                     "hint: end the file with an empty line",
                                     script.file.string(), script.line_of(last)));
    }
}

} // namespace quicksand
