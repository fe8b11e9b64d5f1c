#include "io/scene/stage_placement.hpp"

#include "geometry/drawing/nearest_name.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quicksand {

namespace {

using Kind = DocumentNode::Kind;

constexpr std::string_view present = "present", absent = "absent";

/// Call visit(region) for the texts of a list.
template <class Visit>
void for_each_region(const DocumentNode& stage, std::string_view key, Visit&& visit)
{
    const DocumentNode* list = stage.find(key);
    if (list == nullptr || list->kind != Kind::array) return;
    for (const DocumentNode& item : list->children)
        if (item.kind == Kind::text) visit(item);
}

/// Call visit(stage) for the stages of a document, in their order.
template <class Visit>
void for_each_stage(const DocumentNode& document, Visit&& visit)
{
    const DocumentNode* stages = document.find("stages");
    if (stages == nullptr || stages->kind != Kind::table) return;
    for (const DocumentNode& stage : stages->children)
        if (stage.kind == Kind::table) visit(stage);
}

const DocumentNode* soil_of(const DocumentNode& document, const std::string& region)
{
    const DocumentNode* regions = document.find("regions");
    const DocumentNode* table = regions != nullptr ? regions->find(region) : nullptr;
    return table != nullptr && table->kind == Kind::table ? table->find("soil") : nullptr;
}

void set_soil(DocumentNode& document, const DocumentNode& region, std::string_view word)
{
    DocumentNode* regions = document.find("regions");
    DocumentNode* table = regions != nullptr ? regions->find(region.text) : nullptr;
    if (table == nullptr || table->kind != Kind::table) return; // the check of names tells
    table->set("soil", text_value(std::string(word), region.place));
}

/// What is known of the regions on the way through the stages.
class PlacementCheck {
public:
    PlacementCheck(const DocumentNode& document, Diagnostics& findings) : findings_(findings)
    {
        const DocumentNode* regions = document.find("regions");
        if (regions == nullptr || regions->kind != Kind::table) return;
        for (const DocumentNode& region : regions->children) known_.push_back(region.name);
        DocumentNode emptied = document;
        empty_unplaced_regions(emptied);
        for (const std::string& region : known_) {
            const DocumentNode* soil = soil_of(emptied, region);
            has_soil_[region] = soil == nullptr || soil->text != absent;
        }
    }

    void look(const DocumentNode& stage, bool is_first)
    {
        const std::map<std::string, bool> before = has_soil_;
        for_each_region(stage, "remove", [&](const DocumentNode& region) {
            if (!is_known(region)) return;
            if (is_first) {
                refuse(region, "the first stage cannot remove soil", "regions that a later stage removes",
                       "soil that is not there from the start is regions." + region.text +
                           ".soil = \"absent\"");
            } else if (!has_soil_[region.text]) {
                refuse(region, "there is no soil in the region \"" + region.text + "\" to remove",
                       "a region that has soil in the stage before", "");
            }
            has_soil_[region.text] = false;
        });
        for_each_region(stage, "place", [&](const DocumentNode& region) {
            if (!is_known(region)) return;
            if (is_first) {
                refuse(region, "the first stage cannot place soil on the ground of a stage before",
                       "regions that a later stage places", "soil that is there from the start is not named");
            } else if (before.at(region.text)) {
                const bool replaces = !has_soil_[region.text];
                refuse(region, "the region \"" + region.text + "\" has soil already when it is placed",
                       "regions without soil in the stage before",
                       replaces ? "remove it in a stage of its own, before this one"
                                : "a region is placed once, or again after a stage that removes it");
            }
            has_soil_[region.text] = true;
        });
        if (!known_.empty() &&
            std::none_of(has_soil_.begin(), has_soil_.end(), [](const auto& entry) { return entry.second; }))
            findings_.add(error_at(stage.place, "stage",
                                   "no region has soil in the stage \"" + stage.name + "\"",
                                   "soil in at least one region of every stage"));
    }

private:
    bool is_known(const DocumentNode& region)
    {
        if (known_.empty() || std::find(known_.begin(), known_.end(), region.text) != known_.end())
            return !known_.empty();
        const std::string nearest = nearest_name(region.text, known_);
        refuse(region, "there is no region \"" + region.text + "\"", one_of(known_),
               nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
        return false;
    }

    void refuse(const DocumentNode& region, const std::string& what, const std::string& expected,
                const std::string& hint)
    {
        findings_.add(error_at(region.place, "stage", what, expected, hint));
    }

    Diagnostics& findings_;
    std::vector<std::string> known_;
    std::map<std::string, bool> has_soil_;
};

} // namespace

void check_placement(const DocumentNode& document, Diagnostics& findings)
{
    PlacementCheck check(document, findings);
    bool is_first = true;
    for_each_stage(document, [&](const DocumentNode& stage) {
        check.look(stage, is_first);
        is_first = false;
    });
}

bool places_soil(const DocumentNode& document)
{
    bool any = false;
    for_each_stage(document, [&](const DocumentNode& stage) {
        any = any || stage.find("place") != nullptr || stage.find("remove") != nullptr;
    });
    return any;
}

void empty_unplaced_regions(DocumentNode& document)
{
    std::vector<std::string> named; // by a stage, be it placed or removed first
    std::vector<DocumentNode> placed;
    for_each_stage(document, [&](const DocumentNode& stage) {
        for (const char* key : {"remove", "place"})
            for_each_region(stage, key, [&](const DocumentNode& region) {
                if (std::find(named.begin(), named.end(), region.text) != named.end()) return;
                named.push_back(region.text);
                if (std::string_view(key) == "place") placed.push_back(region);
            });
    });
    for (const DocumentNode& region : placed)
        if (soil_of(document, region.text) == nullptr) set_soil(document, region, absent);
}

void place_regions(const DocumentNode& stage, DocumentNode& document)
{
    for_each_region(stage, "remove", [&](const DocumentNode& region) { set_soil(document, region, absent); });
    for_each_region(stage, "place", [&](const DocumentNode& region) { set_soil(document, region, present); });
}

DocumentNode without_placement(DocumentNode document)
{
    if (DocumentNode* stages = document.find("stages"); stages != nullptr)
        for (DocumentNode& stage : stages->children)
            for (const char* key : {"place", "remove"}) stage.remove(key);
    return document;
}

} // namespace quicksand
