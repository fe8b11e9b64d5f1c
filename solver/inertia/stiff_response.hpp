// Response of nodes whose grains have the inertia of their stiffness besides their masses.
//
// The water of a node is eliminated: its velocity is u = e v + q f_w, v that of the grains, f_w the impulse
// on the water, e the part of the grains' velocity that drag and seals hand on. The grains then answer
//   (M + b K) v + C^T l = f_s + e f_w            M: mass of the grains with what they carry along
//   C v - (C_w q C_w^T + d) l = - C_w q f_w      C = C_s + C_w e: rows of walls and followers, d: softness
// with b K of inertia_solve.hpp. The matrix is quasi-definite: it has a factor with the signs of
// its rows as long as a multiplier comes after the nodes of its row. The nodes are counted along the
// shorter side of the soil, so that the factor is narrow.
#pragma once

#include "solver/boundaries/boundary_conditions.hpp"
#include "solver/boundaries/node_response.hpp"
#include "solver/boundaries/viscous_boundary.hpp"
#include "solver/inertia/node_rows.hpp"
#include "solver/inertia/node_stiffness.hpp"
#include "solver/walls/velocity_rows.hpp"
#include "solver/water/banded_cholesky.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace quicksand {

/// What a node has along an axis, the water eliminated.
struct AxisShare {
    double mass = 0.0;     // M, 0: held [kg/m]
    double carried = 0.0;  // e [-]
    double mobility = 0.0; // q [m/kg]
};

inline AxisShare axis_share(const NodeResponse& response)
{
    if (response.solid == 0.0) return {0.0, 0.0, response.fluid};
    const double carried = response.exchange / response.solid;
    return {1.0 / response.solid, carried, response.fluid - carried * response.exchange};
}

/// What a node whose drag has axes of its own has between x and y besides.
struct MixedShare {
    std::size_t node = 0;
    AxisShare share;
};

/// Fluxes per force of the pressure [m/kg].
struct FluxParts {
    double of_water = 0.0;  // n^2 q: of the water beside held grains
    double of_grains = 0.0; // (1-n + n e)^2 / M: of the grains and the water that they carry
    double mobility = 0.0;  // 1 / M

    FluxParts& operator+=(const FluxParts& other)
    {
        of_water += other.of_water;
        of_grains += other.of_grains;
        mobility += other.mobility;
        return *this;
    }
};

class StiffResponse {
public:
    /// Find the shares of the nodes with is_active(node) from sums with tied nodes gathered; `velocity_dt` is
    /// the time over which forces act [s].
    template <class Sums, class IsActive>
    void set_shares(const NodeConditions& conditions, double velocity_dt, const std::vector<Sums>& sums,
                    IsActive&& is_active)
    {
        shares_.resize(2 * sums.size());
        mixed_.clear();
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const bool carries_sums = is_active(i) && conditions.master[i] == i;
            for (int axis = 0; axis < 2; ++axis)
                shares_[2 * i + static_cast<std::size_t>(axis)] =
                    carries_sums ? axis_share(response(sums[i], velocity_dt, conditions.of_node[i], axis))
                                 : AxisShare{};
            if (carries_sums && is_slanted(sums[i]))
                turn_shares(i, [&](double a, double b) { return tensor_along_grid(sums[i], a, b); });
        }
    }

    /// Factorise the equations of the nodes with shares; `factor` is b [s2].
    void factorise(const NodeConditions& conditions, double velocity_dt, double factor,
                   const std::vector<Dashpot>& dashpots, const VelocityRows& walls, const NodeRows& grid,
                   const NodeStiffness& stiffness);

    /// answer = v to impulses on the grains, by place; zero where they are held and at tied nodes. Add to
    /// `moving` the impulses that move the nodes alike without b K: M v + C^T l.
    void answer_impulses(const NodeRows& grid, double velocity_dt, const std::vector<Dashpot>& dashpots,
                         const Vectors& impulse, Vectors& answer, Vectors& moving);
    /// Whether the grains of a node move along an axis by equations of their own.
    bool moves(std::size_t node, std::size_t axis) const { return share(node, axis).mass > 0.0; }
    /// Whether their mass is so small beside b K that single precision leaves an error in b K v that would
    /// move them.
    bool is_light(std::size_t node, std::size_t axis) const
    {
        constexpr double part = 1e-3;
        const Unknown* u = unknown(node, axis);
        return u != nullptr && share(node, axis).mass * u->scale * u->scale < part;
    }

    /// Porosities of the nodes with soil, for answer_pressure(); zero without water.
    void set_porosities(Scalars porosities);
    /// What a force of the pressure moves at a node without b K, both axes together.
    FluxParts flux_parts(std::size_t node) const;
    /// flux = that of the nodes per time by forces of the pressure on the mixture; tied nodes excepted.
    void answer_pressure(const Scalars& force_x, const Scalars& force_y, Scalars& flux_x, Scalars& flux_y);

private:
    /// An unknown velocity of the grains.
    struct Unknown {
        std::size_t node = 0, place = 0, axis = 0;
        std::size_t equation = 0;
        double scale = 0.0; // 1 / sqrt(diagonal)
        double gain = 0.0;  // 1-n + n e: flux per velocity of the grains [-]
    };
    /// What a row has at a node.
    struct Part {
        std::size_t node = 0, row = 0;
        NodeVelocities coefficients;
    };

    /// What a force on a node gives to an equation, and an answer of it to the flux of the node.
    struct Exchange {
        std::uint32_t node = 0, axis = 0, equation = 0;
        double factor = 0.0;
    };

    /// What the order of the equations follows from.
    struct Pattern {
        std::vector<std::uint8_t> moves; // two of each node
        std::vector<std::pair<std::size_t, std::size_t>> row_nodes;
        std::size_t rows = 0;

        bool operator==(const Pattern&) const = default;
    };

    /// Turn the shares of a node along the axes of its drag to those of the grid.
    template <class Tensor>
    void turn_shares(std::size_t node, Tensor&& tensor)
    {
        AxisShare &x = shares_[2 * node], &y = shares_[2 * node + 1];
        MixedShare& mixed = mixed_.emplace_back();
        mixed.node = node;
        for (const auto value : {&AxisShare::mass, &AxisShare::carried, &AxisShare::mobility}) {
            const Eigen::Matrix2d turned = tensor(x.*value, y.*value);
            x.*value = turned(0, 0);
            y.*value = turned(1, 1);
            mixed.share.*value = turned(1, 0);
        }
    }
    /// That between x and y; zero where the drag has the axes of the grid.
    AxisShare mixed(std::size_t node) const
    {
        const auto found =
            std::lower_bound(mixed_.begin(), mixed_.end(), node,
                             [](const MixedShare& share, std::size_t other) { return share.node < other; });
        return found != mixed_.end() && found->node == node ? found->share : AxisShare{};
    }

    void note_parts(const VelocityRows& rows);
    void note_exchanges();
    Pattern present_pattern(std::size_t rows) const;
    void number_equations(const NodeConditions& conditions, const NodeRows& grid);
    template <class Visit>
    void for_each_of_stiffness(const NodeRows& grid, const NodeStiffness& stiffness, Visit&& visit) const;
    template <class Visit>
    void for_each_of_rows(Visit&& visit) const;
    template <class Visit>
    void for_each_of_masses(Visit&& visit) const;
    template <class Visit>
    void for_each_of_dashpots(double velocity_dt, const std::vector<Dashpot>& dashpots, Visit&& visit) const;
    const AxisShare& share(std::size_t node, std::size_t axis) const { return shares_[2 * node + axis]; }
    const Unknown* unknown(std::size_t node, std::size_t axis) const
    {
        const std::int32_t u = unknowns_[node][axis];
        return u < 0 ? nullptr : &list_[static_cast<std::size_t>(u)];
    }

    std::vector<AxisShare> shares_;                      // two of each node
    std::vector<MixedShare> mixed_;                      // of some nodes, in their order
    std::vector<std::array<std::int32_t, 2>> unknowns_;  // of each node, those of ties; -1: held, no soil
    std::vector<std::array<std::int32_t, 2>> equations_; // the same
    std::vector<Unknown> list_;                          // in the order of the equations
    std::vector<Part> parts_;                            // node by node, each row once
    std::vector<std::size_t> multipliers_;               // equations of the rows
    Pattern pattern_;                                    // for which the numbers of the equations hold
    std::vector<double> scale_;                          // of the equations; 0: a row that acts on nothing
    Scalars porosities_;                                 // of the nodes [-]
    Scalars own_x_, own_y_;                              // n^2 q: flux of the water alone per force [m/kg]
    std::vector<Exchange> of_grains_;                    // factors with the scale of their equations
    std::vector<Exchange> of_rows_;                      // of multipliers that move the water, likewise
    /// Single precision, or double where rows nearly repeat each other and in long steps.
    std::variant<BandedFactor<float>, BandedFactor<double>> factor_;
    Scalars vector_; // impulses by equation, then the solution, both scaled
};

} // namespace quicksand
