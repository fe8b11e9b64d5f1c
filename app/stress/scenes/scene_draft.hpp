// The text of a scene as it is put together: keys in their tables.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace quicksand {

/// Keys by their paths, as "materials.soil.porosity"; tables come in the order of their first key.
class SceneDraft {
public:
    /// Give a key, in place of a former value.
    SceneDraft& set(const std::string& path, double value);
    SceneDraft& set(const std::string& path, const std::string& text);
    SceneDraft& set(const std::string& path, const char* text) { return set(path, std::string(text)); }
    SceneDraft& set(const std::string& path, double x, double y);
    SceneDraft& set_whole(const std::string& path, int x, int y);

    /// Take away a key, or a table with all its keys.
    SceneDraft& remove(const std::string& path);

    /// The table alone, without keys.
    SceneDraft& add_table(const std::string& table);

    bool has(const std::string& path) const;

    /// As TOML; `heading` is a comment in front.
    std::string text(const std::string& heading) const;

private:
    struct Table {
        std::string name; // "" for keys in no table
        std::vector<std::pair<std::string, std::string>> keys;
    };
    Table& table(const std::string& name);
    SceneDraft& put(const std::string& path, std::string value);

    std::vector<Table> tables_ = {{"", {}}};
};

/// A number as drawings and scenes have it, 9 digits.
std::string draft_number(double value);

} // namespace quicksand
