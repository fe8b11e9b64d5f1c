#include "io/assembly/thin_layers.hpp"

#include "geometry/section/region_contacts.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/scene/cell_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace quicksand {

namespace {

bool is_slanted(const Vector2& edge)
{
    constexpr double flat = 1e-6; // of its length: how little an edge along the grid rises
    return edge.cwiseAbs().minCoeff() > flat * edge.norm();
}

/// Lengths of all edges of a polygon and of those that are neither level nor upright [m].
struct EdgeLengths {
    double all = 0.0, slanted = 0.0;

    void add(const Ring& ring)
    {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vector2 edge = ring[(k + 1) % ring.size()] - ring[k];
            all += edge.norm();
            if (is_slanted(edge)) slanted += edge.norm();
        }
    }
};

EdgeLengths edge_lengths(const Polygon& polygon)
{
    EdgeLengths lengths;
    lengths.add(polygon.outer);
    for (const Ring& hole : polygon.holes) lengths.add(hole);
    return lengths;
}

/// The shorter side of the rectangle with the area and all edges of a polygon [m].
double layer_thickness(const Polygon& polygon, double edges)
{
    const double quarter = 0.25 * edges, area_of_it = area(Region{"", {polygon}});
    return quarter - std::sqrt(std::max(0.0, quarter * quarter - area_of_it));
}

constexpr double much = 0.25; // of the edges

/// Of the thickest part of a region that lies at an angle to the grid: more than a quarter of its edges do.
/// Zero without such a part [m].
double slanted_thickness(const Region& region)
{
    double most = 0.0;
    for (const Polygon& polygon : region.polygons) {
        const EdgeLengths lengths = edge_lengths(polygon);
        if (lengths.slanted > much * lengths.all)
            most = std::max(most, layer_thickness(polygon, lengths.all));
    }
    return most;
}

/// Whether much of a region's edges lies at an angle and beside another region, which the slopes of a dike on
/// level ground do not.
bool has_slanted_face(std::size_t region, const Section& section, const std::vector<RegionContact>& contacts)
{
    double all = 0.0, slanted = 0.0; // [m]
    for (const Polygon& polygon : section.regions[region].polygons) all += edge_lengths(polygon).all;
    for (const RegionContact& contact : contacts) {
        const Vector2 edge = contact.edge.end - contact.edge.start;
        if ((contact.left == region || contact.right == region) && is_slanted(edge)) slanted += edge.norm();
    }
    return slanted > much * all;
}

const SceneRegion* find_region(const Scene& scene, const std::string& name)
{
    const auto found = std::find_if(scene.regions.begin(), scene.regions.end(),
                                    [&](const SceneRegion& region) { return region.name == name; });
    return found == scene.regions.end() ? nullptr : &*found;
}

const Material* material_of(const Scene& scene, const SceneRegion* region)
{
    if (region == nullptr) return nullptr;
    const auto found =
        std::find_if(scene.materials.begin(), scene.materials.end(),
                     [&](const SceneMaterial& each) { return each.material.name == region->material; });
    return found == scene.materials.end() ? nullptr : &found->material;
}

/// Whether a region touches another one of as strong and stiff a soil.
bool goes_on(std::size_t region, const Material& material, const Scene& scene, const Section& section,
             const std::vector<RegionContact>& contacts)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const RegionContact& contact) {
        if (contact.left != region && contact.right != region) return false;
        const std::size_t other = contact.left == region ? contact.right : contact.left;
        const Material* beside = material_of(scene, find_region(scene, section.regions[other].name));
        return beside != nullptr && beside->has_pores &&
               undamped(without_weight(beside->law)) == undamped(without_weight(material.law));
    });
}

} // namespace

void check_layers(const Scene& scene, const Section& section, double cell_size, Diagnostics& findings)
{
    constexpr double least_cells = 3.0, rounding = 1e-6; // [cells]
    if (section.regions.size() < 2) return;
    const std::vector<RegionContact> contacts = region_contacts(section);
    for (std::size_t k = 0; k < section.regions.size(); ++k) {
        const SceneRegion* written = find_region(scene, section.regions[k].name);
        const double cells = slanted_thickness(section.regions[k]) / cell_size;
        const Material* material = material_of(scene, written);
        if (material == nullptr || !(cells > 0.0 && cells < least_cells - rounding)) continue;
        const bool is_layer = has_slanted_face(k, section, contacts) && material->has_pores &&
                              !goes_on(k, *material, scene, section, contacts);
        if (!is_layer) continue;
        findings.add(warning_at(
            written->place, join_path({"regions", written->name}), "thin-layer",
            fmt::format("the region \"{}\" is {:.2g} cells thick and lies at an angle to the grid: it "
                        "is too strong where it is weak",
                        written->name, std::min(cells, 2.9)),
            fmt::format("cells of at most {:.3g} m, {:g} through the layer",
                        cells * cell_size / cells_through_layer, cells_through_layer),
            "without grid.cell_size the program chooses such cells"));
    }
}

} // namespace quicksand
