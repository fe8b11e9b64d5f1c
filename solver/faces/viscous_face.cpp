#include "solver/faces/viscous_face.hpp"

#include <cmath>

namespace quicksand {

GrainHold hold_of(const ViscousFace& face, const Segment& segment, Stage stage)
{
    if (stage != Stage::relaxation && lets_go(face)) return GrainHold::none;
    const Vector2 normal = outward_normal(segment);
    return std::abs(normal.y()) >= std::abs(normal.x()) ? GrainHold::all : GrainHold::normal;
}

std::optional<Impedance> impedance_beyond(const ViscousFace& face)
{
    if (!face.half_space) return std::nullopt;
    const HalfSpace& rock = *face.half_space;
    return Impedance{rock.density * rock.compression_wave_speed, rock.density * rock.shear_wave_speed};
}

} // namespace quicksand
