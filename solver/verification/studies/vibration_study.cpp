#include "solver/verification/studies/vibration_study.hpp"

#include "solver/run/simulation.hpp"
#include "solver/verification/bodies/elastic_block.hpp"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

constexpr int elements = 24; // across the shorter side; 0.1 % from the limit of the bar and the cantilever

/// The point that the study follows: the middle of the edge opposite the held one.
Vector2 followed_point(const SolidBody& body, const BlockSupports& supports)
{
    const Vector2 middle = 0.5 * (body.lower + body.upper);
    if (supports.fixed_y[BlockSupports::top]) return {middle.x(), body.lower.y()};
    if (supports.fixed_y[BlockSupports::left]) return {body.upper.x(), middle.y()};
    if (supports.fixed_y[BlockSupports::right]) return {body.lower.x(), middle.y()};
    return {middle.x(), body.upper.y()};
}

/// Lasting number of the particle nearest to a point of the reference.
std::int32_t nearest_particle(const Particles& particles, const Vector2& point)
{
    std::size_t nearest = 0;
    for (std::size_t p = 1; p < particles.size(); ++p) {
        if ((particles.reference_position[p] - point).norm() <
            (particles.reference_position[nearest] - point).norm())
            nearest = p;
    }
    return particles.identifier[nearest];
}

std::size_t place_of(const Particles& particles, std::int32_t identifier)
{
    const auto found = std::find(particles.identifier.begin(), particles.identifier.end(), identifier);
    return static_cast<std::size_t>(found - particles.identifier.begin());
}

/// Records a particle's settlement at equal times.
class Follower : public Observer {
public:
    Follower(std::int32_t identifier, double interval) : identifier_(identifier), interval_(interval) {}
    double next_time() const override { return static_cast<double>(history.time.size()) * interval_; }
    void observe(const Problem&, const State& state, const StepReport&) override
    {
        const std::size_t p = place_of(state.particles, identifier_);
        history.displacement.push_back(state.particles.position.y[p] -
                                       state.particles.reference_position.y[p]);
        history.time.push_back(state.time);
    }
    PointHistory history;

private:
    std::int32_t identifier_;
    double interval_; // [s]
};

/// Root mean square of the difference over the samples of `history` [m].
double difference(const PointHistory& history, const PointHistory& reference)
{
    double squares = 0.0;
    for (std::size_t k = 0; k < history.time.size(); ++k) {
        const double apart = history.displacement[k] - displacement_at(reference, history.time[k]);
        squares += apart * apart;
    }
    return std::sqrt(squares / static_cast<double>(history.time.size()));
}

} // namespace

std::vector<StudyError> vibration_study(const Problem& problem, State state)
{
    const SolidBody body = read_neo_hookean_body(problem, state);
    const BlockSupports supports = read_supports(problem, body);
    Particles& particles = state.particles;
    const std::int32_t followed = nearest_particle(particles, followed_point(body, supports));
    const Vector2 point = particles.reference_position[place_of(particles, followed)];
    const PointHistory reference = drop_block(body, supports, problem.gravity, elements, point);
    const Peak exact = first_peak(reference);

    for (Scalars* stress : {&particles.stress.xx, &particles.stress.yy, &particles.stress.zz})
        std::fill(stress->begin(), stress->end(), 0.0);
    Follower follower(followed, exact.time / 100.0);
    run(problem, peak_margin * exact.time, {&follower}, state);
    const Peak measured = first_peak(follower.history);
    return {{"largest displacement", "relative", std::abs(measured.displacement / exact.displacement - 1.0)},
            {"time of the largest displacement", "relative", std::abs(measured.time / exact.time - 1.0)},
            {"displacement over the first swing", "root mean square / largest",
             difference(follower.history, reference) / std::abs(exact.displacement)}};
}

} // namespace quicksand
