#include "solver/base/parallel_tasks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace quicksand {
namespace {

TEST(ParallelTasks, AreAllDoneThoughSomeFail)
{
    std::vector<int> done(40, 0);
    const auto failures = attempt_each(done.size(), [&](std::size_t k) {
        done[k] = 1;
        if (k % 7 == 3) throw std::runtime_error(std::to_string(k));
    });
    ASSERT_EQ(failures.size(), done.size());
    for (std::size_t k = 0; k < done.size(); ++k) {
        EXPECT_EQ(done[k], 1);
        EXPECT_EQ(failures[k] != nullptr, k % 7 == 3) << k;
    }
}

TEST(ParallelTasks, TheFirstFailureIsThrown)
{
    const auto failures = attempt_each(40, [](std::size_t k) {
        if (k >= 5) throw std::runtime_error(std::to_string(k));
    });
    try {
        rethrow_first(failures);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "5");
    }
    EXPECT_NO_THROW(rethrow_first(attempt_each(3, [](std::size_t) {})));
}

TEST(ParallelTasks, KeepTheirLoopsOnTheirOwnThreads)
{
    const int threads_before = thread_count();
    set_thread_count(2);
    std::vector<int> threads_inside(2, 0);
    rethrow_first(attempt_each(
        2, [&](std::size_t k) { threads_inside[k] = threads_for(10 * least_parallel_work); }, 2));
    EXPECT_EQ(threads_inside, std::vector<int>({1, 1}));
    set_thread_count(threads_before);
}

} // namespace
} // namespace quicksand
