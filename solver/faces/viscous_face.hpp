// A face that waves leave through, into rock or into soil like that beside it (viscous_boundary.hpp). While
// the soil settles, and over long times, it is held: a base fixed, a steep side as a roller.
#pragma once

#include "solver/faces/face_interface.hpp"

#include <optional>

namespace quicksand {

/// Rock or soil that goes on beyond a viscous boundary.
struct HalfSpace {
    double density = 0.0;                // rho [kg/m3]
    double shear_wave_speed = 0.0;       // V_s [m/s]
    double compression_wave_speed = 0.0; // V_p [m/s]
};

struct ViscousFace {
    std::optional<HalfSpace> half_space = {}; // none: as the soil beside it
    FaceHold held = FaceHold::while_settling;
};

GrainHold hold_of(const ViscousFace& face, const Segment& segment, Stage stage);

inline bool lets_go(const ViscousFace& face)
{
    return face.held != FaceHold::always;
}

inline bool absorbs_waves(const ViscousFace& face)
{
    return face.held != FaceHold::always;
}

std::optional<Impedance> impedance_beyond(const ViscousFace& face);

} // namespace quicksand
