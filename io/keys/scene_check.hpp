// A whole file against its key table: unknown and missing keys, conditions, defaults.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_document.hpp"
#include "io/keys/scene_schema.hpp"
#include "solver/base/failure.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace quicksand {

/// One resolved key for `check`: what is used and where it comes from.
struct ResolvedKey {
    std::string path;   // "materials.sand.porosity"
    std::string value;  // in SI, as text
    std::string unit;   // "" when dimensionless
    bool given = false; // false: the default
};

struct FoundValue {
    SceneValue value;
    bool given = false;
    SourcePlace place; // of the value; of nothing when it is a default
};

struct NamedTable {
    std::string name;
    std::string path;  // "materials.sand"
    SourcePlace place; // of its header
};

/// The values of a file by their paths. Where the file has errors, some are missing. To ask for a key that
/// the table does not have, or for another type than its row says, is a program bug and throws InternalError.
struct SceneValues {
    const KeyTable* table = nullptr;
    std::map<std::string, FoundValue> by_path;
    std::set<std::string> written;             // paths that the file holds, be their values good or bad
    std::map<std::string, SourcePlace> tables; // given tables and the places of their headers
    std::map<std::string, std::vector<NamedTable>> named; // by "materials", in the order of the file
    std::vector<ResolvedKey> keys;                        // in the order of the reference

    bool has_table(const std::string& path) const { return tables.contains(path); }
    bool has(const std::string& path) const { return by_path.contains(path); }
    bool given(const std::string& path) const
    {
        require_key(path);
        return has(path) && by_path.at(path).given;
    }
    /// The tables [table.NAME], in the order of the file.
    const std::vector<NamedTable>& tables_named(const std::string& table) const;
    SourcePlace place(const std::string& path) const
    {
        return has(path) ? by_path.at(path).place : SourcePlace();
    }

    /// The value when it is there and of this type.
    template <class Type>
    std::optional<Type> find(const std::string& path) const
    {
        require_key(path);
        const auto found = by_path.find(path);
        if (found == by_path.end()) return std::nullopt;
        const Type* value = std::get_if<Type>(&found->second.value);
        if (value == nullptr) throw InternalError("the key " + path + " is asked for as what it is not");
        return *value;
    }
    double number(const std::string& path) const { return find<double>(path).value_or(0.0); }
    std::string text(const std::string& path) const { return find<std::string>(path).value_or(""); }

private:
    void require_key(const std::string& path) const;
};

/// Check the document against the key table and resolve every key. Everything wrong is added to `findings`.
SceneValues check_document(const KeyTable& table, const DocumentNode& document, Diagnostics& findings);

} // namespace quicksand
