#include "io/scene/scene_keys.hpp"

#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_text.hpp"
#include "io/scene/scene_stages.hpp"

namespace quicksand {

std::vector<ResolvedKey> read_scene_keys(const std::filesystem::path& copy,
                                         const std::vector<std::string>& overrides)
{
    Diagnostics findings;
    const auto text = read_text_file(copy, {copy, 0, 0}, findings);
    if (!text) throw_findings(findings, "");
    auto document = read_document(copy, *text, {}, findings);
    if (document && stage_names(*document).empty()) replace_by_overrides(overrides, *document, findings);
    if (!document) throw_findings(findings, *text);
    SceneValues values = check_document(scene_key_table(), *document, findings);
    if (findings.has_errors()) throw_findings(findings, *text);
    return std::move(values.keys);
}

} // namespace quicksand
