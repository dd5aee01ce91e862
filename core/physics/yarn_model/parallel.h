#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace knittsim::physics {

/// work(i) for every i below `count`, in up to `threads` threads. Which thread does what depends on the
/// numbers only, and each i is done by one thread: where the pieces are independent, the result is the same
/// to the last bit for any number of threads. `work` must not throw.
template<class Work> void parallelFor(std::size_t count, int threads, Work work) {
    const std::size_t used = threads < 1 ? 1 : std::min(count, static_cast<std::size_t>(threads));
    const auto run = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            work(i);
        }
    };
    if (used <= 1) {
        run(0, count);
        return;
    }
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < used; ++t) {
        others.emplace_back(run, count * t / used, count * (t + 1) / used);
    }
    run(0, count / used);
}

} // namespace knittsim::physics
