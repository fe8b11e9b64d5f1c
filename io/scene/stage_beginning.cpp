#include "io/scene/stage_beginning.hpp"

#include "io/tables/scene_boundaries.hpp"

#include <algorithm>
#include <optional>
#include <variant>

namespace quicksand {

namespace {

/// How long loads and walls act in a stage [s].
double duration_of(const Scene& stage)
{
    return takes_time(stage.stage->kind) ? stage.end_time : stage.stage->flow_duration.value_or(0.0);
}

WaterLine still_water_of(const Scene& stage)
{
    return {stage.phreatic_line.empty() ? std::vector{Vector2(0.0, stage.water->level)}
                                        : stage.phreatic_line};
}

/// The surface of the water at rest that a head beyond a curve counts from.
WaterLine rest_beyond(const Scene& stage, const Boundary& boundary)
{
    const auto* water = std::get_if<PrescribedWater>(&boundary.water);
    return water != nullptr && water->at_rest ? *water->at_rest : still_water_of(stage);
}

/// The surface of the water beyond a curve at the end of a stage; of the still water where it has no head of
/// its own.
WaterLine surface_at_end(const Scene& stage, const Boundary& boundary)
{
    WaterLine line = rest_beyond(stage, boundary);
    const auto* water = std::get_if<PrescribedWater>(&boundary.water);
    const auto* head = water != nullptr ? std::get_if<WaterHead>(&water->value) : nullptr;
    if (head == nullptr) return line;
    const double factor = outer_factor(boundary.water, duration_of(stage));
    for (Vector2& point : line.points)
        point.y() = factor == 1.0 ? head->head : point.y() + factor * (head->head - point.y());
    return line;
}

bool is_at(const WaterLine& line, double height)
{
    return std::all_of(line.points.begin(), line.points.end(),
                       [&](const Vector2& point) { return point.y() == height; });
}

bool has_still_water_of(const Scene& before, const Scene& stage)
{
    return stage.water->level == before.water->level && stage.phreatic_line == before.phreatic_line;
}

bool rises_from_rest(const History& history)
{
    return std::holds_alternative<ConstantHistory>(history.shape) && history.ramp_time > 0.0;
}

/// Heads that go on count from where they did; other ones that rise, from where the stage before has left
/// the water.
void begin_heads(const Scene& before, Scene& stage)
{
    if (!before.water || !stage.water) return;
    for (SceneBoundary& scene : stage.boundaries) {
        auto* water = std::get_if<PrescribedWater>(&scene.boundary.water);
        const auto* head = water != nullptr ? std::get_if<WaterHead>(&water->value) : nullptr;
        const SceneBoundary* of_before = find_boundary(before, scene.boundary.name);
        if (head == nullptr || of_before == nullptr) continue;
        if (scene.water_goes_on) {
            water->at_rest = rest_beyond(before, of_before->boundary);
        } else if (rises_from_rest(water->history)) {
            const WaterLine reached = surface_at_end(before, of_before->boundary);
            if (is_at(reached, head->head)) water->history = {}; // the ramp has ended
            scene.water_goes_on = reached.points != still_water_of(before).points;
            if (scene.water_goes_on) water->at_rest = reached;
        }
        scene.water_goes_on = scene.water_goes_on && has_still_water_of(before, stage);
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

bool begins_with_steady_flow(const SceneReading& reading)
{
    const Scene& scene = reading.scene;
    return scene.stage && scene.starts_seeping && !flows_in_time(scene) && !reading.keeps_flow;
}

std::optional<WaterLine> still_water_line(const Scene& scene)
{
    if (!scene.water || scene.starts_seeping) return std::nullopt;
    return still_water_of(scene);
}

/// Factor on `load` that is the part of another, parallel one; none where they are not parallel [-].
std::optional<double> part_of_load(const SurfaceLoad& other, double part, const SurfaceLoad& load)
{
    const Eigen::Vector3d before(other.traction.x(), other.traction.y(), other.pressure),
        now(load.traction.x(), load.traction.y(), load.pressure);
    if (!(now.norm() > 0.0)) return std::nullopt;
    constexpr double parallel = 1e-9; // of their size
    const double factor = before.dot(now) / now.squaredNorm();
    if ((before - factor * now).norm() > parallel * before.norm()) return std::nullopt;
    return part * factor;
}

/// `before` as the stage before had it, `drawn` as its scene gives it.
void carry_load_on(const SurfaceLoad& drawn, const SurfaceLoad& before, double duration, SurfaceLoad& load)
{
    if (load == drawn) {
        load.history = history_from(before.history, duration);
        return;
    }
    const std::optional<double> left = part_of_load(before, history_value(before.history, duration), load);
    if (left && rises_from_rest(load.history))
        load.history = {SampledHistory{{0.0, load.history.ramp_time}, {*left, 1.0}}, 0.0};
}

/// The water at a curve whose excess has a course; other heads that rise by a ramp begin in begin_heads().
void carry_pressure_on(const PrescribedWater& drawn, const SceneBoundary& of_before, double duration,
                       SceneBoundary& scene)
{
    auto& water = std::get<PrescribedWater>(scene.boundary.water);
    const History& before = std::get<PrescribedWater>(of_before.boundary.water).history;
    if (water.value != drawn.value || water.history != drawn.history) return;
    scene.water_goes_on = of_before.water_goes_on || (duration > 0.0 && varies(before));
    water.history = history_from(before, duration);
}

void carry_course_on(const Boundary& drawn, const SceneBoundary& of_before, double duration,
                     SceneBoundary& scene)
{
    const Boundary& before = of_before.boundary;
    Boundary& boundary = scene.boundary;
    auto* face = std::get_if<FreeFace>(&boundary.soil);
    const auto *drawn_face = std::get_if<FreeFace>(&drawn.soil),
               *face_before = std::get_if<FreeFace>(&before.soil);
    if (face != nullptr && face->load && face_before != nullptr && face_before->load)
        carry_load_on(*drawn_face->load, *face_before->load, duration, *face->load);
    auto* wall = std::get_if<MovingWall>(&boundary.soil);
    const auto *drawn_wall = std::get_if<MovingWall>(&drawn.soil),
               *wall_before = std::get_if<MovingWall>(&before.soil);
    if (wall != nullptr && wall_before != nullptr && wall->motion == drawn_wall->motion)
        wall->motion.history = history_from(wall_before->motion.history, duration);
    const auto *water = std::get_if<PrescribedWater>(&boundary.water),
               *drawn_water = std::get_if<PrescribedWater>(&drawn.water),
               *water_before = std::get_if<PrescribedWater>(&before.water);
    if (water != nullptr && water_before != nullptr)
        carry_pressure_on(*drawn_water, of_before, duration, scene);
}

} // namespace

void carry_courses_on(std::vector<SceneReading>& stages)
{
    std::vector<SceneBoundary> drawn = stages.front().scene.boundaries;
    for (std::size_t k = 1; k < stages.size(); ++k) {
        const Scene& before = stages[k - 1].scene;
        std::vector<SceneBoundary> drawn_now = stages[k].scene.boundaries;
        for (SceneBoundary& scene : stages[k].scene.boundaries) {
            const SceneBoundary* of_before = find_boundary(before, scene.boundary.name);
            if (of_before == nullptr) continue;
            const auto number = static_cast<std::size_t>(of_before - before.boundaries.data());
            carry_course_on(drawn[number].boundary, *of_before, duration_of(before), scene);
        }
        drawn = std::move(drawn_now);
    }
}

void begin_later(double time, Scene& scene)
{
    for (SceneBoundary& of_scene : scene.boundaries) {
        Boundary& boundary = of_scene.boundary;
        if (auto* face = std::get_if<FreeFace>(&boundary.soil); face != nullptr && face->load)
            face->load->history = history_from(face->load->history, time);
        if (auto* wall = std::get_if<MovingWall>(&boundary.soil); wall != nullptr)
            wall->motion.history = history_from(wall->motion.history, time);
        if (auto* water = std::get_if<PrescribedWater>(&boundary.water); water != nullptr) {
            water->history = history_from(water->history, time);
            of_scene.water_goes_on = of_scene.water_goes_on || time > 0.0;
        }
    }
}

void carry_water_on(std::vector<SceneReading>& stages)
{
    for (std::size_t k = 1; k < stages.size(); ++k) {
        SceneReading& stage = stages[k];
        begin_heads(stages[k - 1].scene, stage.scene);
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
    std::vector<SeepingStage> seeping;
    for (const SceneReading& stage : stages) {
        const std::optional<WaterLine> line = still_water_line(stage.scene);
        const bool is_known = line && std::any_of(lines.begin(), lines.end(), [&](const WaterLine& known) {
                                  return known.points == line->points;
                              });
        if (line && !is_known) lines.push_back(*line);
        if (begins_with_steady_flow(stage)) seeping.push_back({stage.scene, stage.keys});
    }
    for (SceneReading& stage : stages) {
        stage.water_lines = lines;
        stage.seeping = seeping;
    }
}

} // namespace quicksand
