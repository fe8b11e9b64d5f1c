// The threads of the kernels, and when they pay.
#pragma once

#include "solver/base/work_queues.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

/// Threads that the kernels use; results do not depend on it. They are started here, for OpenMP ends the
/// program where it cannot start one later. Throws InputError where the system does not start so many.
void set_thread_count(int threads);
int thread_count();

/// Processors that this program may use.
int processor_count();

/// Work on fewer particles or nodes than this stays on one thread: starting and joining the others costs more
/// than they save, much more on a machine that is busy with other work [-].
inline constexpr std::size_t least_parallel_work = 2000;

/// Particles or nodes that a thread takes at a time [-].
inline constexpr std::size_t chunk = 256;

/// Threads for work on so many particles or nodes; one where several work already.
int threads_for(std::size_t count);

/// Number of the thread that calls, from 0 on.
int thread_number();

/// Call work() on so many threads at the same time; on one without OpenMP, whose team of one thread would
/// call the system at every barrier.
template <class Work>
void on_threads(int threads, Work&& work)
{
    if (threads == 1) {
        work();
        return;
    }
#pragma omp parallel num_threads(threads)
    work();
}

/// Call work(first, last) for the parts of `length` of [0, count), on all threads.
template <class Work>
void for_each_part(std::size_t count, std::size_t length, Work&& work)
{
    const auto parts = static_cast<std::uint32_t>((count + length - 1) / length);
    const auto take = [&](std::uint32_t k) { work(k * length, std::min(count, (k + 1) * length)); };
    const int threads = threads_for(count);
    if (threads == 1) {
        for (std::uint32_t k = 0; k < parts; ++k) take(k);
        return;
    }
    WorkQueues queues(threads, [&](int k, int n) {
        return static_cast<std::uint32_t>(std::uint64_t{parts} * static_cast<std::uint64_t>(k) /
                                          static_cast<std::uint64_t>(n));
    });
    on_threads(threads, [&] {
        while (const auto k = queues.take(thread_number())) take(*k);
    });
}

/// Call work(i) for i < count.
template <class Work>
void for_each_index(std::size_t count, Work&& work)
{
    constexpr std::size_t length = 64; // soil fills some rows of nodes and not others
    for_each_part(count, length, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) work(i);
    });
}

/// Call work(first, last) for chunks of `count` particles.
template <class Work>
void for_each_chunk(std::size_t count, Work&& work)
{
    for_each_part(count, chunk, work);
}

/// zero + the sums of part(first, last) over chunks of 1024, added in their order: the same bits for any
/// number of threads.
template <class Sum, class Part>
Sum ordered_sum(std::size_t count, const Sum& zero, Part&& part)
{
    constexpr std::size_t length = 1024;
    std::vector<Sum> sums((count + length - 1) / length, zero);
    for_each_part(count, length,
                  [&](std::size_t first, std::size_t last) { sums[first / length] = part(first, last); });
    Sum total = zero;
    for (const Sum& sum : sums) total += sum;
    return total;
}

/// An index, whose sums are the smallest of them [-].
struct FirstIndex {
    std::size_t index;

    FirstIndex& operator+=(const FirstIndex& other)
    {
        index = std::min(index, other.index);
        return *this;
    }
};

} // namespace quicksand
