// When threads pay.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// Work on fewer particles or nodes than this stays on one thread: starting and joining the others costs more
/// than they save, much more on a machine that is busy with other work [-].
inline constexpr std::size_t least_parallel_work = 2000;

/// Particles or nodes that a thread takes at a time [-].
inline constexpr std::int64_t chunk = 512;

/// Call work(i) for i < count. Threads take turns of 64: soil fills some rows of nodes and not others, and
/// what one thread has written it finds in its own cache in the next loop.
template <class Work>
void for_each_index(std::size_t count, Work&& work)
{
    const auto total = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(static, 64) if (count > least_parallel_work)
    for (std::int64_t i = 0; i < total; ++i) work(static_cast<std::size_t>(i));
}

/// Call work(first, last) for chunks of `count` particles that differ in their work: a thread that is done
/// takes the next.
template <class Work>
void for_each_uneven_chunk(std::size_t count, Work&& work)
{
    const auto total = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(dynamic, 1) if (count > least_parallel_work)
    for (std::int64_t first = 0; first < total; first += chunk / 2) {
        work(static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(total, first + chunk / 2)));
    }
}

/// Call work(first, last) for chunks of `count` particles, on all threads.
template <class Work>
void for_each_chunk(std::size_t count, Work&& work)
{
    const auto total = static_cast<std::int64_t>(count);
#pragma omp parallel for schedule(static) if (count > least_parallel_work)
    for (std::int64_t first = 0; first < total; first += chunk) {
        work(static_cast<std::size_t>(first), static_cast<std::size_t>(std::min(total, first + chunk)));
    }
}

/// zero + the sums of part(first, last) over chunks of 1024, added in their order: the same bits for any
/// number of threads.
template <class Sum, class Part>
Sum ordered_sum(std::size_t count, const Sum& zero, Part&& part)
{
    constexpr std::size_t length = 1024;
    const auto parts = static_cast<std::int64_t>((count + length - 1) / length);
    std::vector<Sum> sums(static_cast<std::size_t>(parts), zero);
#pragma omp parallel for schedule(static, 1) if (count > least_parallel_work)
    for (std::int64_t k = 0; k < parts; ++k) {
        const std::size_t first = static_cast<std::size_t>(k) * length;
        sums[static_cast<std::size_t>(k)] = part(first, std::min(count, first + length));
    }
    Sum total = zero;
    for (const Sum& sum : sums) total += sum;
    return total;
}

} // namespace quicksand
