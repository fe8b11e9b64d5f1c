#include "io/assembly/interface_layers.hpp"

#include "geometry/section/region_contacts.hpp"
#include "io/keys/scene_schema.hpp"
#include "io/keys/scene_units.hpp"
#include "io/laws/soil_laws.hpp"
#include "solver/base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

namespace quicksand {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A piece of an edge, and the thickness of the soil beside it that slides.
struct LayerEdge {
    Segment segment;
    double thickness = 0.0; // [m]
};

/// A layer with its edge and its material.
struct Layer {
    InterfaceLayer told;
    std::size_t region = 0;    // whose soil slides
    std::int32_t material = 0; // of the problem and of the scene
    std::vector<LayerEdge> edge;
    SourcePlace place; // of the interface in the scene
};

double distance(const Segment& segment, const Vector2& point)
{
    const Vector2 along = segment.end - segment.start;
    const double place =
        std::clamp((point - segment.start).dot(along) / along.squaredNorm(), 0.0, 1.0); // of the length
    return (segment.start + place * along - point).norm();
}

/// Distance to the nearest piece of the edge whose layer reaches the point; none: the layer does not.
std::optional<double> distance(const Layer& layer, const Vector2& point)
{
    std::optional<double> least;
    for (const LayerEdge& edge : layer.edge) {
        const double away = distance(edge.segment, point);
        if (away <= edge.thickness && away < least.value_or(infinite)) least = away;
    }
    return least;
}

/// Whether a coordinate is the same at both ends, and whether it is that of a grid line.
struct Alignment {
    bool is_parallel = false, is_on_line = false;
};

Alignment alignment(double start, double end, double origin, double cell_size)
{
    constexpr double rounding = 1e-6; // [cells]
    const double cells = (start - origin) / cell_size;
    const bool is_parallel = std::abs(start - end) < rounding * cell_size;
    return {is_parallel, is_parallel && std::abs(cells - std::round(cells)) < rounding};
}

/// Slip takes a band of cells that are full of the soil that slides, from nodes without a part of the other
/// region to nodes without a part of the soil below. Measured on slabs that slide: one cell beside an edge on
/// a grid line, two beside one along the lines, four at any angle [m].
double least_thickness(const Segment& segment, const BackgroundGrid& grid)
{
    const Vector2 &a = segment.start, &b = segment.end, &origin = grid.origin;
    const Alignment upright = alignment(a.x(), b.x(), origin.x(), grid.cell_size),
                    level = alignment(a.y(), b.y(), origin.y(), grid.cell_size);
    if (upright.is_on_line || level.is_on_line) return grid.cell_size;
    return (upright.is_parallel || level.is_parallel ? 2.0 : 4.0) * grid.cell_size;
}

class LayerMaker {
public:
    LayerMaker(const Section& section, const std::vector<std::int32_t>& of_region, Scene& scene,
               Problem& problem, Diagnostics& findings)
        : section_(section), of_region_(of_region), scene_(scene), problem_(problem), findings_(findings),
          contacts_(region_contacts(section))
    {
    }

    std::optional<Layer> make(const SceneInterface& interface)
    {
        Layer layer;
        if (!has_soil(interface.regions[0]) || !has_soil(interface.regions[1])) return std::nullopt;
        layer.edge = common_edge(interface);
        if (layer.edge.empty()) return std::nullopt;
        const auto sliding = sliding_region(interface);
        if (!sliding) return std::nullopt;
        layer.region = *sliding;
        layer.place = interface.place;
        const Region& region = section_.regions[layer.region];
        layer.told.name = interface.name;
        layer.told.sliding = region.name;
        layer.told.beside = interface.regions[region.name == interface.regions[0] ? 1 : 0];
        double least = 0.0;
        layer.told.least_thickness = infinite;
        for (LayerEdge& edge : layer.edge) {
            least = std::max(least, least_thickness(edge.segment, problem_.grid));
            edge.thickness = interface.thickness.value_or(least_thickness(edge.segment, problem_.grid));
            layer.told.least_thickness = std::min(layer.told.least_thickness, edge.thickness);
            layer.told.thickness = std::max(layer.told.thickness, edge.thickness);
        }
        if (layer.told.thickness < least * (1.0 - 1e-9)) warn_of_thickness(interface, least);
        return add_material(interface, layer) ? std::optional(std::move(layer)) : std::nullopt;
    }

private:
    std::size_t index_of(const std::string& name) const
    {
        std::size_t r = 0;
        while (section_.regions[r].name != name) ++r;
        return r;
    }

    /// No: another stage places it.
    bool has_soil(const std::string& name) const
    {
        return !section_.regions[index_of(name)].polygons.empty();
    }

    std::vector<LayerEdge> common_edge(const SceneInterface& interface)
    {
        const std::size_t a = index_of(interface.regions[0]), b = index_of(interface.regions[1]);
        std::vector<LayerEdge> edge;
        std::set<std::string> neighbours; // of either region
        for (const RegionContact& contact : contacts_) {
            if (std::minmax(contact.left, contact.right) == std::minmax(a, b)) edge.push_back({contact.edge});
            if (contact.left == a || contact.right == a)
                neighbours.insert(section_.regions[contact.left + contact.right - a].name);
        }
        if (!edge.empty()) return edge;
        const std::vector<std::string> touching(neighbours.begin(), neighbours.end());
        findings_.add(error_at(
            interface.regions_place, "interface",
            fmt::format("the regions \"{}\" and \"{}\" do not touch", interface.regions[0],
                        interface.regions[1]),
            "two regions of the drawing with a common edge",
            touching.empty()
                ? fmt::format("\"{}\" touches no region: its edges must lie on those of its neighbours",
                              interface.regions[0])
                : fmt::format("\"{}\" touches {}", interface.regions[0], one_of(touching))));
        return edge;
    }

    const Material& material_of(std::size_t region) const
    {
        return problem_.materials[static_cast<std::size_t>(of_region_[region])];
    }

    /// Soil rather than a solid, and the first one of two.
    std::optional<std::size_t> sliding_region(const SceneInterface& interface)
    {
        std::optional<std::size_t> best;
        for (const std::string& name : interface.regions) {
            const std::size_t r = index_of(name);
            const Material& material = material_of(r);
            if (!has_strength(material.law)) continue;
            if (!best || (material.has_pores && !material_of(*best).has_pores)) best = r;
        }
        if (best) return best;
        std::vector<std::string> words;
        for (const SoilLaw& law : soil_laws())
            if (has_strength(law.form)) words.push_back("\"" + std::string(law.word) + "\"");
        findings_.add(
            error_at(interface.regions_place, "interface",
                     fmt::format("neither \"{}\" nor \"{}\" has a strength that the interface could lower",
                                 interface.regions[0], interface.regions[1]),
                     "a soil with model = " + one_of(words) + " on one side",
                     "elastic soil slides nowhere: give the one that is to slide a strength"));
        return std::nullopt;
    }

    void warn_of_thickness(const SceneInterface& interface, double least)
    {
        const std::string path = join_path({"interfaces", interface.name, "thickness"});
        findings_.add(warning_at(
            interface.thickness_place, path, "interface",
            path + " = " + number_text(*interface.thickness) +
                " m is less than the grid needs: the face slides with a part of the soil's own strength",
            "at least " + number_text(least) + " m", "remove it, or choose smaller cells"));
    }

    /// The strength of the interface, by its keys; none where it is no strength.
    std::optional<SlipStrength> strength_of(const SceneInterface& interface, const Material& soil)
    {
        if (interface.strength_ratio) {
            const SlipStrength own = *coulomb_strength(soil.law);
            return SlipStrength{*interface.strength_ratio * own.friction,
                                *interface.strength_ratio * own.cohesion};
        }
        if (interface.strength.friction > 0.0 || std::holds_alternative<MohrCoulomb>(soil.law))
            return interface.strength;
        findings_.add(
            error_at(interface.strength_place, "interface",
                     fmt::format("{} = 0 leaves \"{}\" no strength: sand has that of friction alone",
                                 join_path({"interfaces", interface.name, "friction_angle"}), soil.name),
                     "friction_angle above 0"));
        return std::nullopt;
    }

    bool add_material(const SceneInterface& interface, Layer& layer)
    {
        const auto source = static_cast<std::size_t>(of_region_[layer.region]);
        SceneMaterial copy = scene_.materials[source];
        const auto strength = strength_of(interface, copy.material);
        if (!strength) return false;
        const SlipStrength own = *slip_strength(copy.material.law);
        copy.material.law = slipping(copy.material.law, *strength);
        copy.material.name += "|" + layer.told.beside;
        layer.told.strength = *slip_strength(copy.material.law);
        layer.told.is_that_of_soil = layer.told.strength.friction < strength->friction * (1.0 - 1e-9);
        if (layer.told.is_that_of_soil && !interface.strength_ratio) warn_of_soil(interface, own);
        layer.material = static_cast<std::int32_t>(problem_.materials.size());
        problem_.materials.push_back(copy.material);
        scene_.materials.push_back(std::move(copy));
        return true;
    }

    void warn_of_soil(const SceneInterface& interface, const SlipStrength& own)
    {
        const std::string path = join_path({"interfaces", interface.name, "friction_angle"});
        const double degrees = std::atan(own.friction) * 180.0 / std::numbers::pi;
        findings_.add(
            warning_at(interface.strength_place, path, "interface",
                       path + " is more than the soil beside it bears along a plane: the soil slides itself",
                       fmt::format("less than {:.3g} deg for the face to be the weaker one", degrees),
                       "GUIDE, \"Structures\", says what soil bears along a plane"));
    }

    const Section& section_;
    const std::vector<std::int32_t>& of_region_;
    Scene& scene_;
    Problem& problem_;
    Diagnostics& findings_;
    std::vector<RegionContact> contacts_;
};

/// The layer of a domain, the nearest one that reaches it; none: it lies beside none.
Layer* layer_of(const ParticleDomain& domain, std::vector<Layer>& layers)
{
    Layer* best = nullptr;
    double least = infinite;
    for (Layer& layer : layers) {
        if (layer.region != domain.region) continue;
        const auto away = distance(layer, domain.centre);
        if (!away || *away >= least) continue;
        best = &layer;
        least = *away;
    }
    return best;
}

} // namespace

std::vector<std::int32_t> lay_interfaces(const Section& section, const Sampling& sampling,
                                         const std::vector<std::int32_t>& of_region, Scene& scene,
                                         Problem& problem, std::vector<InterfaceLayer>& told,
                                         Diagnostics& findings)
{
    std::vector<Layer> layers;
    if (!scene.interfaces.empty()) {
        LayerMaker maker(section, of_region, scene, problem, findings);
        for (const SceneInterface& interface : scene.interfaces)
            if (auto layer = maker.make(interface)) layers.push_back(std::move(*layer));
    }
    std::vector<std::int32_t> of_domain;
    for (const ParticleDomain& domain : sampling.domains) {
        Layer* layer = layer_of(domain, layers);
        of_domain.push_back(layer != nullptr ? layer->material : of_region[domain.region]);
        if (layer != nullptr) ++layer->told.particles;
    }
    for (const Layer& layer : layers) {
        told.push_back(layer.told);
        if (layer.told.particles > 0) continue;
        findings.add(error_at(layer.place, "interface",
                              "no particle lies within " + number_text(layer.told.thickness) +
                                  " m of the interface \"" + layer.told.name + "\"",
                              "", "a larger thickness, smaller cells or more particles_per_cell"));
    }
    return of_domain;
}

} // namespace quicksand
