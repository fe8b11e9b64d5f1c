#include "io/keys/scene_document.hpp"

#include <fmt/format.h>

#include <charconv>
#include <exception>
#include <system_error>

namespace {

/// toml++ relies on invariants that some texts break.
struct BrokenInvariant : std::exception {};

constexpr void require_of_toml(bool holds)
{
    if (!holds) throw BrokenInvariant();
}

} // namespace

// The invariants are checked in every build, NDEBUG or not: without the checks such texts are read beyond
// their end, and with toml++'s own checks they stop the program.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(expression) require_of_toml(static_cast<bool>(expression))
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <tuple>
#include <utility>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

SourcePlace place_of(const std::filesystem::path& file, const toml::source_region& region)
{
    SourcePlace place{file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
    if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
        place.width = static_cast<int>(region.end.column - region.begin.column);
    }
    return place;
}

void copy_value(const toml::node& source, DocumentNode& node)
{
    switch (source.type()) {
    case toml::node_type::string:
        node.kind = Kind::text;
        node.text = source.as_string()->get();
        break;
    case toml::node_type::integer:
        node.kind = Kind::integer;
        node.integer = source.as_integer()->get();
        node.number = static_cast<double>(node.integer);
        break;
    case toml::node_type::floating_point:
        node.kind = Kind::number;
        node.number = source.as_floating_point()->get();
        break;
    case toml::node_type::boolean:
        node.kind = Kind::boolean;
        break;
    default:
        node.kind = Kind::date;
        break;
    }
}

DocumentNode copy_node(const std::filesystem::path& file, const toml::node& source)
{
    DocumentNode node;
    node.place = place_of(file, source.source());
    if (const toml::table* table = source.as_table()) {
        for (auto&& [key, value] : *table) {
            node.children.push_back(copy_node(file, value));
            node.children.back().name = key.str();
            node.children.back().name_place = place_of(file, key.source());
        }
        std::sort(node.children.begin(), node.children.end(),
                  [](const DocumentNode& a, const DocumentNode& b) {
                      return std::tie(a.name_place.line, a.name_place.column) <
                             std::tie(b.name_place.line, b.name_place.column);
                  });
    } else if (const toml::array* array = source.as_array()) {
        node.kind = Kind::array;
        for (const toml::node& item : *array) node.children.push_back(copy_node(file, item));
    } else {
        copy_value(source, node);
    }
    return node;
}

constexpr const char* line_forms = "a line is `key = value`, `[table]` or `# comment`";

/// Advice on the mistakes that people make most, from the parser's words.
std::string syntax_hint(std::string_view message)
{
    const auto says = [&](std::string_view part) { return message.find(part) != std::string_view::npos; };
    if (says("saw ','")) return "the decimal mark is a point: 1.5";
    if (says("cannot redefine")) return "keep one of the two";
    if (says("expected a comment or whitespace"))
        return "a quantity with a unit stands in quotes: \"60 kPa\"";
    if (says("could not determine value type")) return "text stands in quotes: \"sand\"";
    if (says("expected decimal digit")) return "write a digit on both sides of the point: 0.5";
    if (says("expected value, saw")) return "give the key a value, or put # before the line";
    if (says("control characters")) return "is a closing quote missing on this line?";
    if (says("expected '='")) return line_forms;
    return "";
}

Diagnostic syntax_error(const std::filesystem::path& file, const toml::parse_error& error)
{
    std::string what(error.description());
    if (const auto start = what.find(": ");
        start != std::string::npos && what.starts_with("Error while parsing")) {
        what.erase(0, start + 2);
    }
    const bool duplicate = what.find("cannot redefine") != std::string::npos;
    const std::string hint = syntax_hint(what);
    if (const auto name = what.find('\''); duplicate && name != std::string::npos) {
        what = what.substr(name, what.find('\'', name + 1) + 1 - name) + " is given twice";
    }
    return error_at(place_of(file, error.source()), duplicate ? "duplicate-key" : "syntax", what, "", hint);
}

bool breaks_invariant(std::string_view text)
{
    try {
        static_cast<void>(toml::parse(text));
    } catch (const toml::parse_error&) {
        return false;
    } catch (const BrokenInvariant&) {
        return true;
    }
    return false;
}

/// The line at which an invariant of the parser breaks, by halving: it reads a text from front to end.
int line_of_broken_invariant(std::string_view text)
{
    std::vector<std::size_t> line_ends;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '\n') line_ends.push_back(k + 1);
    }
    const auto bad = std::partition_point(line_ends.begin(), line_ends.end(), [&](std::size_t end) {
        return !breaks_invariant(text.substr(0, end));
    });
    return static_cast<int>(bad - line_ends.begin()) + 1;
}

/// Parse one text; nothing, and a finding, when it is no TOML.
std::optional<DocumentNode> parse(const std::filesystem::path& file, std::string_view text,
                                  Diagnostics& findings)
{
    try {
        return copy_node(file, toml::parse(text));
    } catch (const toml::parse_error& error) {
        findings.add(syntax_error(file, error));
    } catch (const BrokenInvariant&) {
        findings.add(error_at({file, line_of_broken_invariant(text), 1}, "syntax",
                              "this line is not complete", "", line_forms));
    }
    return std::nullopt;
}

std::string_view trim(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// The first = outside quotes.
std::size_t find_equals(std::string_view text)
{
    char quote = '\0';
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (quote != '\0') {
            if (text[k] == quote) quote = '\0';
        } else if (text[k] == '"' || text[k] == '\'') {
            quote = text[k];
        } else if (text[k] == '=') {
            return k;
        }
    }
    return std::string_view::npos;
}

/// Values of the command line have no place in a file: every place becomes the option itself.
void replace_places(const SourcePlace& place, DocumentNode& node)
{
    node.name_place = node.place = place;
    for (DocumentNode& child : node.children) replace_places(place, child);
}

/// A value that is no TOML as TOML: a number written otherwise, as .5 or 5., or a bare word.
std::string toml_of_bare(std::string_view value)
{
    double number = 0.0;
    const std::string_view digits = value.starts_with('+') ? value.substr(1) : value;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size() &&
                           digits.find('.') != std::string_view::npos;
    return is_number ? fmt::format("{}", number) : toml_text(value);
}

/// Parse `path=value`; a value that is no TOML is taken as a number written otherwise or as a bare word.
std::optional<DocumentNode> parse_override(const std::string& text, Diagnostics& findings)
{
    const SourcePlace place{"--set '" + text + "'", 0, 0};
    const auto refuse = [&](std::string what) {
        findings.add(error_at(place, "set", std::move(what), "path=value, as materials.sand.porosity=0.4"));
    };
    const std::size_t equals = find_equals(text);
    if (equals == std::string::npos || trim(std::string_view(text).substr(0, equals)).empty()) {
        refuse("there is no path before an equals sign");
        return std::nullopt;
    }
    if (std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; })) {
        refuse("it is not a single line of text");
        return std::nullopt;
    }
    const std::string_view value = trim(std::string_view(text).substr(equals + 1));
    Diagnostics first_try, second_try;
    auto node = parse("", text, first_try);
    if (!node && !value.empty() && value.find_first_of("\"'[{") != 0) {
        node = parse("", text.substr(0, equals) + "= " + toml_of_bare(value), second_try);
    }
    if (!node) {
        refuse(value.empty() ? "there is no value" : first_try.findings().front().what);
        return std::nullopt;
    }
    replace_places(place, *node);
    return node;
}

} // namespace

const DocumentNode* DocumentNode::find(std::string_view child) const
{
    for (const DocumentNode& node : children) {
        if (node.name == child) return &node;
    }
    return nullptr;
}

DocumentNode* DocumentNode::find(std::string_view child)
{
    return const_cast<DocumentNode*>(std::as_const(*this).find(child));
}

void DocumentNode::set(const std::string& child, DocumentNode value)
{
    value.name = child;
    remove(child);
    children.push_back(std::move(value));
}

void DocumentNode::remove(std::string_view child)
{
    std::erase_if(children, [&](const DocumentNode& node) { return node.name == child; });
}

DocumentNode text_value(std::string text, const SourcePlace& place)
{
    DocumentNode node;
    node.kind = DocumentNode::Kind::text;
    node.text = std::move(text);
    node.name_place = node.place = place;
    return node;
}

std::string toml_text(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) {
            result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
            continue;
        }
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

void replace_keys(DocumentNode&& document, DocumentNode& target)
{
    for (DocumentNode& child : document.children) {
        DocumentNode* const found = target.find(child.name);
        if (found == nullptr) {
            target.children.push_back(std::move(child));
        } else if (found->kind == Kind::table && child.kind == Kind::table) {
            replace_keys(std::move(child), *found);
        } else {
            *found = std::move(child);
        }
    }
}

void replace_by_overrides(const std::vector<std::string>& overrides, DocumentNode& document,
                          Diagnostics& findings)
{
    for (const std::string& override : overrides) {
        auto node = parse_override(override, findings);
        if (node) replace_keys(std::move(*node), document);
    }
}

std::optional<DocumentNode> read_document(const std::filesystem::path& file, std::string_view text,
                                          const std::vector<std::string>& overrides, Diagnostics& findings)
{
    auto document = parse(file, text, findings);
    DocumentNode unread; // of a text that cannot be parsed: its overrides are checked all the same
    replace_by_overrides(overrides, document ? *document : unread, findings);
    return document;
}

} // namespace quicksand
