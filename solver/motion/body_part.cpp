#include "solver/motion/body_part.hpp"

#include <type_traits>
#include <utility>

namespace quicksand {

Particles part_of(const Particles& particles, const std::vector<std::size_t>& chosen)
{
    Particles part;
    const auto take = [&](const auto& values) {
        std::decay_t<decltype(values)> taken;
        if (!values.empty())
            for (const std::size_t p : chosen) taken.push_back(values[p]);
        return taken;
    };
    std::vector<Scalars> arrays;
    for_each_array(particles, [&](const char*, const Scalars& values) { arrays.push_back(take(values)); });
    part.memory.resize(particles.memory.size());
    std::size_t k = 0;
    for_each_array(part, [&](const char*, Scalars& values) { values = std::move(arrays[k++]); });
    part.material = take(particles.material);
    part.region = take(particles.region);
    for (std::size_t n = 0; n < chosen.size(); ++n) part.identifier.push_back(static_cast<std::int32_t>(n));
    return part;
}

std::map<std::int32_t, std::int32_t> numbers_in_part(const Particles& particles,
                                                     const std::vector<std::size_t>& chosen)
{
    std::map<std::int32_t, std::int32_t> number;
    for (const std::size_t p : chosen)
        number.emplace(particles.identifier[p], static_cast<std::int32_t>(number.size()));
    return number;
}

bool take_part(const Particles& particles, const std::vector<std::size_t>& chosen, CutDomains& cut)
{
    const auto number = numbers_in_part(particles, chosen);
    CutDomains part;
    for (const std::size_t p : chosen)
        if (cut.has_pieces()) part.pieces.push_back(cut.is_piece(particles.identifier[p]) ? 1 : 0);
    for (Sliver sliver : cut.slivers) {
        const auto own = number.find(sliver.identifier), carrier = number.find(sliver.carrier);
        if (own == number.end()) continue;
        if (carrier == number.end()) return false;
        sliver.identifier = own->second;
        sliver.carrier = carrier->second;
        part.slivers.push_back(sliver);
    }
    cut = std::move(part);
    return true;
}

} // namespace quicksand
