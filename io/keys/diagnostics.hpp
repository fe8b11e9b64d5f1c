// Messages about the user's input: collected, then shown together with the place, the source line and a
// caret.
#pragma once

#include "io/keys/source_place.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

enum class Severity { error, warning };

/// One finding. Shown as
///     file:line:column: error[kind]: what
///        31 | fluid_bulk_modulus = 2.2e6
///           |                      ^~~~~
///     expected: ...
///     hint: ...
struct Diagnostic {
    Severity severity = Severity::error;
    std::string kind; // "unknown-key", "unit", "range", ...
    SourcePlace place;
    std::string what;
    std::string expected; // may be empty
    std::string hint;     // may be empty
    std::string key;      // path of the scene key whose acceptance silences this warning, may be empty
};

Diagnostic error_at(SourcePlace place, std::string kind, std::string what, std::string expected = "",
                    std::string hint = "");
Diagnostic warning_at(SourcePlace place, std::string key, std::string kind, std::string what,
                      std::string expected = "", std::string hint = "");

/// A batch of findings about one source text.
class Diagnostics {
public:
    /// `file` is what the source is called in the messages.
    explicit Diagnostics(std::string_view file = "scene") : file_(file) {}

    void add(Diagnostic diagnostic) { findings_.push_back(std::move(diagnostic)); }
    void add(const Diagnostics& others);
    /// Add a finding unless the same is there already.
    void add_new(const Diagnostic& diagnostic);
    /// Quote findings in this file from its own text, not from that of `render`. They are shown last.
    void keep_text(const std::filesystem::path& file, std::string_view text);
    /// The same of all files whose texts others have.
    void keep_texts_of(const Diagnostics& others);
    /// Remove the warnings about these keys.
    void accept(const std::vector<std::string>& keys);
    bool has_errors() const;
    bool empty() const { return findings_.empty(); }
    const std::vector<Diagnostic>& findings() const { return findings_; }

    /// At most 20 errors and five warnings of a kind, in the order of the file, then a count of the rest.
    /// `source` is the text the places refer to, "" when there is none to quote.
    std::string render(std::string_view source) const;

private:
    std::string file_;
    std::vector<Diagnostic> findings_;
    std::map<std::filesystem::path, std::string> texts_; // of files that a scene names
};

/// Throws the findings as an InputError. `source` is the text they refer to, "" when there is none to quote.
[[noreturn]] void throw_findings(const Diagnostics& findings, std::string_view source);

/// "one of a, b, c", or "a" where there is no choice.
std::string one_of(const std::vector<std::string>& words);

} // namespace quicksand
