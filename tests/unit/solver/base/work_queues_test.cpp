#include "solver/base/work_queues.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace quicksand {
namespace {

WorkQueues queues_of(int threads, std::uint32_t items)
{
    return WorkQueues(threads, [items](int k, int n) {
        return items * static_cast<std::uint32_t>(k) / static_cast<std::uint32_t>(n);
    });
}

std::vector<std::uint32_t> all_that_are_left(WorkQueues& queues, int thread)
{
    std::vector<std::uint32_t> items;
    while (const auto item = queues.take(thread)) items.push_back(*item);
    return items;
}

TEST(WorkQueues, GiveAThreadItsOwnFromTheFrontThenThoseOfOthersFromTheBack)
{
    WorkQueues queues = queues_of(2, 7); // 0 to 2, and 3 to 6
    EXPECT_EQ(queues.take(1), 3U);
    EXPECT_EQ(all_that_are_left(queues, 0), (std::vector<std::uint32_t>{0, 1, 2, 6, 5, 4}));
    EXPECT_FALSE(queues.take(1));
}

TEST(WorkQueues, HoldMoreThreadsThanItemsAndEmptyQueues)
{
    WorkQueues few = queues_of(4, 2);
    EXPECT_EQ(all_that_are_left(few, 0).size(), 2U);
    WorkQueues many = queues_of(1000, 5);
    EXPECT_EQ(all_that_are_left(many, 999).size(), 5U);
    WorkQueues none = queues_of(3, 0);
    EXPECT_TRUE(all_that_are_left(none, 2).empty());
}

TEST(WorkQueues, AreTakenOnceEachByThreadsAtTheSameTime)
{
    constexpr std::uint32_t items = 20000;
    constexpr int threads = 4;
    WorkQueues queues = queues_of(threads, items);
    std::vector<std::atomic<int>> taken(items);
    std::vector<std::thread> team;
    for (int thread = 0; thread < threads; ++thread) {
        team.emplace_back([&, thread] {
            while (const auto item = queues.take(thread)) ++taken[*item];
        });
    }
    for (std::thread& thread : team) thread.join();
    for (const std::atomic<int>& times : taken) EXPECT_EQ(times, 1);
}

} // namespace
} // namespace quicksand
