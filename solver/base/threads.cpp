#include "solver/base/threads.hpp"

#include "solver/base/failure.hpp"

#include <omp.h>

#include <latch>
#include <string>
#include <system_error>
#include <thread>

namespace quicksand {

namespace {

/// Have all threads at the same time, beside the one that calls.
void require_threads(int threads)
{
    std::latch end(1);
    std::vector<std::jthread> started;
    started.reserve(static_cast<std::size_t>(threads));
    std::string reason;
    try {
        while (static_cast<int>(started.size()) < threads - 1) started.emplace_back([&] { end.wait(); });
    } catch (const std::system_error& error) {
        reason = error.code().message();
    }
    end.count_down();
    const std::size_t all = started.size() + 1;
    if (reason.empty()) return;
    throw InputError("the system starts " + std::to_string(all) + " threads, not the " +
                     std::to_string(threads) + " asked for: " + reason +
                     "\nhint: ask for fewer with --threads, or raise the limits of memory (ulimit -v) or of "
                     "processes (ulimit -u)");
}

} // namespace

void set_thread_count(int threads)
{
    if (threads > 1) require_threads(threads);
    omp_set_num_threads(threads);
    if (threads == 1) return;
#pragma omp parallel num_threads(threads)
    {
    }
}

int processor_count()
{
    return omp_get_num_procs();
}

int thread_count()
{
    return omp_get_max_threads();
}

int threads_for(std::size_t count)
{
    return count > least_parallel_work && omp_in_parallel() == 0 ? thread_count() : 1;
}

int thread_number()
{
    return omp_get_thread_num();
}

} // namespace quicksand
