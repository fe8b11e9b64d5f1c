// A million random steps of UBCSAND over zero and tensile stress, huge strains and pure rotation: the state
// stays finite and inside the failure limit, and plastic flow never gives energy back.
#include "solver/ubcsand/ubcsand.hpp"
#include "solver/ubcsand/ubcsand_attempt.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace quicksand {
namespace {

class RandomPath {
public:
    explicit RandomPath(unsigned seed) : random_(seed) {}

    /// A stress anywhere: usual, zero, tensile, beyond failure; the memory of a new point.
    UbcSandState start(const UbcSand& law)
    {
        UbcSandState state;
        const double kind = uniform();
        if (kind > 0.1) {
            const double size = std::pow(10.0, 1.0 + 5.0 * uniform()), sign = kind < 0.3 ? -1.0 : 1.0;
            state.sigma_x = sign * size * uniform();
            state.sigma_y = sign * size * uniform();
            state.sigma_z = sign * size * uniform();
            state.tau_xy = size * (uniform() - 0.5);
        }
        begin_shaking(law, state);
        return state;
    }

    /// A strain of 1e-8 to 3e-4, seldom huge, seldom a pure rotation; it keeps a direction for a while.
    UbcSandIncrement step()
    {
        if (uniform() < 0.02) direction_ = {normal(), normal(), 2.0 * normal(), 0.0};
        const double kind = uniform();
        if (kind < 0.01) return {0.0, 0.0, 0.0, 3.0 * normal()};
        if (kind < 0.011) return {};
        const double size =
            kind > 0.9999 ? std::pow(10.0, -2.0 + 2.0 * uniform()) : std::pow(10.0, -8.0 + 4.5 * uniform());
        const double volume = uniform() < 0.7 ? -0.5 * (direction_.strain_x + direction_.strain_y) : 0.0;
        return {size * (direction_.strain_x + volume), size * (direction_.strain_y + volume),
                size * direction_.shear, size * normal()};
    }

    double uniform() { return uniform_(random_); }

private:
    double normal() { return normal_(random_); }

    std::mt19937 random_;
    std::uniform_real_distribution<double> uniform_{0.0, 1.0};
    std::normal_distribution<double> normal_;
    UbcSandIncrement direction_{0.0, 0.0, 1.0, 0.0};
};

/// Plastic work of a substep, t lambda + s D lambda, over its size s lambda [-].
double dissipation(const ubcsand::PlasticFlow& flow)
{
    const double D = flow.lambda > 0.0 ? flow.contraction / flow.lambda : 0.0;
    return std::min(flow.lambda, flow.t / flow.s + D);
}

/// Advance as `update` does, substep by substep; the least dissipation.
double least_in_first_order(const UbcSand& law, ubcsand::Strain remaining, UbcSandState& state)
{
    using namespace ubcsand;
    double least = 0.0, fraction = 0.0;
    for (double budget = most_substeps; budget > 0.0 && fraction < 1.0; budget -= 1.0) {
        const Start start = start_of<ElasticForm::square_roots>(law, state);
        fraction = fixed_fraction(law, start, remaining, budget);
        const Strain strain = part_of(remaining, fraction);
        const Trial trial =
            elastic_trial<Integration::first_order, ElasticForm::square_roots>(law, state, start, strain);
        if (trial.plastic) {
            least = std::min(least, dissipation(finish_in_first_order<Locking::none>(law, trial, state)));
        } else {
            finish_elastic(law, trial, state);
        }
        remaining = rest_of(remaining, strain);
    }
    return least;
}

/// The same for substeps of second order, which may have to be tried again.
double least_in_second_order(const UbcSand& law, ubcsand::Strain remaining, UbcSandState& state)
{
    using namespace ubcsand;
    double least = 0.0, fraction = 1.0, size = 1.0;
    for (double budget = most_substeps + 1.0; budget > 0.0; budget -= 1.0) {
        const bool whole = budget > most_substeps;
        const Start start = start_of<ElasticForm::square_roots>(law, state);
        if (!whole) fraction = next_fraction(law, start, state, remaining, size, budget);
        const Strain strain = part_of(remaining, fraction);
        const Trial trial =
            elastic_trial<Integration::second_order, ElasticForm::square_roots>(law, state, start, strain);
        const Events events = whole ? events_of(law, trial, state) : Events{0.0, 0.0};
        UbcSandState next = state;
        double error = 0.0, dissipated = 0.0;
        if (trial.plastic) {
            dissipated = dissipation(finish_in_second_order<Locking::none>(law, trial, next, error));
        } else {
            finish_elastic(law, trial, next);
        }
        const Verdict verdict = trial.plastic
                                    ? judge_plastic<Locking::none>(law, trial, error, events.plastic, next)
                                    : judge_elastic(law, trial, events.elastic);
        size = next_size(verdict, fraction);
        if (!verdict.stands() && budget > 1.0) continue;
        state = next;
        least = std::min(least, dissipated);
        if (fraction >= 1.0) break;
        remaining = rest_of(remaining, strain);
    }
    return least;
}

double least_dissipation(const UbcSand& law, const UbcSandIncrement& increment, UbcSandState& state)
{
    turn(increment.spin, state);
    const ubcsand::Strain strain = {increment.strain_x, increment.strain_y, increment.shear};
    return law.integration == Integration::first_order ? least_in_first_order(law, strain, state)
                                                       : least_in_second_order(law, strain, state);
}

double beyond_failure(const UbcSand& law, const UbcSandState& state)
{
    const double s = 0.5 * (state.sigma_x + state.sigma_y);
    const double t = std::hypot(0.5 * (state.sigma_x - state.sigma_y), state.tau_xy);
    return t / (law.eta_f * (s + law.a)) - 1.0;
}

bool sound(const UbcSand& law, const UbcSandState& state)
{
    const double all[] = {state.sigma_x,  state.sigma_y,     state.sigma_z,        state.tau_xy,
                          state.eta_max,  state.branch,      state.peak_x,         state.peak_y,
                          state.origin_x, state.origin_y,    state.leg_x,          state.leg_y,
                          state.back_x,   state.back_y,      state.last_leg,       state.waiting,
                          state.dilation, state.half_cycles, state.active_dilation};
    for (const double value : all) {
        if (!std::isfinite(value)) return false;
    }
    return 0.5 * (state.sigma_x + state.sigma_y) >= law.s_min * (1.0 - 1e-12) && state.sigma_z > 0.0;
}

void expect_sound_path(const UbcSandParameters& parameters, unsigned seed, int steps)
{
    const UbcSand law = make_ubcsand(parameters);
    RandomPath path(seed);
    UbcSandState state = path.start(law), twin;
    double farthest = -1.0, least = 0.0;
    int unsound = 0, different = 0;
    for (int step = 0; step < steps; ++step) {
        if (path.uniform() < 1e-3) state = path.start(law);
        const UbcSandIncrement increment = path.step();
        const bool compare = step % 8 == 0;
        twin = state;
        least = std::min(least, least_dissipation(law, increment, state));
        farthest = std::max(farthest, beyond_failure(law, state));
        if (!sound(law, state)) ++unsound;
        if (!compare) continue;
        update(law, increment, twin);
        if (std::memcmp(&twin, &state, sizeof state) != 0) ++different;
    }
    EXPECT_EQ(unsound, 0);
    EXPECT_EQ(different, 0); // what was checked is the law
    EXPECT_LT(farthest, 1e-9);
    EXPECT_GE(least, -1e-12) << static_cast<int>(law.integration);
}

TEST(UbcSandFuzz, MediumSandStaysSoundOnARandomPath)
{
    expect_sound_path(with(UbcSandRunSettings(), nevada_sand_55()), 1, 400000);
}

TEST(UbcSandFuzz, LooseSandStaysSoundOnARandomPath)
{
    expect_sound_path(ubcsand_from_blow_count(4.0), 2, 200000);
}

TEST(UbcSandFuzz, DenseSandStaysSoundOnARandomPath)
{
    expect_sound_path(ubcsand_from_blow_count(30.0), 3, 200000);
}

TEST(UbcSandFuzz, SandOfRunsStaysSoundForOtherDensities)
{
    expect_sound_path(with(UbcSandRunSettings(), ubcsand_from_blow_count(4.0)), 5, 100000);
    expect_sound_path(with(UbcSandRunSettings(), ubcsand_from_blow_count(30.0)), 6, 100000);
}

TEST(UbcSandFuzz, CohesiveSandStaysSoundOnARandomPath)
{
    UbcSandParameters parameters = nevada_sand_55();
    parameters.cohesion = 5e3;
    expect_sound_path(parameters, 4, 200000);
    expect_sound_path(with(UbcSandRunSettings(), parameters), 7, 100000);
}

} // namespace
} // namespace quicksand
