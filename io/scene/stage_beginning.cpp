#include "io/scene/stage_water.hpp"

#include "io/tables/scene_boundaries.hpp"

#include <algorithm>
#include <optional>
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
        takes_time(stage.stage->kind) ? stage.end_time : stage.stage->flow_duration.value_or(0.0);
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

/// Whether the flow of a stage is that after a time.
bool flows_in_time(const Scene& scene)
{
    return scene.stage->flow_duration.has_value();
}

/// The flows that the stage after `before` follows, its own among them.
void append_flow(const SceneReading& before, SceneReading& stage)
{
    const bool has_time_to_wet = before.scene.stage->kind != StageKind::stability;
    stage.flows = before.flows;
    stage.wetting = before.wetting;
    if (before.keeps_flow || !has_time_to_wet || !before.scene.water) return;
    stage.flows.push_back(before.scene);
    if (before.scene.starts_seeping) ++stage.wetting;
}

std::optional<WaterLine> still_water_line(const Scene& scene)
{
    if (!scene.water || scene.starts_seeping) return std::nullopt;
    if (scene.phreatic_line.empty()) return WaterLine{{Vector2(0.0, scene.water->level)}};
    return WaterLine{scene.phreatic_line};
}

} // namespace

void carry_water_on(std::vector<SceneReading>& stages)
{
    for (std::size_t k = 1; k < stages.size(); ++k) {
        SceneReading& stage = stages[k];
        begin_ramps(stages[k - 1].scene, stage.scene);
        append_flow(stages[k - 1], stage);
        if (settles(stage.scene.stage->kind)) {
            stage.wetting = 0;
            if (!flows_in_time(stage.scene)) stage.flows.clear();
        } else {
            stage.keeps_flow = !stage.flows.empty() && flows_in_time(stage.flows.back());
        }
    }
}

void share_water_lines(std::vector<SceneReading>& stages)
{
    std::vector<WaterLine> lines;
    for (const SceneReading& stage : stages) {
        const std::optional<WaterLine> line = still_water_line(stage.scene);
        const bool is_known = line && std::any_of(lines.begin(), lines.end(), [&](const WaterLine& known) {
                                  return known.points == line->points;
                              });
        if (line && !is_known) lines.push_back(*line);
    }
    for (SceneReading& stage : stages) stage.water_lines = lines;
}

} // namespace quicksand
