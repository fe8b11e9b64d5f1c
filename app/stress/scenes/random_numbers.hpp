// Random numbers that are the same on every machine and with every library.
#pragma once

#include "solver/base/mixed_bits.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace quicksand {

/// The standard fixes the numbers of its engines, but not those of its distributions: these are our own.
class RandomNumbers {
public:
    /// The sequence of this number among those of a seed.
    RandomNumbers(std::uint64_t seed, std::uint64_t number) : engine_(mixed_bits(mixed_bits(seed) + number))
    {
    }

    /// Uniform in [0, 1).
    double fraction() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    /// Uniform in [low, high).
    double between(double low, double high) { return low + (high - low) * fraction(); }

    /// Its logarithm is uniform; both limits are positive.
    double logarithmic(double low, double high) { return low * std::pow(high / low, fraction()); }

    /// A whole number from low to high, both included.
    int whole(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }

    bool chance(double probability) { return fraction() < probability; }

    /// One of the choices, each as likely as the others.
    template <class Choice>
    Choice one_of(std::initializer_list<Choice> choices)
    {
        return choices.begin()[engine_() % choices.size()];
    }

private:
    std::mt19937_64 engine_;
};

} // namespace quicksand
