#include "solver/verification/biot_waves_study.hpp"
#include "solver/verification/griffiths_lane_study.hpp"
#include "solver/verification/permeability_study.hpp"
#include "solver/verification/study.hpp"

namespace quicksand {

const std::vector<Study>& studies()
{
    static const std::vector<Study> all = {
        {"biot_waves", "Biot 1956", biot_waves_study},
        {"griffiths_lane", "Griffiths & Lane 1999", griffiths_lane_study},
        {"permeability", "Biot 1956", permeability_study},
    };
    return all;
}

const Study* find_study(std::string_view name)
{
    for (const Study& study : studies()) {
        if (study.name == name) return &study;
    }
    return nullptr;
}

} // namespace quicksand
