// Loops shared out among threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace raytracer {

inline int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

// work(i) for every 0 <= i < count, on several threads.
template <class Work>
void parallelFor(std::uint32_t count, int threads, const Work& work) {
    std::atomic<std::uint32_t> next{0};
    const auto take = [&] {
        for (std::uint32_t i; (i = next.fetch_add(1)) < count;) work(i);
    };
    std::vector<std::jthread> helpers;
    for (int i = std::min(threads, static_cast<int>(count)); i > 1; --i) helpers.emplace_back(take);
    take();
}

// A range of fewer numbers is not worth a thread's start.
inline constexpr std::uint32_t parallelSize = 1 << 15;

// How many pieces parallelPieces makes at most.
inline std::uint32_t mostPieces(int threads) { return 4 * static_cast<std::uint32_t>(threads) + 1; }

// work(piece, from, to) for pieces of a range of numbers.
template <class Work>
void parallelPieces(std::uint32_t begin, std::uint32_t end, int threads, const Work& work) {
    const std::uint32_t size = end - begin;
    const std::uint32_t pieces = size < parallelSize ? 1 : std::min(size / (parallelSize / 4), mostPieces(threads) - 1);
    parallelFor(pieces, threads, [&](std::uint32_t piece) {
        const auto at = [&](std::uint32_t i) { return begin + static_cast<std::uint32_t>(std::uint64_t{size} * i / pieces); };
        work(piece, at(piece), at(piece + 1));
    });
}

}  // namespace raytracer
