// Choices without branches, whose sides are both evaluated, so that loops over points make vectors of them;
// and inverses by fewer divisions.
#pragma once

namespace quicksand::ubcsand {

inline double select(bool condition, double yes, double no)
{
    return condition ? yes : no;
}
inline double larger(double a, double b)
{
    return a > b ? a : b;
}
inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

/// 1/a and 1/b.
struct Inverses {
    double of_a, of_b;
};

/// Both from one division, which holds a processor's divider for as long as many products take. The product
/// of a and b must be a normal number.
inline Inverses inverses(double a, double b)
{
    const double per_both = 1.0 / (a * b);
    return {b * per_both, a * per_both};
}

} // namespace quicksand::ubcsand
