// Work queues of threads: one queue of items for each thread. A thread whose queue is empty takes items from
// the other queues (work stealing).
//
// The queue of a thread holds the same items in every loop of a step, so that their data are still in the
// thread's cache. A cache line that another core has written takes about 100 ns to load.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace quicksand {

class WorkQueues {
public:
    static constexpr int most = 64; // queues; further threads have none and only take from these

    /// A queue for each thread; begin(k, n) is the first item of queue k of n, and the end of queue k - 1.
    template <class Begin>
    WorkQueues(int threads, Begin&& begin) : count_(std::min(threads, most))
    {
        for (int k = 0; k < count_; ++k) queue(k).left = packed(begin(k, count_), begin(k + 1, count_));
    }

    /// The next item for a thread: from the front of its own queue, then from the back of the others.
    std::optional<std::uint32_t> take(int thread)
    {
        for (int k = 0; k < count_; ++k) {
            const bool own = k == 0 && thread < count_;
            if (const auto item = take_from(queue((thread + k) % count_), own)) return item;
        }
        return std::nullopt;
    }

private:
    /// Not initialised: most loops use only a few of the queues.
    struct alignas(64) Queue {
        std::uint64_t left; // first item and end, 32 bits each
    };

    static std::uint64_t packed(std::uint32_t first, std::uint32_t end)
    {
        return std::uint64_t{first} << 32 | end;
    }

    static std::optional<std::uint32_t> take_from(Queue& queue, bool front)
    {
        const std::atomic_ref<std::uint64_t> left(queue.left);
        std::uint64_t old = left.load(std::memory_order_relaxed);
        while (true) {
            const auto first = static_cast<std::uint32_t>(old >> 32), end = static_cast<std::uint32_t>(old);
            if (first >= end) return std::nullopt;
            const std::uint64_t rest = front ? packed(first + 1, end) : packed(first, end - 1);
            if (left.compare_exchange_weak(old, rest, std::memory_order_relaxed))
                return front ? first : end - 1;
        }
    }

    Queue& queue(int k) { return queues_[static_cast<std::size_t>(k)]; }

    int count_;
    std::array<Queue, most> queues_;
};

} // namespace quicksand
