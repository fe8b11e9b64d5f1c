#include "solver/motion/slivers.hpp"

#include "solver/base/cross_product.hpp"

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace quicksand {

namespace {

constexpr double largest_fraction = 0.1; // of a box
constexpr double reach = 2.0;            // of a sliver to its carrier [boxes]

/// Boxes of a lattice with the particles whose centres lie in them.
class Neighbours {
public:
    Neighbours(const Particles& particles, double box) : particles_(particles), box_(box) {}

    void add(std::size_t p) { boxes_[box_of(particles_.position[p])].push_back(p); }

    std::optional<std::size_t> nearest(std::size_t sliver) const
    {
        const Vector2 centre = particles_.position[sliver];
        const auto [i, j] = box_of(centre);
        std::optional<std::size_t> best;
        double least = reach * reach * box_ * box_;
        for (int b = j - 2; b <= j + 2; ++b) {
            for (int a = i - 2; a <= i + 2; ++a) {
                const auto found = boxes_.find({a, b});
                if (found == boxes_.end()) continue;
                for (const std::size_t p : found->second) {
                    const double distance = (particles_.position[p] - centre).squaredNorm();
                    const bool alike = particles_.region[p] == particles_.region[sliver] &&
                                       particles_.material[p] == particles_.material[sliver];
                    if (!alike || distance >= least) continue;
                    best = p;
                    least = distance;
                }
            }
        }
        return best;
    }

private:
    std::pair<int, int> box_of(const Vector2& x) const
    {
        return {static_cast<int>(std::floor(x.x() / box_)), static_cast<int>(std::floor(x.y() / box_))};
    }

    const Particles& particles_;
    double box_; // [m]
    std::map<std::pair<int, int>, std::vector<std::size_t>> boxes_;
};

Eigen::Matrix2d frame_of(const Particles& particles, std::size_t p)
{
    Eigen::Matrix2d frame;
    frame << particles.half_edge_1[p], particles.half_edge_2[p];
    return frame;
}

/// Call visit(values) for what the soil of a particle is under and remembers.
template <class Visit>
void for_each_memory(Particles& particles, Visit&& visit)
{
    for_each_array(particles, [&](std::string_view name, Scalars& values) {
        if ((name.starts_with("stress") || name.starts_with("memory")) && !values.empty()) visit(values);
    });
}

/// Momentum that comes with water when a particle's pores grow by a volume [m3/m].
void enter_growth(const Problem& problem, const Particles& particles, std::size_t p, double growth,
                  BalanceTerms& terms)
{
    const Material& material = problem.materials[static_cast<std::size_t>(particles.material[p])];
    if (!water_of(problem, material) || water_flow(problem) == WaterFlow::undrained) return;
    const Vector2 momentum = problem.water->density * growth * velocity_of_water(particles, p);
    terms.exchange_x += momentum.x();
    terms.exchange_y += momentum.y();
}

} // namespace

std::vector<Sliver> find_slivers(const CutDomains& cut, const Particles& particles, double box_volume)
{
    std::vector<Sliver> slivers;
    if (!cut.has_pieces()) return slivers;
    const auto is_sliver = [&](std::size_t p) {
        return cut.is_piece(particles.identifier[p]) && particles.volume[p] < largest_fraction * box_volume;
    };
    Neighbours neighbours(particles, std::sqrt(box_volume));
    for (std::size_t p = 0; p < particles.size(); ++p)
        if (!is_sliver(p)) neighbours.add(p);
    for (std::size_t p = 0; p < particles.size(); ++p) {
        if (!is_sliver(p)) continue;
        const std::optional<std::size_t> carrier = neighbours.nearest(p);
        if (!carrier) continue;
        const Eigen::Matrix2d to_frame = frame_of(particles, *carrier).inverse();
        slivers.push_back({particles.identifier[p], particles.identifier[*carrier],
                           to_frame * (particles.position[p] - particles.position[*carrier]),
                           to_frame * frame_of(particles, p)});
    }
    return slivers;
}

void carry_slivers(const Problem& problem, ParticlePlaces& places, State& state)
{
    Particles& particles = state.particles;
    for (const Sliver& sliver : problem.cut_domains.slivers) {
        const std::size_t p = places.find(particles, sliver.identifier),
                          q = places.find(particles, sliver.carrier);
        const Eigen::Matrix2d frame = frame_of(particles, q), edges = frame * sliver.edges;
        particles.position.set(p, particles.position[q] + frame * sliver.centre);
        particles.half_edge_1.set(p, edges.col(0));
        particles.half_edge_2.set(p, edges.col(1));
        for_each_memory(particles, [&](Scalars& values) { values[p] = values[q]; });
        if (problem.strain == StrainForm::small) continue;
        const double before = particles.volume[p];
        particles.volume[p] = 4.0 * cross(particles.half_edge_1[p], particles.half_edge_2[p]);
        if (particles.porosity.empty()) continue;
        particles.porosity[p] = particles.porosity[q];
        if (state.balance_terms)
            enter_growth(problem, particles, p, particles.volume[p] - before, *state.balance_terms);
    }
}

} // namespace quicksand
