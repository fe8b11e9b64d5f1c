// Eight numbers of single precision worked on together: enough for preconditioners.
#pragma once

#include <cstddef>
#include <cstring>

namespace quicksand {

using Singles = float __attribute__((vector_size(32)));

inline Singles load(const float* from)
{
    Singles singles;
    std::memcpy(&singles, from, sizeof singles);
    return singles;
}

inline void store(const Singles& singles, float* to)
{
    std::memcpy(to, &singles, sizeof singles);
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
