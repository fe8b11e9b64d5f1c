#include "io/keys/scene_check.hpp"

#include "geometry/drawing/nearest_name.hpp"
#include "io/keys/scene_value_reader.hpp"

#include <algorithm>
#include <array>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

/// A key or table of the document with its row.
struct Entry {
    KeyPath path;
    const SceneKey* key = nullptr;
    const DocumentNode* node = nullptr; // null: not in the document
};

class DocumentCheck {
public:
    DocumentCheck(const KeyTable& table, const DocumentNode& document, Diagnostics& findings)
        : table_(table), document_(document), findings_(findings)
    {
    }

    SceneValues check();

private:
    void collect(const DocumentNode& table, const KeyPath& path, std::string_view pattern);
    void collect_child(const DocumentNode& child, const KeyPath& path);
    void refuse_unknown(const DocumentNode& child, const DocumentNode& parent, const KeyPath& table,
                        std::string_view pattern);
    /// Whether the key is one of former versions, which is warned of.
    bool pass_over_retired(const DocumentNode& child, const KeyPath& path);

    void resolve_table(const Entry& table);
    void resolve_key(const SceneKey& key, const Entry& table);
    bool flow_uses(const SceneKey& key, const std::string& path, const DocumentNode* node);
    bool condition_holds(const SceneKey& key, const KeyPath& table, const DocumentNode* node);
    void refuse_missing(const SceneKey& key, const Entry& table);
    void put_default(const SceneKey& key, const KeyPath& table, const std::string& path);
    void put(const SceneKey& key, const std::string& path, SceneValue value, const DocumentNode* node);

    const KeyTable& table_;
    const DocumentNode& document_;
    Diagnostics& findings_;
    std::map<std::string, Entry> entries_; // what the document holds
    std::set<std::string> suspected_;      // paths that a misspelt key probably meant
    SceneValues values_;
};

std::string header(const KeyPath& path, const SceneKey* key = nullptr)
{
    const bool named = key != nullptr && key->type == ValueType::named_tables;
    return "[" + join_path(path) + (named ? ".NAME" : "") + "]";
}

KeyPath operator+(KeyPath path, std::string_view part)
{
    path.emplace_back(part);
    return path;
}

/// The table, with NAME for *, in which a key of this name is known; "" when there is none.
std::string home_of(const KeyTable& keys, std::string_view name)
{
    for (const SceneKey& key : keys.keys) {
        if (last_part(key.pattern) != name || is_table(key)) continue;
        std::string table(table_part(key.pattern));
        if (const auto star = table.find('*'); star != std::string::npos) table.replace(star, 1, "NAME");
        return table;
    }
    return "";
}

/// Whether the key is of use beside the words of its table, as far as these are given.
bool applies(const SceneKey& key, const DocumentNode& table)
{
    if (key.when.sibling.empty()) return true;
    const DocumentNode* sibling = table.find(key.when.sibling);
    return sibling == nullptr || sibling->kind != Kind::text ||
           std::find(key.when.words.begin(), key.when.words.end(), sibling->text) != key.when.words.end();
}

/// A quantity by a name of textbooks or other programs, and what a scene has for it.
struct OtherName {
    std::string_view name, key, hint;
};

constexpr std::array<OtherName, 8> other_names{{
    {"youngs_modulus", "shear_modulus", "shear_modulus = E / (2 (1 + poisson_ratio))"},
    {"young_modulus", "shear_modulus", "shear_modulus = E / (2 (1 + poisson_ratio))"},
    {"bulk_modulus", "shear_modulus", "shear_modulus = 3 K (1 - 2 poisson_ratio) / (2 (1 + poisson_ratio))"},
    {"oedometer_modulus", "shear_modulus",
     "shear_modulus = M (1 - 2 poisson_ratio) / (2 (1 - poisson_ratio))"},
    {"unit_weight", "grain_density", "dry unit weight = (1 - porosity) grain_density 9.81 m/s2"},
    {"permeability", "hydraulic_conductivity", "hydraulic_conductivity in m/s"},
    {"phi", "friction_angle", "friction_angle"},
    {"psi", "dilation_angle", "dilation_angle"},
}};

/// Among the known keys of a table; none: null.
const OtherName* find_other_name(std::string_view name, const std::vector<std::string>& known)
{
    const auto* found = std::find_if(other_names.begin(), other_names.end(), [&](const OtherName& other) {
        return other.name == name && std::find(known.begin(), known.end(), other.key) != known.end();
    });
    return found == other_names.end() ? nullptr : found;
}

void DocumentCheck::refuse_unknown(const DocumentNode& child, const DocumentNode& parent,
                                   const KeyPath& table, std::string_view pattern)
{
    const bool child_is_table = child.kind == Kind::table;
    std::vector<std::string> known;
    for (const SceneKey* key : keys_of_table(table_, pattern)) {
        if (!applies(*key, parent)) continue;
        if (!table.empty() || is_table(*key) == child_is_table) known.emplace_back(last_part(key->pattern));
    }
    const std::string nearest = nearest_name(child.name, known);
    std::string hint;
    if (const OtherName* other = find_other_name(child.name, known); other != nullptr) {
        suspected_.insert(join_path(table + std::string(other->key)));
        hint = other->hint;
    } else if (!nearest.empty()) {
        suspected_.insert(join_path(table + nearest));
        hint = "did you mean " + nearest + "?";
    } else if (const std::string home = home_of(table_, child.name); !home.empty()) {
        hint = child.name + " belongs in [" + home + "]";
    }
    const std::string where = table.empty() ? "" : " in " + header(table);
    findings_.add(error_at(child_is_table ? child.place : child.name_place,
                           child_is_table ? "unknown-table" : "unknown-key",
                           (child_is_table ? "unknown table " + header(table + child.name)
                                           : "unknown key '" + child.name + "'" + where),
                           one_of(known), hint));
}

bool DocumentCheck::pass_over_retired(const DocumentNode& child, const KeyPath& path)
{
    for (const RetiredKey& key : table_.retired) {
        if (key.path != join_path(path)) continue;
        findings_.add(warning_at(child.name_place, join_path(path), "retired-key",
                                 join_path(path) + " has no effect any more: " + std::string(key.why), "",
                                 "remove the line"));
        return true;
    }
    return false;
}

void DocumentCheck::collect_child(const DocumentNode& child, const KeyPath& path)
{
    const SceneKey* key = find_key(table_, path);
    if (!is_table(*key)) {
        entries_[join_path(path)] = {path, key, &child};
    } else if (child.kind == Kind::table) {
        entries_[join_path(path)] = {path, key, &child};
        values_.tables[join_path(path)] = child.place;
        collect(child, path, key->pattern);
    } else {
        entries_[join_path(path)] = {path, key, nullptr};
        const std::string lines = "a table, that is a line " + header(path, key) + " and its keys below it";
        findings_.add(
            error_at(child.place, "type", join_path(path) + " is " + describe_kind(child.kind), lines));
    }
}

void DocumentCheck::collect(const DocumentNode& table, const KeyPath& path, std::string_view pattern)
{
    for (const DocumentNode& child : table.children) {
        const KeyPath child_path = path + child.name;
        if (find_key(table_, child_path) == nullptr) {
            if (!pass_over_retired(child, child_path)) refuse_unknown(child, table, path, pattern);
            continue;
        }
        const bool named = pattern != "" && find_key(table_, path)->type == ValueType::named_tables;
        if (named && child.kind == Kind::table) {
            values_.named[std::string(pattern)].push_back({child.name, join_path(child_path), child.place});
        }
        collect_child(child, child_path);
    }
}

/// Whether the key is of use with the water's flow; one that is given all the same is warned of.
bool DocumentCheck::flow_uses(const SceneKey& key, const std::string& path, const DocumentNode* node)
{
    if (key.flows.empty()) return true;
    const std::string flow = values_.text("water.flow");
    const bool uses = std::find(key.flows.begin(), key.flows.end(), flow) != key.flows.end() ||
                      (key.used_by_seepage && values_.text("water.initial_flow") == "seepage");
    if (!uses && node != nullptr && !flow.empty()) {
        findings_.add(warning_at(
            node->name_place, path, "unused", path + " has no effect with water.flow = \"" + flow + "\"", "",
            "remove it, or set water.flow = \"" + std::string(key.flows.front()) + "\""));
    }
    return uses;
}

bool DocumentCheck::condition_holds(const SceneKey& key, const KeyPath& table, const DocumentNode* node)
{
    const std::string path = join_path(table + last_part(key.pattern));
    if (key.saturated_only && !entries_.contains("water")) {
        if (node != nullptr) {
            findings_.add(warning_at(node->name_place, path, "unused", path + " has no effect in a dry scene",
                                     "", "add a table [water], or remove the key"));
        }
        return false;
    }
    if (!flow_uses(key, path, node)) return false;
    if (key.when.sibling.empty()) return true;
    const auto word = values_.find<std::string>(join_path(table + key.when.sibling));
    if (!word) return false; // the sibling is wrong itself and has been reported
    const bool holds = std::find(key.when.words.begin(), key.when.words.end(), *word) != key.when.words.end();
    if (!holds && node != nullptr) {
        const std::string sibling(key.when.sibling);
        findings_.add(error_at(
            node->name_place, "unused-key", path + " is not used with " + sibling + " = \"" + *word + "\"",
            "", "remove it, or set " + sibling + " = \"" + std::string(key.when.words.front()) + "\""));
    }
    return holds;
}

void DocumentCheck::refuse_missing(const SceneKey& key, const Entry& table)
{
    const KeyPath path = table.path + last_part(key.pattern);
    if (suspected_.contains(join_path(path))) return;
    const SourcePlace file{document_.place.file, 0, 0};
    const SourcePlace place = table.node != nullptr && !table.path.empty() ? table.node->place : file;
    if (is_table(key)) {
        std::string keys;
        for (const SceneKey* child : keys_of_table(table_, key.pattern)) {
            if (child->required)
                keys += (keys.empty() ? " with " : ", ") + std::string(last_part(child->pattern));
        }
        findings_.add(error_at(place, "missing-table", "there is no table " + header(path, &key),
                               "a table " + header(path, &key) + keys + ": " + std::string(key.doc)));
        return;
    }
    const std::string unit(si_symbol(key.dimension));
    const std::string hint =
        key.pattern == table_.version_key
            ? "begin the " + std::string(table_.file) + " with the line " + std::string(key.pattern) + " = 1"
            : "";
    findings_.add(error_at(place, "missing-key",
                           (table.path.empty() ? "the " + std::string(table_.file) : header(table.path)) +
                               " has no " + std::string(last_part(key.pattern)),
                           std::string(last_part(key.pattern)) + (unit.empty() ? "" : " [" + unit + "]") +
                               ": " + std::string(key.doc),
                           hint));
}

void DocumentCheck::put(const SceneKey& key, const std::string& path, SceneValue value,
                        const DocumentNode* node)
{
    values_.keys.push_back({path, value_text(value), std::string(si_symbol(key.dimension)), node != nullptr});
    values_.by_path[path] = {std::move(value), node != nullptr,
                             node != nullptr ? node->place : SourcePlace()};
}

void DocumentCheck::put_default(const SceneKey& key, const KeyPath& table, const std::string& path)
{
    if (key.default_value) {
        put(key, path, *key.default_value, nullptr);
    } else if (!key.derived.key.empty()) {
        const auto base = values_.find<double>(std::string(key.derived.key));
        if (base) put(key, path, *base / key.derived.divisor, nullptr);
    } else if (!key.derived.sibling.empty()) {
        const std::string word = values_.text(join_path(table + key.derived.sibling));
        for (const auto& [sibling_word, choice] : key.derived.choices) {
            if (word == sibling_word) put(key, path, std::string(choice), nullptr);
        }
    } else {
        values_.keys.push_back({path, std::string(key.default_note), "", false});
    }
}

void DocumentCheck::resolve_key(const SceneKey& key, const Entry& table)
{
    const std::string path = join_path(table.path + last_part(key.pattern));
    const auto entry = entries_.find(path);
    const DocumentNode* node = entry == entries_.end() ? nullptr : entry->second.node;
    if (node != nullptr) values_.written.insert(path);
    if (!condition_holds(key, table.path, node)) return;
    if (node != nullptr) {
        if (auto value = read_value(key, path, *node, findings_)) put(key, path, std::move(*value), node);
    } else if (key.required) {
        refuse_missing(key, table);
    } else {
        put_default(key, table.path, path);
    }
}

/// Resolve the keys of a table, then the tables in it.
void DocumentCheck::resolve_table(const Entry& table)
{
    const std::string_view pattern = table.key != nullptr ? table.key->pattern : "";
    const auto children = keys_of_table(table_, pattern);
    for (const SceneKey* key : children) {
        if (!is_table(*key)) resolve_key(*key, table);
    }
    for (const SceneKey* key : children) {
        if (!is_table(*key)) continue;
        if (key->pattern.ends_with('*')) {
            for (const NamedTable& named : values_.named[std::string(pattern)]) {
                resolve_table({table.path + named.name, key, entries_.at(named.path).node});
            }
            continue;
        }
        const KeyPath path = table.path + last_part(key->pattern);
        const auto entry = entries_.find(join_path(path));
        const bool present = entry != entries_.end();
        const bool empty = present && key->type == ValueType::named_tables && entry->second.node != nullptr &&
                           entry->second.node->children.empty();
        if (key->required && (!present || empty)) refuse_missing(*key, table);
        const bool absence_means_something = !key->default_note.empty();
        if (present ? entry->second.node != nullptr : !key->required && !absence_means_something) {
            resolve_table({path, key, present ? entry->second.node : nullptr});
        }
    }
}

SceneValues DocumentCheck::check()
{
    values_.table = &table_;
    collect(document_, {}, "");
    resolve_table({{}, nullptr, &document_});
    return std::move(values_);
}

} // namespace

const std::vector<NamedTable>& SceneValues::tables_named(const std::string& wanted) const
{
    static const std::vector<NamedTable> none;
    const auto found = named.find(wanted);
    return found == named.end() ? none : found->second;
}

void SceneValues::require_key(const std::string& path) const
{
    ENSURE(table != nullptr);
    const bool known = std::any_of(table->keys.begin(), table->keys.end(), [&](const SceneKey& key) {
        if (is_table(key)) return false;
        const std::size_t star = key.pattern.find('*');
        if (star == std::string_view::npos) return path == key.pattern;
        return path.starts_with(key.pattern.substr(0, star)) && path.ends_with(key.pattern.substr(star + 1));
    });
    if (!known) throw InternalError("there is no key " + path);
}

SceneValues check_document(const KeyTable& table, const DocumentNode& document, Diagnostics& findings)
{
    return DocumentCheck(table, document, findings).check();
}

} // namespace quicksand
