// Eight numbers of single precision worked on together: enough for preconditioners.
#pragma once

#include <cstddef>
#include <cstring>

namespace quicksand {

template <class Number>
struct EightOf {
    using Type __attribute__((vector_size(8 * sizeof(Number)))) = Number;
};
/// Eight numbers, float or double.
template <class Number>
using Eight = typename EightOf<Number>::Type;
using Singles = Eight<float>;

template <class Number>
Eight<Number> load(const Number* from)
{
    Eight<Number> eight;
    std::memcpy(&eight, from, sizeof eight);
    return eight;
}

template <class Number>
void store(const Eight<Number>& eight, Number* to)
{
    std::memcpy(to, &eight, sizeof eight);
}

inline float sum_of(const Singles& s)
{
    return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

/// Sum of a[k] b[k] over `count` numbers.
inline float dot(const float* a, const float* b, std::size_t count)
{
    Singles even{}, odd{};
    std::size_t k = 0;
    for (; k + 16 <= count; k += 16) {
        even += load(a + k) * load(b + k);
        odd += load(a + k + 8) * load(b + k + 8);
    }
    if (k + 8 <= count) {
        even += load(a + k) * load(b + k);
        k += 8;
    }
    float sum = sum_of(even + odd);
    for (; k < count; ++k) sum += a[k] * b[k];
    return sum;
}

} // namespace quicksand
