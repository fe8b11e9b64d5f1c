#include "io/pictures/picture_field.hpp"

#include "solver/measure/quantities.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace quicksand {
namespace {

/// In words: as the table of quantities has it; what a soil law remembers by its name.
std::string label_of(const std::string& name)
{
    const QuantityComponent known = find_component(name);
    if (known.quantity != nullptr) return component_label(*known.quantity, known.component);
    std::string label = name;
    std::replace(label.begin(), label.end(), '_', ' ');
    if (!label.empty())
        label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    return label;
}

std::string unit_of(const ParticleFrame& frame, const std::string& name)
{
    const QuantityComponent known = find_component(name);
    if (known.quantity != nullptr) return std::string(drawn_unit(*known.quantity));
    const auto found = frame.units.find(name);
    return found == frame.units.end() || found->second == "-" ? "" : found->second;
}

bool may_be_negative(const std::string& name)
{
    const QuantityComponent known = find_component(name);
    return known.quantity == nullptr || known.quantity->range == QuantityRange::any;
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
        const ColourMap colours = may_be_negative(name) && takes_both_signs(scalar->second)
                                      ? ColourMap::diverging
                                      : ColourMap::sequential;
        return DrawnField{label_of(name), unit_of(frame, name), colours, scalar->second};
    }
    if (x == frame.scalars.end() || y == frame.scalars.end()) return std::nullopt;
    const Quantity& vector = *find_component(x->first).quantity;
    return DrawnField{std::string(vector.label), std::string(drawn_unit(vector)), ColourMap::sequential,
                      magnitudes(x->second, y->second)};
}

} // namespace quicksand
