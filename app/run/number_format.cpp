#include "app/run/number_format.hpp"

#include <fmt/format.h>

#include <cmath>

namespace quicksand {

std::string short_number(double value, int digits)
{
    std::string text = fmt::format("{:.{}g}", value, digits);
    const std::size_t exponent = text.find('e');
    if (exponent == std::string::npos) return text;
    // 2.6e-06 -> 2.6e-6 and 1.9e+06 -> 1.9e6
    const int power = std::stoi(text.substr(exponent + 1));
    // 1.7e+02 -> 170: shorter, and read at once
    if (power > 0 && power < 4) return fmt::format("{:.0f}", std::stod(text));
    return fmt::format("{}e{}", text.substr(0, exponent), power);
}

std::string duration_text(double seconds)
{
    if (!std::isfinite(seconds) || seconds < 0.0) return "?";
    if (seconds < 9.95) return fmt::format("{:.1f}s", seconds);
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 60) return fmt::format("{}s", whole);
    if (whole < 3600) return fmt::format("{}m{:02}s", whole / 60, whole % 60);
    return fmt::format("{}h{:02}m", whole / 3600, whole / 60 % 60);
}

std::string bytes_text(double bytes)
{
    const char* const units[] = {"B", "kB", "MB", "GB", "TB"};
    int unit = 0;
    while (bytes >= 1000.0 && unit < 4) {
        bytes /= 1000.0;
        ++unit;
    }
    return fmt::format("{} {}", bytes < 99.5 ? fmt::format("{:.2g}", bytes) : fmt::format("{:.0f}", bytes),
                       units[unit]);
}

std::string grouped(long long count)
{
    std::string digits = std::to_string(count);
    const std::size_t first = digits.front() == '-' ? 1 : 0;
    for (std::size_t place = digits.size(); place > first + 3;) {
        place -= 3;
        digits.insert(place, ",");
    }
    return digits;
}

std::string threads_text(int count)
{
    return fmt::format("{} thread{}", count, count == 1 ? "" : "s");
}

} // namespace quicksand
