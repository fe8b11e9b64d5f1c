#include "solver/verification/studies/anura_column_study.hpp"
#include "solver/verification/studies/biot_waves_study.hpp"
#include "solver/verification/studies/collapse_study.hpp"
#include "solver/verification/studies/griffiths_lane_study.hpp"
#include "solver/verification/studies/large_strain_consolidation_study.hpp"
#include "solver/verification/studies/mandel_study.hpp"
#include "solver/verification/studies/manufactured_study.hpp"
#include "solver/verification/studies/periodic_column_study.hpp"
#include "solver/verification/studies/permeability_study.hpp"
#include "solver/verification/studies/shear_beam_study.hpp"
#include "solver/verification/studies/study.hpp"
#include "solver/verification/studies/terzaghi_study.hpp"
#include "solver/verification/studies/transient_column_study.hpp"
#include "solver/verification/studies/vibration_study.hpp"

#include <utility>

namespace quicksand {

namespace {

/// A study that reads all it needs off the problem.
template <std::vector<StudyError> (*measure)(const Problem&, State)>
std::vector<StudyError> without_parameters(const Problem& problem, State state, const StudyParameters&)
{
    return measure(problem, std::move(state));
}

} // namespace

const std::vector<Study>& studies()
{
    static const std::vector<Study> all = {
        {"anura_column", "Terzaghi 1923", without_parameters<anura_column_study>},
        {"axis_aligned", "Wallstedt & Guilkey 2008", axis_aligned_study},
        {"biot_waves", "Biot 1956", without_parameters<biot_waves_study>},
        {"collapse", "Lube et al. 2005", without_parameters<collapse_study>},
        {"griffiths_lane", "Griffiths & Lane 1999", without_parameters<griffiths_lane_study>},
        {"large_strain_consolidation", "Xie & Leo 2004",
         without_parameters<large_strain_consolidation_study>},
        {"largest_vortex", "Kamojjala et al. 2015", largest_vortex_study},
        {"mandel", "Mandel 1953; Cheng & Detournay 1988", without_parameters<mandel_study>},
        {"periodic_column", "Zienkiewicz, Chang & Bettess 1980", without_parameters<periodic_column_study>},
        {"permeability", "Biot 1956", without_parameters<permeability_study>},
        {"shear_beam", "shear beam with dragged water", without_parameters<shear_beam_study>},
        {"terzaghi", "Terzaghi 1923", without_parameters<terzaghi_study>},
        {"transient_column", "de Boer, Ehlers & Liu 1993; Laplace transform",
         without_parameters<transient_column_study>},
        {"vibration", "finite elements", without_parameters<vibration_study>},
        {"vortex", "Kamojjala et al. 2015", vortex_study},
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
