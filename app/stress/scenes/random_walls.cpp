#include "app/stress/scenes/random_walls.hpp"

namespace quicksand {

namespace {

/// How what acts on a curve changes with time: at once, as a ramp, or as a wave.
void set_course(const std::string& table, double duration, RandomNumbers& random, SceneDraft& scene)
{
    if (random.chance(0.4)) {
        scene.set(table + ".ramp_time", duration * random.between(0.1, 1.0));
    } else if (random.chance(0.4)) {
        scene.set(table + ".frequency", random.between(0.5, 5.0) / duration);
    }
}

/// It moves by up to 5 % of a cell, so that the soil follows.
void set_moving(const std::string& table, const RandomSection& section, const WallPurpose& purpose,
                RandomNumbers& random, SceneDraft& scene)
{
    const double way = 0.05 * section.cell_size;
    scene.set(table + ".soil", "moving");
    const int kind = random.whole(0, 4);
    if (kind == 0) {
        scene.set(table + ".velocity", 0.0, 0.0);
    } else if (kind == 1) {
        scene.set(table + ".velocity", random.between(-way, way) / purpose.duration,
                  random.between(-way, way) / purpose.duration);
    } else if (kind == 2) {
        scene.set(table + ".normal_velocity", random.between(-way, way) / purpose.duration);
    } else if (kind == 3) {
        scene.set(table + ".displacement", random.between(-way, way), random.between(-way, way));
    } else {
        scene.set(table + ".normal_displacement", random.between(-way, way));
    }
    if (kind >= 3) {
        scene.set(table + ".ramp_time", purpose.duration * random.between(0.3, 1.0));
    } else if (kind > 0) {
        set_course(table, purpose.duration, random, scene);
    }
}

void set_viscous(const std::string& table, RandomNumbers& random, SceneDraft& scene)
{
    scene.set(table + ".soil", "viscous");
    if (!random.chance(0.4)) return;
    scene.set(table + ".rock_density", random.between(1800.0, 2600.0));
    const double shear = random.between(150.0, 1500.0);
    scene.set(table + ".rock_shear_wave_speed", shear);
    scene.set(table + ".rock_compression_wave_speed", shear * random.between(1.6, 3.0));
}

void set_wall_water(const std::string& table, const RandomSection& section, const WallPurpose& purpose,
                    RandomNumbers& random, SceneDraft& scene)
{
    if (!purpose.has_pressure || random.chance(0.5)) return;
    // A head or a pressure against dry soil is refused.
    const int kind = random.whole(0, purpose.is_submerged ? 3 : 1);
    if (kind == 0) scene.set(table + ".water", "drained");
    if (kind == 1) scene.set(table + ".water", "impervious");
    if (kind == 2) {
        scene.set(table + ".water", "head");
        scene.set(table + ".head", purpose.water_level + section.height * random.between(-0.2, 0.2));
    }
    if (kind == 3) {
        scene.set(table + ".water", "pore_pressure");
        scene.set(table + ".pore_pressure", purpose.pressure * random.between(0.0, 0.5));
    }
    const bool has_course = scene.has(table + ".ramp_time") || scene.has(table + ".frequency");
    if (kind == 2 && !has_course) set_course(table, purpose.duration, random, scene);
}

void set_wall(const std::string& curve, bool below, const RandomSection& section, const WallPurpose& purpose,
              RandomNumbers& random, SceneDraft& scene)
{
    const std::string table = "boundaries." + curve;
    const double draw = random.fraction();
    if (draw < (below ? 0.5 : 0.2)) {
        scene.set(table + ".soil", "fixed");
    } else if (draw < 0.6) {
        scene.set(table + ".soil", "roller");
    } else if (draw < 0.75) {
        set_viscous(table, random, scene);
    } else if (draw < 0.9 || below) {
        set_moving(table, section, purpose, random, scene);
    } else {
        scene.set(table + ".soil", "free");
    }
    set_wall_water(table, section, purpose, random, scene);
}

void set_surface(const std::string& curve, const RandomSection& section, const WallPurpose& purpose,
                 RandomNumbers& random, SceneDraft& scene)
{
    const std::string table = "boundaries." + curve;
    scene.set(table + ".soil", "free");
    if (random.chance(0.35)) {
        scene.set(table + ".pressure", purpose.pressure * random.between(0.05, 1.0));
        set_course(table, purpose.duration, random, scene);
    } else if (random.chance(0.2)) {
        const double size = purpose.pressure * random.between(0.05, 0.5);
        scene.set(table + ".traction", size * random.between(-0.5, 0.5), -size);
        set_course(table, purpose.duration, random, scene);
    }
    set_wall_water(table, section, purpose, random, scene);
}

} // namespace

void set_random_walls(const RandomSection& section, const WallPurpose& purpose, RandomNumbers& random,
                      SceneDraft& scene)
{
    for (const std::string& base : section.bases) set_wall(base, true, section, purpose, random, scene);
    if (section.can_be_tied && random.chance(0.4)) {
        scene.set("boundaries.left.soil", "tied").set("boundaries.left.tied_to", "right");
        scene.set("boundaries.right.soil", "tied").set("boundaries.right.tied_to", "left");
    } else {
        for (const char* side : {"left", "right"}) set_wall(side, false, section, purpose, random, scene);
    }
    for (const std::string& surface : section.surfaces) set_surface(surface, section, purpose, random, scene);
}

} // namespace quicksand
