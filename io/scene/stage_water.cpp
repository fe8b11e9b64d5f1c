#include "io/scene/stage_water.hpp"

#include "io/tables/scene_boundaries.hpp"

#include <variant>

namespace quicksand {

namespace {

/// The head beyond a curve at the end of a stage; the level of the still water where it has no head of its
/// own [m].
double head_at_end(const Scene& stage, const Boundary& boundary)
{
    const double level = stage.water->level;
    const auto* water = std::get_if<PrescribedWater>(&boundary.water);
    const auto* head = water != nullptr ? std::get_if<WaterHead>(&water->value) : nullptr;
    if (head == nullptr) return level;
    const double at_rest = water->at_rest ? water->at_rest->points.front().y() : level;
    const double end =
        settles(stage.stage->kind) ? 0.0 : stage.end_time; // soil settles under what acts first
    return at_rest + outer_factor(boundary.water, end) * (head->head - at_rest);
}

void begin_ramps(const Scene& before, Scene& stage)
{
    if (!before.water || !stage.water) return;
    for (SceneBoundary& scene : stage.boundaries) {
        auto* water = std::get_if<PrescribedWater>(&scene.boundary.water);
        if (water == nullptr || !std::holds_alternative<WaterHead>(water->value)) continue;
        const History& history = water->history;
        if (!std::holds_alternative<ConstantHistory>(history.shape) || !(history.ramp_time > 0.0)) continue;
        const SceneBoundary* of_before = find_boundary(before, scene.boundary.name);
        if (of_before == nullptr) continue;
        const double head = head_at_end(before, of_before->boundary);
        if (head != before.water->level) water->at_rest = WaterLine{{Vector2(0.0, head)}};
    }
}

} // namespace

void carry_water_on(std::vector<SceneReading>& stages)
{
    for (std::size_t k = 1; k < stages.size(); ++k) {
        const SceneReading& before = stages[k - 1];
        begin_ramps(before.scene, stages[k].scene);
        if (settles(stages[k].scene.stage->kind)) continue;
        stages[k].wetting = before.wetting;
        const bool has_time_to_wet = before.scene.stage->kind != StageKind::stability;
        if (before.scene.starts_seeping && has_time_to_wet) stages[k].wetting.push_back(before.scene);
    }
}

} // namespace quicksand
