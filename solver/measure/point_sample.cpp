#include "solver/measure/point_sample.hpp"

#include "solver/base/failure.hpp"

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
    PointSample sample;
    for (std::size_t k = 0; k < sampled().size(); ++k) {
        const Quantity& quantity = *sampled()[k];
        if (quantity.value != nullptr && have(particles, quantity))
            sample.values[k] = quantity.value(problem, particles, p);
    }
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
