#include "solver/verification/anura_column_study.hpp"
#include "solver/verification/biot_waves_study.hpp"
#include "solver/verification/griffiths_lane_study.hpp"
#include "solver/verification/periodic_column_study.hpp"
#include "solver/verification/permeability_study.hpp"
#include "solver/verification/terzaghi_study.hpp"
#include "solver/verification/transient_column_study.hpp"
#include "solver/verification/study.hpp"

namespace quicksand {

const std::vector<Study>& studies()
{
    static const std::vector<Study> all = {
        {"anura_column", "Terzaghi 1923", anura_column_study},
        {"biot_waves", "Biot 1956", biot_waves_study},
        {"griffiths_lane", "Griffiths & Lane 1999", griffiths_lane_study},
        {"periodic_column", "Zienkiewicz, Chang & Bettess 1980", periodic_column_study},
        {"permeability", "Biot 1956", permeability_study},
        {"terzaghi", "Terzaghi 1923", terzaghi_study},
        {"terzaghi_quasi_static", "Terzaghi 1923", terzaghi_quasi_static_study},
        {"transient_column", "de Boer, Ehlers & Liu 1993; Laplace transform", transient_column_study},
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
