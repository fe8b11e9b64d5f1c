#include "solver/base/threads.hpp"

#include <omp.h>

namespace quicksand {

void set_thread_count(int threads)
{
    omp_set_num_threads(threads);
}

int thread_count()
{
    return omp_get_max_threads();
}

int threads_for(std::size_t count)
{
    return count > least_parallel_work ? thread_count() : 1;
}

int thread_number()
{
    return omp_get_thread_num();
}

} // namespace quicksand
