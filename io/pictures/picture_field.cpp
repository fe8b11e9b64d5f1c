#include "io/pictures/picture_field.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace quicksand {
namespace {

struct FieldLabel {
    std::string_view name;
    std::string_view label;
};

// Only where the name with spaces is not label enough.
constexpr std::array labels{
    FieldLabel{"displacement_x", "Horizontal displacement"},
    FieldLabel{"displacement_y", "Vertical displacement, up"},
    FieldLabel{"velocity_solid", "Velocity of the grains"},
    FieldLabel{"velocity_solid_x", "Horizontal velocity of the grains"},
    FieldLabel{"velocity_solid_y", "Vertical velocity of the grains, up"},
    FieldLabel{"velocity_fluid", "Velocity of the water"},
    FieldLabel{"velocity_fluid_x", "Horizontal velocity of the water"},
    FieldLabel{"velocity_fluid_y", "Vertical velocity of the water, up"},
    FieldLabel{"ru", "Excess pore pressure ratio ru"},
    FieldLabel{"shear_strain", "Greatest shear strain"},
    FieldLabel{"stress_xx", "Effective stress xx, tension positive"},
    FieldLabel{"stress_yy", "Effective stress yy, tension positive"},
    FieldLabel{"stress_zz", "Effective stress zz, tension positive"},
    FieldLabel{"stress_xy", "Shear stress xy"},
};

std::string label_of(const std::string& name)
{
    const auto found = std::find_if(labels.begin(), labels.end(),
                                    [&name](const FieldLabel& entry) { return entry.name == name; });
    if (found != labels.end()) return std::string(found->label);
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    if (!label.empty())
        label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    return label;
}

std::string unit_of(const ParticleFrame& frame, const std::string& scalar, const std::string& name)
{
    if (name.ends_with("_strain")) return "%";
    const auto found = frame.units.find(scalar);
    return found == frame.units.end() || found->second == "-" ? "" : found->second;
}

/// The smaller side of zero has at least a twentieth of the larger one.
bool takes_both_signs(const std::vector<double>& values)
{
    double below = 0.0, above = 0.0;
    for (const double value : values) {
        if (value < 0.0) below = std::max(below, -value);
        if (value > 0.0) above = std::max(above, value);
    }
    return std::min(below, above) > 0.05 * std::max(below, above);
}

std::vector<double> magnitudes(const std::vector<double>& x, const std::vector<double>& y)
{
    std::vector<double> result(x.size());
    std::transform(x.begin(), x.end(), y.begin(), result.begin(),
                   [](double a, double b) { return std::hypot(a, b); });
    return result;
}

} // namespace

std::optional<DrawnField> drawn_field(const ParticleFrame& frame, const std::string& name)
{
    if (name == "velocity" || name.starts_with("velocity_x") || name.starts_with("velocity_y"))
        return drawn_field(frame, "velocity_solid" + name.substr(8));
    const auto scalar = frame.scalars.find(name);
    const auto x = frame.scalars.find(name + "_x"), y = frame.scalars.find(name + "_y");
    if (scalar != frame.scalars.end()) {
        const ColourMap colours =
            takes_both_signs(scalar->second) ? ColourMap::diverging : ColourMap::sequential;
        return DrawnField{label_of(name), unit_of(frame, name, name), colours, scalar->second};
    }
    if (x == frame.scalars.end() || y == frame.scalars.end()) return std::nullopt;
    return DrawnField{label_of(name), unit_of(frame, x->first, name), ColourMap::sequential,
                      magnitudes(x->second, y->second)};
}

} // namespace quicksand
