#include "app/stress/scenes/designed_set.hpp"

#include "app/stress/scenes/section_draft.hpp"

namespace quicksand {

SceneDraft block_scene(const std::string& scheme)
{
    SceneDraft scene;
    scene.set("scene_version", 1.0).set("geometry.file", "section.geo");
    scene.set("grid.cell_size", 1.0).set_whole("sampling.particles_per_cell", 3, 3);
    scene.set("analysis.columns", "all");
    scene.set("analysis.scheme", scheme == dry_scheme ? explicit_scheme : scheme);
    if (scheme != dry_scheme) scene.set("water.level", 20.0);
    scene.set("materials.soil.model", "linear_elastic")
        .set("materials.soil.porosity", 0.4)
        .set("materials.soil.shear_modulus", 5e7)
        .set("materials.soil.poisson_ratio", 0.3);
    if (scheme != dry_scheme) scene.set("materials.soil.hydraulic_conductivity", 1e-3);
    scene.set("regions.soil.material", "soil").set("boundaries.base.soil", "fixed");
    scene.set("boundaries.left.soil", "roller").set("boundaries.right.soil", "roller");
    scene.set("boundaries.surface.soil", "free").set("initial.k0", 0.6);
    scene.set("motion.kind", "sine").set("motion.amplitude", 1.0).set("motion.frequency", 5.0);
    scene.set("run.end_time", 0.3).set("output.frame_interval", 0.15).set("output.history_interval", 0.05);
    return scene;
}

StressRow drawn_row(const std::string& group, const std::string& name, const std::string& drawing,
                    const SceneDraft& scene)
{
    StressRow row;
    row.group = group;
    row.name = name;
    row.drawing = drawing;
    row.scene = scene.text("quicksand stress: " + row.id());
    return row;
}

StressRow block_row(const std::string& group, const std::string& name, const SceneDraft& scene)
{
    return drawn_row(group, name, draft_rectangle(0.0, 0.0, 8.0, 8.0).text(), scene);
}

StressRows designed_rows(bool long_ones)
{
    StressRows rows;
    add_step_rows(rows);
    add_soil_rows(rows);
    add_corner_rows(rows);
    add_moving_rows(rows);
    add_motion_rows(long_ones, rows);
    return rows;
}

std::vector<std::string> stress_groups()
{
    std::vector<std::string> groups;
    for (const StressRow& row : designed_rows(true))
        if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
    groups.emplace_back("random");
    return groups;
}

} // namespace quicksand
