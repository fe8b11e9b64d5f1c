// A stage of a scene that has several: what is computed, and what counts from zero at its start.
#pragma once

#include "io/keys/source_place.hpp"

#include <optional>
#include <string>

namespace quicksand {

enum class StageKind {
    settle,      // damped, drained, under the water of its keys
    seepage,     // the same in the steady flow between the heads of the curves
    shake,       // the two-phase run under the base motion
    consolidate, // the two-phase run without motion, in steps that grow
    stability,   // the factor of safety with the pore pressures that there are
};

/// Whether the soil comes to rest in such a stage, which has no time.
inline bool settles(StageKind kind)
{
    return kind == StageKind::settle || kind == StageKind::seepage;
}

/// Whether soil and water move in time in such a stage.
inline bool takes_time(StageKind kind)
{
    return kind == StageKind::shake || kind == StageKind::consolidate;
}

struct SceneStage {
    std::string name; // of its results folder, within that of the run
    StageKind kind = StageKind::shake;
    bool keeps_pressures = false;        // settles undrained
    std::optional<double> flow_duration; // of seepage: the flow after it, none: the steady one [s]
    bool zero_displacements = false;     // displacements count from its start
    bool zero_pressures = false;         // ru and excess pore pressures count from its start
    double residual_strength = 0.0;      // S_r / sigma'_v0 of liquefied sand, 0: as its stresses allow [-]
    double liquefied_ru = 0.8;           // least ru of liquefied sand [-]
    double seismic_coefficient = 0.0;    // k_h [-]
    SourcePlace place;
};

} // namespace quicksand
