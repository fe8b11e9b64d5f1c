#include "io/scene/scene_variant.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

/// The row of the key `name` in the table `path`, which may stand within a stage.
const SceneKey* row_of(const KeyPath& path, const std::string& name)
{
    const bool is_within_stage = path.size() > 2 && path.front() == "stages";
    KeyPath key(path.begin() + (is_within_stage ? 2 : 0), path.end());
    key.push_back(name);
    return find_key(scene_key_table(), key);
}

/// Ways to say the same, each with its keys. A scene takes one of them.
using Ways = std::vector<std::vector<std::string_view>>;

const std::array<Ways, 3> alternatives = {
    Ways{{"interfaces.*.strength_ratio"}, {"interfaces.*.friction_angle", "interfaces.*.cohesion"}},
    Ways{{"materials.*.n1_60"}, {"materials.*.relative_density"}, {"materials.*.preset"}},
    Ways{{"materials.*.elastic_shear_number"},
         {"materials.*.small_strain_shear_modulus"},
         {"materials.*.shear_wave_velocity"}}};

bool says_otherwise(const SceneKey& given, const SceneKey& key)
{
    return std::any_of(alternatives.begin(), alternatives.end(), [&](const Ways& ways) {
        const auto way_of = [&](const SceneKey& each) {
            return std::find_if(ways.begin(), ways.end(),
                                [&](const auto& way) { return contains(way, each.pattern); });
        };
        return way_of(given) != ways.end() && way_of(key) != ways.end() && way_of(given) != way_of(key);
    });
}

/// Whether a word of the variant leaves the key of the base without use, or a key of the variant says the
/// same in another way.
bool is_useless(const DocumentNode& key, const KeyPath& path, const DocumentNode& variant)
{
    if (key.kind == Kind::table || variant.find(key.name) != nullptr) return false;
    const SceneKey* row = row_of(path, key.name);
    if (row == nullptr) return false;
    if (!row->when.sibling.empty()) {
        const DocumentNode* word = variant.find(row->when.sibling);
        if (word != nullptr && word->kind == Kind::text && !contains(row->when.words, word->text))
            return true;
    }
    return std::any_of(variant.children.begin(), variant.children.end(), [&](const DocumentNode& given) {
        const SceneKey* other = row_of(path, given.name);
        return other != nullptr && says_otherwise(*other, *row);
    });
}

/// Remove keys of a table of the base that those of the variant make useless. Both have the path `path`.
void remove_useless(const DocumentNode& variant, const KeyPath& path, DocumentNode& base)
{
    std::erase_if(base.children, [&](const DocumentNode& node) { return is_useless(node, path, variant); });
    for (DocumentNode& node : base.children) {
        const DocumentNode* child = variant.find(node.name);
        if (child == nullptr || node.kind != Kind::table || child->kind != Kind::table) continue;
        KeyPath inner = path;
        inner.push_back(node.name);
        remove_useless(*child, inner, node);
    }
}

} // namespace

void merge_variant(DocumentNode&& variant, DocumentNode& base)
{
    remove_useless(variant, {}, base);
    replace_keys(std::move(variant), base);
}

} // namespace quicksand
