// What a scene says of each kind of boundary: its word, its keys and how they are read. A new kind of
// SoilCondition has a function `scene_kind` here and a file with its definition.
#pragma once

#include "io/keys/diagnostics.hpp"
#include "io/keys/scene_check.hpp"
#include "solver/faces/boundary.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quicksand {

/// One table [boundaries.NAME], where its findings go, and how what acts on the curve varies.
class BoundaryTable {
public:
    BoundaryTable(const SceneValues& values, const NamedTable& table, Diagnostics& findings)
        : values_(values), table_(table), findings_(findings)
    {
    }

    std::string path(std::string_view key) const { return table_.path + "." + std::string(key); }
    /// Whether the scene gives the key, rightly.
    bool has(std::string_view key) const { return values_.given(path(key)); }
    /// Whether the file holds the key, be its value good or bad.
    bool is_written(std::string_view key) const { return values_.written.contains(path(key)); }
    std::string text(std::string_view key) const { return values_.text(path(key)); }
    double number(std::string_view key) const { return values_.number(path(key)); }
    Vector2 point(std::string_view key) const
    {
        return values_.find<Vector2>(path(key)).value_or(Vector2::Zero());
    }
    SourcePlace place(std::string_view key) const { return values_.place(path(key)); }
    const History& history() const { return history_; }
    void set_history(History history) { history_ = std::move(history); }

    /// Report what is wrong with a key, or with the table as a whole.
    void refuse(std::string_view key, std::string what, std::string expected, std::string hint = "")
    {
        findings_.add(
            error_at(place(key), "boundary", std::move(what), std::move(expected), std::move(hint)));
    }
    void refuse_table(const std::string& what, std::string expected, std::string hint = "")
    {
        findings_.add(
            error_at(table_.place, "boundary", table_.path + what, std::move(expected), std::move(hint)));
    }

private:
    const SceneValues& values_;
    const NamedTable& table_;
    Diagnostics& findings_;
    History history_;
};

/// A kind of boundary as scenes have it.
struct SceneSoilKind {
    std::string_view word;                      // soil = "roller"
    std::string_view doc;                       // "roller (slides along the curve)"
    std::string_view water = "impervious";      // the word of the water where the scene gives none
    std::vector<SceneKey> keys = {};            // of this kind alone
    std::vector<std::string_view> varying = {}; // those of the keys that a history is a factor on
    SoilCondition (*read)(BoundaryTable& table) = nullptr;
};

SceneSoilKind scene_kind(const FreeFace&);
SceneSoilKind scene_kind(const FixedWall&);
SceneSoilKind scene_kind(const RollerWall&);
SceneSoilKind scene_kind(const TiedSide&);
SceneSoilKind scene_kind(const MovingWall&);
SceneSoilKind scene_kind(const ViscousFace&);
SceneSoilKind scene_kind(const FreeFieldSide&);

/// All kinds, in the order of the alternatives of SoilCondition, and that of a curve.
const std::vector<SceneSoilKind>& soil_kinds();
const SceneSoilKind& kind_of(const SoilCondition& soil);

/// What water does at a curve, as scenes have it.
struct SceneWaterKind {
    std::string_view word;           // water = "head"
    std::vector<SceneKey> keys = {}; // of this kind alone; a history is a factor on them
    WaterCondition (*read)(BoundaryTable& table) = nullptr;
};

const std::vector<SceneWaterKind>& water_kinds();

/// The kind of a checked word; the first where the file has an error in its place. A word that no kind has
/// although its row does is a program bug and throws InternalError.
template <class Kind>
const Kind& kind_named(const std::vector<Kind>& kinds, std::string_view word)
{
    for (const Kind& kind : kinds) {
        if (kind.word == word) return kind;
    }
    if (!word.empty()) throw InternalError("the word " + std::string(word) + " stands for nothing");
    return kinds.front();
}

} // namespace quicksand
