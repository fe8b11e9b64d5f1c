#include "solver/measure/point_sample.hpp"

#include "solver/base/failure.hpp"
#include "solver/base/slope_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quicksand {

namespace {

const std::vector<const Quantity*>& sampled()
{
    static const std::vector<const Quantity*> quantities = quantities_of(at_probes);
    return quantities;
}

/// du_x/dy + du_y/dx of the bilinear displacements in the point's cell [-].
double shear_strain(const BackgroundGrid& grid, const NodalFields& fields, const PointWeights& weights,
                    const Vector2& point)
{
    const std::vector<Scalars>& displacement = fields.find("displacement")->components;
    Vector2 centre = Vector2::Zero();
    for (const std::size_t node : weights.node) centre += 0.25 * grid.node_position(node);
    double strain = 0.0;
    for (const std::size_t node : weights.node) {
        // dN/dx = +-(1 - |y - y_i|/h)/h, dN/dy alike
        const Vector2 place = grid.node_position(node);
        const Vector2 fraction = Vector2::Ones() - (point - place).cwiseAbs() / grid.cell_size;
        const double slope_x = std::copysign(fraction.y() / grid.cell_size, place.x() - centre.x());
        const double slope_y = std::copysign(fraction.x() / grid.cell_size, place.y() - centre.y());
        strain += slope_y * displacement[0][node] + slope_x * displacement[1][node];
    }
    return strain;
}

/// A particle of the same soil near another one.
struct NearParticle {
    std::size_t index = 0;
    double weight =
        0.0;       // its volume times (1 - |x|/a)(1 - |y|/b), a and b the reach; the sum of all is 1 [-]
    Vector2 apart; // from the mean place of all [m]
};

/// How far along the axes particles near another one may lie: a cell, and beyond the next row of particles as
/// large as a cell [m].
Vector2 reach_of(const Problem& problem, const Particles& particles, std::size_t p)
{
    constexpr double of_its_size = 1.5;
    const double h = problem.grid.cell_size;
    const Vector2 size =
        2.0 * (particles.half_edge_1[p].cwiseAbs() + particles.half_edge_2[p].cwiseAbs()).cwiseMin(0.5 * h);
    return (of_its_size * size).cwiseMax(h);
}

std::vector<NearParticle> particles_near(const Problem& problem, const Particles& particles, std::size_t p)
{
    std::vector<NearParticle> found;
    double sum = 0.0;
    Vector2 centre = Vector2::Zero();
    const Vector2 reach = reach_of(problem, particles, p);
    for (std::size_t q = 0; q < particles.size(); ++q) {
        const Vector2 apart = particles.position[q] - particles.position[p];
        const Vector2 part = Vector2::Ones() - apart.cwiseAbs().cwiseQuotient(reach);
        if (part.minCoeff() <= 0.0 || particles.material[q] != particles.material[p]) continue;
        const double weight = particles.volume[q] * part.x() * part.y();
        found.push_back({q, weight, apart});
        sum += weight;
        centre += weight * apart;
    }
    for (NearParticle& near : found) {
        near.weight /= sum;
        near.apart -= centre / sum;
    }
    return found;
}

/// A plane through the values of the particles near p, by weighted least squares; exact where they are
/// linear.
struct FittedPlane {
    double value = 0.0;              // at p
    Vector2 slope = Vector2::Zero(); // [1/m]
};

FittedPlane fit_plane(const Problem& problem, const Particles& particles, std::size_t p,
                      const Quantity& quantity, std::size_t component,
                      const std::vector<NearParticle>& all_near)
{
    const auto value = [&](const NearParticle& near) {
        return quantity.value(problem, particles, near.index)[component];
    };
    double mean = 0.0;
    for (const NearParticle& near : all_near) mean += near.weight * value(near);
    SlopeFit fit;
    Vector2 to_particle = Vector2::Zero(); // from the mean place
    for (const NearParticle& near : all_near) {
        const double root = std::sqrt(near.weight);
        fit.add(root * near.apart, root * (value(near) - mean));
        if (near.index == p) to_particle = near.apart;
    }
    constexpr double distance = 1.0 / 3.0; // of the particles, about, from their mean place [cells]
    const Vector2 slope = fit.slope(distance * problem.grid.cell_size);
    return {mean + slope.dot(to_particle), slope};
}

QuantityValues fitted_value(const Problem& problem, const Particles& particles, std::size_t p,
                            const Quantity& quantity, const std::vector<NearParticle>& all_near)
{
    QuantityValues fitted{};
    for (std::size_t c = 0; c < component_count(quantity.form); ++c)
        fitted[c] = fit_plane(problem, particles, p, quantity, c, all_near).value;
    return fitted;
}

/// Of the particle p.
PointSample values_of(const Problem& problem, const Particles& particles, std::size_t p,
                      const std::vector<NearParticle>& all_near)
{
    PointSample sample;
    for (std::size_t k = 0; k < sampled().size(); ++k) {
        const Quantity& quantity = *sampled()[k];
        if (quantity.value == nullptr || !have(particles, quantity)) continue;
        sample.values[k] = quantity.scatters ? fitted_value(problem, particles, p, quantity, all_near)
                                             : quantity.value(problem, particles, p);
    }
    return sample;
}

/// The mean of the nodes around the point; `values` keeps what it has where the scene has no such field.
void average_at(const NodalFields& fields, const PointWeights& weights, const Quantity& quantity,
                QuantityValues& values)
{
    const NodalField* field = fields.find(quantity.name);
    if (field == nullptr) return;
    for (std::size_t c = 0; c < field->components.size(); ++c) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) sum += weights.weight[k] * field->components[c][weights.node[k]];
        values[c] = sum;
    }
}

} // namespace

PointSample::PointSample() : values(sampled().size(), QuantityValues{none, none, none, none}) {}

const QuantityValues& PointSample::operator[](std::string_view name) const
{
    const auto found = std::find_if(sampled().begin(), sampled().end(),
                                    [&](const auto* each) { return each->name == name; });
    ENSURE(found != sampled().end());
    return values[static_cast<std::size_t>(found - sampled().begin())];
}

QuantityValues& PointSample::operator[](std::string_view name)
{
    return const_cast<QuantityValues&>(std::as_const(*this)[name]);
}

PointSample sample_particle(const Problem& problem, const Particles& particles, std::size_t p)
{
    return values_of(problem, particles, p, particles_near(problem, particles, p));
}

PointSample sample_surface(const Problem& problem, const Particles& particles, std::size_t p,
                           const Vector2& point)
{
    const std::vector<NearParticle> near = particles_near(problem, particles, p);
    PointSample sample = values_of(problem, particles, p, near);
    const Vector2 apart = point - particles.position[p];
    for (const std::string_view motion : {"displacement", "total_displacement", "velocity_solid"}) {
        const Quantity& quantity = quantity_named(motion);
        if (!have(particles, quantity)) continue;
        for (std::size_t c = 0; c < component_count(quantity.form); ++c)
            sample[motion][c] += fit_plane(problem, particles, p, quantity, c, near).slope.dot(apart);
    }
    sample["position"] = {point.x(), point.y()};
    return sample;
}

PointSample sample_point(const Problem& problem, const NodalFields& fields, const Vector2& point)
{
    PointSample sample;
    const PointWeights weights = point_weights(problem.grid, fields, point);
    for (std::size_t k = 0; k < sampled().size(); ++k) {
        QuantityValues& values = sample.values[k];
        const FoundBy found_by = sampled()[k]->found_by;
        if (found_by == FoundBy::place) values = {point.x(), point.y()};
        if (!weights.inside) continue;
        if (found_by == FoundBy::average) average_at(fields, weights, *sampled()[k], values);
        if (found_by == FoundBy::slope) values[0] = shear_strain(problem.grid, fields, weights, point);
    }
    return sample;
}

PointSample interpolate(const PointSample& from, const PointSample& to, double weight)
{
    PointSample between;
    for (std::size_t k = 0; k < between.values.size(); ++k)
        for (std::size_t c = 0; c < between.values[k].size(); ++c)
            between.values[k][c] = std::lerp(from.values[k][c], to.values[k][c], weight);
    return between;
}

} // namespace quicksand
