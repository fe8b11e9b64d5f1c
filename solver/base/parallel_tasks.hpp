// Tasks of unlike length on all threads, of which some may fail.
#pragma once

#include "solver/base/threads.hpp"

#include <cstddef>
#include <exception>
#include <vector>

namespace quicksand {

/// Call task(k) for k < count on so many threads, one that is done taking the next one. What the tasks throw,
/// by k; null where nothing was thrown.
template <class Task>
std::vector<std::exception_ptr> attempt_each(std::size_t count, Task&& task, int threads = thread_count())
{
    std::vector<std::exception_ptr> failures(count);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (std::size_t k = 0; k < count; ++k) {
        try {
            task(k);
        } catch (...) {
            failures[k] = std::current_exception();
        }
    }
    return failures;
}

/// Throw the first of them, if any.
inline void rethrow_first(const std::vector<std::exception_ptr>& failures)
{
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

} // namespace quicksand
