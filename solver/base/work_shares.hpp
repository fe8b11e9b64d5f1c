// Items of work that threads share: each has a share of its own and helps another when it is done.
//
// A thread's share is the same in every loop of a step, so that it finds in its cache what it has written
// there in the loop before. What one thread has written reaches the other's cache at some 100 ns a line.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

namespace quicksand {

class WorkShares {
public:
    static constexpr int most = 64; // threads beyond as many only help

    /// A share for each thread; begin(k, n) is the first item of share k of n, and the end of share k - 1.
    template <class Begin>
    WorkShares(int threads, Begin&& begin) : count_(std::min(threads, most))
    {
        for (int k = 0; k < count_; ++k) share(k).left = packed(begin(k, count_), begin(k + 1, count_));
    }

    /// The next item of a thread: its own from the front, then those of others from the back.
    std::optional<std::uint32_t> take(int thread)
    {
        for (int k = 0; k < count_; ++k) {
            const bool own = k == 0 && thread < count_;
            if (const auto item = take_from(share((thread + k) % count_), own)) return item;
        }
        return std::nullopt;
    }

private:
    /// Not set to zero: most shares of most loops are never used.
    struct alignas(64) Share {
        std::uint64_t left; // first item and end, 32 bits each
    };

    static std::uint64_t packed(std::uint32_t first, std::uint32_t end)
    {
        return std::uint64_t{first} << 32 | end;
    }

    static std::optional<std::uint32_t> take_from(Share& share, bool front)
    {
        const std::atomic_ref<std::uint64_t> left(share.left);
        std::uint64_t old = left.load(std::memory_order_relaxed);
        while (true) {
            const auto first = static_cast<std::uint32_t>(old >> 32), end = static_cast<std::uint32_t>(old);
            if (first >= end) return std::nullopt;
            const std::uint64_t rest = front ? packed(first + 1, end) : packed(first, end - 1);
            if (left.compare_exchange_weak(old, rest, std::memory_order_relaxed))
                return front ? first : end - 1;
        }
    }

    Share& share(int k) { return shares_[static_cast<std::size_t>(k)]; }

    int count_;
    std::array<Share, most> shares_;
};

} // namespace quicksand
