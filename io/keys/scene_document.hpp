// A TOML text as a plain tree in which every key and value knows its place. The only user of toml++.
#pragma once

#include "io/keys/diagnostics.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct DocumentNode {
    enum class Kind { table, array, text, integer, number, boolean, date };

    Kind kind = Kind::table;
    std::string name;       // of the key that holds this value, "" in an array
    SourcePlace name_place; // of that key; a table's is its header's
    SourcePlace place;      // of the value
    std::string text;       // when kind is text
    double number = 0.0;    // when kind is integer or number
    std::int64_t integer = 0;
    std::vector<DocumentNode> children; // in the order of the file

    const DocumentNode* find(std::string_view child) const;
    DocumentNode* find(std::string_view child);
    /// Put the value under the name in place of that of the same name, at the end.
    void set(const std::string& child, DocumentNode value);
    void remove(std::string_view child);
};

/// A text that stands in a scene at this place.
DocumentNode text_value(std::string text, const SourcePlace& place);

/// Parse the text, then put every `path=value` of `overrides` in place. Syntax errors are added to
/// `findings`; the result is empty when the text itself cannot be parsed.
std::optional<DocumentNode> read_document(const std::filesystem::path& file, std::string_view text,
                                          const std::vector<std::string>& overrides, Diagnostics& findings);

/// Put every `path=value` of `overrides` in place of that of the same path in the document, or add it.
void replace_by_overrides(const std::vector<std::string>& overrides, DocumentNode& document,
                          Diagnostics& findings);

/// The text as a TOML string; control characters are escaped.
std::string toml_text(std::string_view text);

/// Put every value of `document` in place of that of the same path in `target`, or add it.
void replace_keys(DocumentNode&& document, DocumentNode& target);

} // namespace quicksand
