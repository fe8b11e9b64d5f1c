#include "io/scene/scene_variant.hpp"

#include "io/keys/scene_schema.hpp"

#include <algorithm>
#include <utility>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

/// Remove keys of a table of the base that the words of the variant make useless. Both have the path `path`.
void remove_useless(const DocumentNode& variant, const KeyPath& path, DocumentNode& base)
{
    std::erase_if(base.children, [&](const DocumentNode& node) {
        if (node.kind == Kind::table || variant.find(node.name) != nullptr) return false;
        KeyPath inner = path;
        inner.push_back(node.name);
        const SceneKey* key = find_key(scene_key_table(), inner);
        if (key == nullptr || key->when.sibling.empty()) return false;
        const DocumentNode* word = variant.find(key->when.sibling);
        return word != nullptr && word->kind == Kind::text &&
               std::find(key->when.words.begin(), key->when.words.end(), word->text) == key->when.words.end();
    });
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
