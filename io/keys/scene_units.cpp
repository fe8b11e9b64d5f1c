#include "io/keys/scene_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

/// 2.2e+09 reads better as 2.2e9, 1e-05 as 1e-5.
std::string shorten_exponent(std::string text)
{
    const auto exponent = text.find('e');
    if (text[exponent + 1] == '+') text.erase(exponent + 1, 1);
    const auto digits = exponent + (text[exponent + 1] == '-' ? 2U : 1U);
    while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
    return text;
}

} // namespace

const std::vector<Unit>& units_of(Dimension dimension)
{
    static const std::vector<Unit> none = {{"%", 1.0, 100.0}};
    static const std::vector<Unit> length = {{"m"}, {"cm", 1.0, 1e2}, {"mm", 1.0, 1e3}};
    static const std::vector<Unit> time = {{"s"},         {"ms", 1.0, 1e3}, {"us", 1.0, 1e6}, {"min", 60.0},
                                           {"h", 3600.0}, {"day", 86400.0}, {"d", 86400.0}};
    static const std::vector<Unit> frequency = {{"Hz"}, {"kHz", 1e3}, {"1/s"}};
    static const std::vector<Unit> acceleration = {
        {"m/s2"}, {"m/s^2"}, {"cm/s2", 1.0, 1e2}, {"g", standard_gravity}};
    static const std::vector<Unit> velocity = {
        {"m/s"}, {"cm/s", 1.0, 1e2}, {"mm/s", 1.0, 1e3}, {"m/day", 1.0, 86400.0}, {"m/d", 1.0, 86400.0}};
    static const std::vector<Unit> density = {{"kg/m3"}, {"kg/m^3"}, {"t/m3", 1e3}, {"g/cm3", 1e3}};
    static const std::vector<Unit> pressure = {{"Pa"}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}};
    static const std::vector<Unit> angle = {{"deg"}, {"rad", 180.0, std::numbers::pi}};
    switch (dimension) {
    case Dimension::none:
        return none;
    case Dimension::length:
        return length;
    case Dimension::time:
        return time;
    case Dimension::frequency:
        return frequency;
    case Dimension::acceleration:
        return acceleration;
    case Dimension::velocity:
        return velocity;
    case Dimension::density:
        return density;
    case Dimension::pressure:
        return pressure;
    case Dimension::angle:
        return angle;
    }
    return none;
}

std::string_view si_symbol(Dimension dimension)
{
    return dimension == Dimension::none ? "" : units_of(dimension).front().symbol;
}

std::optional<WrittenQuantity> split_quantity(std::string_view text)
{
    const auto trim = [](std::string_view part) {
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        return part;
    };
    text = trim(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    WrittenQuantity quantity;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quantity.number);
    if (error != std::errc() || !std::isfinite(quantity.number)) return std::nullopt;
    quantity.unit = trim(text.substr(static_cast<std::size_t>(end - text.data())));
    return quantity;
}

std::optional<double> to_si(const WrittenQuantity& quantity, Dimension dimension)
{
    for (const Unit& unit : units_of(dimension)) {
        if (unit.symbol == quantity.unit) return quantity.number * unit.multiply / unit.divide;
    }
    return std::nullopt;
}

std::string number_text(double number)
{
    if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number > 0.0 ? "inf" : "-inf";
    const double size = std::abs(number);
    const bool far_from_one = size != 0.0 && (size >= 1e5 || size < 1e-3);
    std::array<char, 400> buffer{};
    char* const begin = buffer.data();
    const auto format = far_from_one ? std::chars_format::scientific : std::chars_format::fixed;
    const std::string text(begin, std::to_chars(begin, begin + buffer.size(), number, format).ptr);
    return far_from_one ? shorten_exponent(text) : text;
}

std::string coordinate_text(double x)
{
    const int whole_digits = x == 0.0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(x)))) + 1;
    constexpr int least = 4, decimals = 2; // digits
    return fmt::format("{:.{}g}", x, std::max(least, whole_digits + decimals));
}

std::string place_text(const Vector2& place)
{
    return "(" + coordinate_text(place.x()) + ", " + coordinate_text(place.y()) + ")";
}

std::string three_digits(double number)
{
    return fmt::format("{:.3g}", number);
}

std::string six_digits(double number)
{
    return fmt::format("{:.6g}", number);
}

std::string time_text(double seconds)
{
    constexpr double hour = 3600.0, day = 24.0 * hour;
    const double size = std::abs(seconds);
    if (size < 2.0 * hour) return fmt::format("{:.4g} s", seconds);
    if (size < 2.0 * day) return fmt::format("{:.4g} h", seconds / hour);
    return fmt::format("{:.4g} d", seconds / day);
}

std::string quantity_text(double number, Dimension dimension)
{
    const std::string_view unit = si_symbol(dimension);
    return unit.empty() ? number_text(number) : number_text(number) + " " + std::string(unit);
}

} // namespace quicksand
