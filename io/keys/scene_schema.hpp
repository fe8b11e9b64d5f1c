// A table of keys: one for scenes, one for element tests. It drives reading, defaults, ranges, plausibility
// warnings, the list of resolved keys and the reference of `quicksand keys`.
#pragma once

#include "io/keys/scene_units.hpp"
#include "solver/base/conventions.hpp"
#include "solver/base/interval.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace quicksand {

/// A value of a scene key, in SI units.
using SceneValue =
    std::variant<double, std::int64_t, std::string, Vector2, std::pair<int, int>,
                 std::map<std::string, double>, std::vector<std::string>, std::vector<double>,
                 std::vector<int>, std::vector<Vector2>, std::map<std::string, std::vector<double>>>;

enum class ValueType {
    table,        // [grid]
    named_tables, // [materials.NAME]
    number,
    integer,
    text,
    word,         // one of a list
    path,         // of a file, relative to the scene
    point,        // [x, y]
    point_list,   // [[x, y], ...]
    count_pair,   // two integers
    number_table, // NAME = number
    list_table,   // NAME = [number, ...]
    text_list,
    number_list,   // numbers or quantities of the key's dimension
    quantity_list, // numbers or quantities of any dimension, as written
    count_list,    // [whole number, ...]
    quantity,      // a number or a quantity of any dimension, as written
    value_list,    // values of any kind, as TOML writes them
};

/// The key is used only where the key `sibling` of the same table is one of `words`.
struct Condition {
    std::string_view sibling = {};
    std::vector<std::string_view> words = {};
};

/// A default that follows from other keys: the number `key` / `divisor`, or the word that `choices` gives to
/// the word of the key `sibling` of the same table.
struct DerivedDefault {
    std::string_view key = {};
    double divisor = 1.0;
    std::string_view sibling = {};
    std::span<const std::pair<std::string_view, std::string_view>> choices = {};
};

/// One row of the table.
struct SceneKey {
    std::string_view pattern = {}; // "materials.*.porosity"; * is a name of the user's
    ValueType type = ValueType::number;
    Dimension dimension = Dimension::none;
    bool required = false;
    bool saturated_only = false;                  // of no use without [water]
    std::vector<std::string_view> flows = {};     // words of water.flow it is of use with; none: all
    bool used_by_seepage = false;                 // besides, with water.initial_flow = "seepage"
    std::optional<SceneValue> default_value = {}; // none: required, derived or simply absent
    DerivedDefault derived = {};
    std::string_view default_note = {}; // what absence means, where there is no default value
    Interval allowed = {};              // an error outside
    Interval plausible = {};            // a warning outside
    std::string_view caution = {};      // said with the plausibility warning
    std::vector<std::string_view> words = {};
    Condition when = {};
    std::string_view doc = {}; // one line
};

/// A key of former versions: it is read over with a warning.
struct RetiredKey {
    std::string_view path; // "sampling.boundary_refinement"
    std::string_view why;  // what has taken its place
};

/// All keys of a kind of file, tables before their keys, in the order of the reference.
struct KeyTable {
    std::string_view file;        // what such a file is called: "scene"
    std::string_view version_key; // "scene_version"
    std::string_view title;       // of the reference page
    std::vector<SceneKey> keys;
    std::vector<RetiredKey> retired = {};
};

const KeyTable& scene_key_table();

using KeyPath = std::vector<std::string>;

/// "materials.sand.porosity"; parts that are no bare TOML keys are quoted.
std::string join_path(const KeyPath& path);

/// The row that describes the path; null when there is none.
const SceneKey* find_key(const KeyTable& table, const KeyPath& path);

/// Patterns directly below the table pattern ("" for the top level).
std::vector<const SceneKey*> keys_of_table(const KeyTable& table, std::string_view table_pattern);

/// The last part of a pattern: "porosity".
std::string_view last_part(std::string_view pattern);

/// The pattern without its last part: "materials.*".
std::string_view table_part(std::string_view pattern);

/// "more than 0 and less than 1 Pa"
std::string describe(const Interval& interval, Dimension dimension);

/// The value as text, in SI, without unit.
std::string value_text(const SceneValue& value);

/// The pattern as the reference shows it: "materials.NAME.porosity".
std::string shown_path(std::string_view pattern);

/// Whether the row is a table, which has keys and no value.
bool is_table(const SceneKey& key);

struct KeyProperty {
    std::string name; // "is", "default", "used", "range" or "usual"
    std::string text; // "number in Pa"
};

/// What the reference says of a key besides its line: the properties that it has, in a fixed order.
std::vector<KeyProperty> key_properties(const SceneKey& key);

/// The reference as aligned text, of the keys whose pattern contains `pattern` ("" for all).
std::string describe_keys(const KeyTable& table, std::string_view pattern);

/// The reference as Markdown tables, one for every table of the file.
std::string keys_markdown(const KeyTable& table);

} // namespace quicksand
