#include "geometry/region_overlay.hpp"

namespace quicksand {

std::vector<OutlineFault> find_outline_faults(const Section&)
{
    return {};
}

} // namespace quicksand
