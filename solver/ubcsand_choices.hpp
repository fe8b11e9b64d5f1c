// Choices without branches: both sides are evaluated, so that loops over points make vectors of them.
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

} // namespace quicksand::ubcsand
