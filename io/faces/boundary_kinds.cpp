#include "io/faces/boundary_kinds.hpp"

#include <type_traits>

namespace quicksand {

namespace {

/// The kind of each alternative: one that has no scene_kind does not compile.
template <class... Kinds>
std::vector<SceneSoilKind> list_kinds(std::type_identity<std::variant<Kinds...>>)
{
    return {scene_kind(Kinds{})...};
}

} // namespace

SceneSoilKind scene_kind(const FixedWall&)
{
    return {
        .word = "fixed", .doc = "fixed", .read = [](BoundaryTable&) -> SoilCondition { return FixedWall{}; }};
}

SceneSoilKind scene_kind(const RollerWall&)
{
    return {.word = "roller",
            .doc = "roller (slides along the curve)",
            .read = [](BoundaryTable&) -> SoilCondition { return RollerWall{}; }};
}

SceneSoilKind scene_kind(const TiedSide&)
{
    return {.word = "tied", .doc = "tied to the opposite side", .read = [](BoundaryTable&) -> SoilCondition {
                return TiedSide{};
            }};
}

SceneSoilKind scene_kind(const FreeFieldSide&)
{
    return {.word = "free_field",
            .doc = "free_field (level ground goes on beyond a vertical side)",
            .water = "drained",
            .read = [](BoundaryTable&) -> SoilCondition { return FreeFieldSide{}; }};
}

const std::vector<SceneSoilKind>& soil_kinds()
{
    static const std::vector<SceneSoilKind> kinds = list_kinds(std::type_identity<SoilCondition>());
    return kinds;
}

const SceneSoilKind& kind_of(const SoilCondition& soil)
{
    return soil_kinds()[soil.index()];
}

} // namespace quicksand
