#include "solver/verification/bodies/elastic_block.hpp"

#include "solver/base/failure.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

using Matrix2 = Eigen::Matrix2d;

/// The four nodes' functions at a point of the unit square, and their gradients in it.
struct Shape {
    double value[4];
    Vector2 gradient[4]; // per element edge [-]
};

Shape shape_at(double x, double y)
{
    return {{(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y},
            {{y - 1.0, x - 1.0}, {1.0 - y, -x}, {y, x}, {-y, 1.0 - x}}};
}

/// P of the deformation gradient [Pa].
Matrix2 first_stress(const NeoHookean& law, const Matrix2& F)
{
    const Matrix2 inverse_transposed = F.inverse().transpose();
    const double volumetric = lame_modulus(law) * std::log(F.determinant());
    return volumetric * inverse_transposed + law.shear_modulus * (F - inverse_transposed);
}

class ElementMesh {
public:
    ElementMesh(const SolidBody& body, const BlockSupports& supports, double gravity, int elements)
        : law_(body.law), lower_(body.lower), gravity_(gravity)
    {
        const Vector2 size = body.upper - body.lower;
        const double wanted = size.minCoeff() / elements;
        nx_ = std::max(1, static_cast<int>(std::lround(size.x() / wanted)));
        ny_ = std::max(1, static_cast<int>(std::lround(size.y() / wanted)));
        edges_ = {size.x() / nx_, size.y() / ny_};
        displacement_.assign(static_cast<std::size_t>((nx_ + 1) * (ny_ + 1)), Vector2::Zero());
        velocity_ = force_ = displacement_;
        mass_.assign(displacement_.size(), 0.0);
        const double fraction = 0.25 * body.density * edges_.x() * edges_.y();
        for_each_element([&](const std::size_t(&nodes)[4]) {
            for (const std::size_t i : nodes) mass_[i] += fraction;
        });
        hold(supports);
    }

    /// Half the time in which a wave of the stretched block crosses the shorter edge of an element. Waves in
    /// the reference configuration run at sqrt{[mu + (lambda (1 - ln J) + mu) / s^2] / rho_0} along a stretch
    /// s.
    double time_step(double density) const
    {
        double stiffest = 0.0;
        for_each_element([&](const std::size_t(&nodes)[4]) {
            const Matrix2 F = gradient_at(nodes, shape_at(0.5, 0.5));
            const double least = 1.0 / F.inverse().norm(); // no stretch is shorter
            const double lame = lame_modulus(law_) * std::max(0.0, 1.0 - std::log(F.determinant()));
            stiffest = std::max(stiffest, law_.shear_modulus + (lame + law_.shear_modulus) / (least * least));
        });
        return 0.5 * edges_.minCoeff() * std::sqrt(density / stiffest);
    }

    void advance(double velocity_dt, double dt)
    {
        std::fill(force_.begin(), force_.end(), Vector2(0.0, 0.0));
        for_each_element([&](const std::size_t(&nodes)[4]) { add_forces(nodes); });
        for (std::size_t i = 0; i < mass_.size(); ++i) {
            const Vector2 acceleration = force_[i] / mass_[i] - Vector2(0.0, gravity_);
            velocity_[i] += velocity_dt * acceleration.cwiseProduct(free_[i]);
            displacement_[i] += dt * velocity_[i];
        }
    }

    double vertical_displacement(const Vector2& point) const
    {
        const Vector2 place = (point - lower_).cwiseQuotient(edges_);
        const int i = std::clamp(static_cast<int>(place.x()), 0, nx_ - 1);
        const int j = std::clamp(static_cast<int>(place.y()), 0, ny_ - 1);
        const Shape shape = shape_at(place.x() - i, place.y() - j);
        std::size_t nodes[4];
        nodes_of(i, j, nodes);
        double sum = 0.0;
        for (int a = 0; a < 4; ++a) sum += shape.value[a] * displacement_[nodes[a]].y();
        return sum;
    }

private:
    std::size_t node(int i, int j) const { return static_cast<std::size_t>(j * (nx_ + 1) + i); }

    void nodes_of(int i, int j, std::size_t (&nodes)[4]) const
    {
        nodes[0] = node(i, j), nodes[1] = node(i + 1, j);
        nodes[2] = node(i + 1, j + 1), nodes[3] = node(i, j + 1);
    }

    template <class Work>
    void for_each_element(Work&& work) const
    {
        std::size_t nodes[4];
        for (int j = 0; j < ny_; ++j) {
            for (int i = 0; i < nx_; ++i) {
                nodes_of(i, j, nodes);
                work(nodes);
            }
        }
    }

    Matrix2 gradient_at(const std::size_t (&nodes)[4], const Shape& shape) const
    {
        Matrix2 F = Matrix2::Identity();
        for (int a = 0; a < 4; ++a)
            F += displacement_[nodes[a]] * shape.gradient[a].cwiseQuotient(edges_).transpose();
        return F;
    }

    void add_forces(const std::size_t (&nodes)[4])
    {
        const double near = 0.5 - std::sqrt(1.0 / 12.0), weight = 0.25 * edges_.x() * edges_.y();
        for (const double x : {near, 1.0 - near}) {
            for (const double y : {near, 1.0 - near}) {
                const Shape shape = shape_at(x, y);
                const Matrix2 P = first_stress(law_, gradient_at(nodes, shape));
                for (int a = 0; a < 4; ++a)
                    force_[nodes[a]] -= weight * (P * shape.gradient[a].cwiseQuotient(edges_));
            }
        }
    }

    void hold(const BlockSupports& supports)
    {
        free_.assign(displacement_.size(), Vector2::Ones());
        for (int j = 0; j <= ny_; ++j) {
            for (int i = 0; i <= nx_; ++i) {
                const bool on[4] = {i == 0, i == nx_, j == 0, j == ny_};
                for (int edge = 0; edge < 4; ++edge) {
                    if (on[edge] && supports.fixed_x[edge]) free_[node(i, j)].x() = 0.0;
                    if (on[edge] && supports.fixed_y[edge]) free_[node(i, j)].y() = 0.0;
                }
            }
        }
    }

    NeoHookean law_;
    Vector2 lower_, edges_; // [m]
    double gravity_;        // [m/s2]
    int nx_ = 0, ny_ = 0;   // elements
    std::vector<Vector2> displacement_, velocity_, force_, free_;
    std::vector<double> mass_; // [kg/m]
};

} // namespace

bool BlockSupports::any() const
{
    return std::any_of(fixed_y, fixed_y + 4, [](bool held) { return held; });
}

BlockSupports read_supports(const Problem& problem, const SolidBody& body)
{
    const double near = 1e-6 * problem.grid.cell_size;
    const Vector2 corners[4][2] = {{body.lower, {body.lower.x(), body.upper.y()}},
                                   {{body.upper.x(), body.lower.y()}, body.upper},
                                   {body.lower, {body.upper.x(), body.lower.y()}},
                                   {{body.lower.x(), body.upper.y()}, body.upper}};
    BlockSupports supports;
    for (const Boundary& boundary : problem.boundaries) {
        if (!is_standing_wall(boundary.soil)) continue;
        for (const Segment& segment : boundary.segments) {
            for (int edge = 0; edge < 4; ++edge) {
                const Vector2 &a = corners[edge][0], &b = corners[edge][1];
                const bool along = ((segment.start - a).norm() < near && (segment.end - b).norm() < near) ||
                                   ((segment.start - b).norm() < near && (segment.end - a).norm() < near);
                if (!along) continue;
                const bool upright = edge == BlockSupports::left || edge == BlockSupports::right;
                const bool fixed = std::holds_alternative<FixedWall>(boundary.soil);
                supports.fixed_x[edge] = supports.fixed_x[edge] || fixed || upright;
                supports.fixed_y[edge] = supports.fixed_y[edge] || fixed || !upright;
            }
        }
    }
    return supports;
}

Peak first_peak(const PointHistory& history)
{
    const std::vector<double>&t = history.time, &u = history.displacement;
    const auto lowest = static_cast<std::size_t>(std::min_element(u.begin(), u.end()) - u.begin());
    const double level = u[lowest] + 0.01 * std::abs(u[lowest]);
    std::size_t first = lowest, last = lowest;
    while (first > 0 && u[first - 1] <= level) --first;
    while (last + 1 < u.size() && u[last + 1] <= level) ++last;
    if (last + 1 == u.size() || last - first < 4) {
        throw InputError("the body does not swing back in time; is it held anywhere?");
    }
    // least squares about the lowest sample, in units of the width to keep the equations well scaled
    const double width = t[last] - t[first];
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = first; k <= last; ++k) {
        const double x = (t[k] - t[lowest]) / width;
        const Eigen::Vector3d powers(1.0, x, x * x);
        normal += powers * powers.transpose();
        right += u[k] * powers;
    }
    const Eigen::Vector3d c = normal.ldlt().solve(right);
    return {t[lowest] - 0.5 * c[1] / c[2] * width, u[lowest]};
}

double displacement_at(const PointHistory& history, double time)
{
    const auto after = std::upper_bound(history.time.begin(), history.time.end(), time);
    if (after == history.time.begin()) return history.displacement.front();
    if (after == history.time.end()) return history.displacement.back();
    const auto k = static_cast<std::size_t>(after - history.time.begin());
    const double fraction = (time - history.time[k - 1]) / (history.time[k] - history.time[k - 1]);
    return history.displacement[k - 1] + fraction * (history.displacement[k] - history.displacement[k - 1]);
}

PointHistory drop_block(const SolidBody& body, const BlockSupports& supports, double gravity, int elements,
                        const Vector2& point)
{
    if (!supports.any() || !(gravity > 0.0)) {
        throw InputError("the vibration needs gravity and an edge of the body that is held along its length");
    }
    ElementMesh mesh(body, supports, gravity, elements);
    PointHistory history{{0.0}, {0.0}};
    double last = 0.0, lowest = 0.0, lowest_at = 0.0;
    while (history.time.back() <= peak_margin * lowest_at || lowest_at == history.time.back()) {
        const double dt = mesh.time_step(body.density);
        mesh.advance(0.5 * (last + dt), dt); // velocities stand halfway between displacements
        last = dt;
        history.time.push_back(history.time.back() + dt);
        history.displacement.push_back(mesh.vertical_displacement(point));
        if (history.displacement.back() < lowest) {
            lowest = history.displacement.back();
            lowest_at = history.time.back();
        }
    }
    return history;
}

} // namespace quicksand
