// What a probe records at one moment, from a particle or from the nodal fields.
#pragma once

#include "solver/measure/nodal_fields.hpp"
#include "solver/measure/quantities.hpp"

#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace quicksand {

/// Values of one point of the quantities at probes, in their order; NaN means none, as outside the soil.
class PointSample {
public:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    PointSample();
    /// Of a quantity at probes, by its name.
    const QuantityValues& operator[](std::string_view name) const;
    QuantityValues& operator[](std::string_view name);
    Vector2 vector(std::string_view name) const { return {(*this)[name][0], (*this)[name][1]}; }

    std::vector<QuantityValues> values;
};

/// The particle's own values; of quantities that scatter those of a plane through the particles of its soil
/// within a cell around it.
PointSample sample_particle(const Problem& problem, const Particles& particles, std::size_t p);

/// The motion of a point of the surface on the domain of particle p, which lies a part of a cell below it:
/// the particle's own plus the slope, of a plane through the particles of its soil within a cell around it,
/// times the way to the point. All other values are the particle's.
PointSample sample_surface(const Problem& problem, const Particles& particles, std::size_t p,
                           const Vector2& point);

/// Bilinear values of the nodal fields at a point; only the position where there is no soil.
PointSample sample_point(const Problem& problem, const NodalFields& fields, const Vector2& point);

/// The sample between two of the same point, a part `weight` of the way from the first; of components that
/// one of them lacks there is none.
PointSample interpolate(const PointSample& from, const PointSample& to, double weight);

} // namespace quicksand
