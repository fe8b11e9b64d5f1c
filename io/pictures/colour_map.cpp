#include "io/pictures/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quicksand {
namespace {

constexpr std::size_t table_size = 33;
using ColourTable = std::array<std::uint32_t, table_size>; // 0xRRGGBB, evenly spaced

// Every eighth entry of viridis by S. van der Walt and N. Smith (public domain, CC0).
constexpr ColourTable viridis{0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086,
                              0x3f4989, 0x3b528b, 0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e,
                              0x26818e, 0x23898e, 0x21908c, 0x1f988b, 0x1f9f88, 0x21a685, 0x28ae80,
                              0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c, 0x96d83f,
                              0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725};

// CIE L* falls linearly from 93 in the middle to 25 at both ends.
constexpr ColourTable blue_to_red{0x08387a, 0x1d4285, 0x2c4b91, 0x39559c, 0x475fa6, 0x546aaf, 0x6275b8,
                                  0x6f7fc0, 0x7d8bc7, 0x8b96cd, 0x99a1d3, 0xa7add8, 0xb4b9dd, 0xc2c5e1,
                                  0xd0d2e4, 0xdddee8, 0xebebeb, 0xebdcdb, 0xeaccca, 0xe8bdbb, 0xe5aeab,
                                  0xe29f9c, 0xdd918e, 0xd78280, 0xd07473, 0xc86666, 0xbf595a, 0xb54c4f,
                                  0xab3f44, 0x9f333a, 0x932730, 0x871a27, 0x7a0a1f};

Colour unpack(std::uint32_t code)
{
    const auto part = [code](int shift) { return static_cast<double>((code >> shift) & 0xffu) / 255.0; };
    return {part(16), part(8), part(0)};
}

} // namespace

Colour map_colour(ColourMap map, double fraction)
{
    if (std::isnan(fraction)) return undefined_colour;
    const ColourTable& table = map == ColourMap::sequential ? viridis : blue_to_red;
    const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(table_size - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), table_size - 2);
    const double part = place - static_cast<double>(below);
    const Colour a = unpack(table[below]);
    const Colour b = unpack(table[below + 1]);
    return {std::lerp(a.red, b.red, part), std::lerp(a.green, b.green, part),
            std::lerp(a.blue, b.blue, part)};
}

std::string hex_code(const Colour& colour)
{
    const auto byte = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green), byte(colour.blue));
}

} // namespace quicksand
