// The program's only threads: numbered jobs, shared out among them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace raytracer {

// The number of threads for a user's number: 0 is one for each processor.
int threadCount(int asked);

// Hands out the numbers 0, 1, ... below a count, each to one thread.
class JobQueue {
  public:
    virtual bool next(std::uint32_t& job) = 0;  // false: none is left

  protected:
    ~JobQueue() = default;
};

// The stack of a thread, in bytes, whatever the limit of the process (ulimit -s) is.
inline constexpr std::size_t usualStack = std::size_t{1} << 20;

// What the main thread's stack surely has: three quarters of the limit of the process (ulimit -s).
std::size_t mainStack();
// The limit, in bytes, with which that is so much.
constexpr std::size_t limitForMainStack(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

// Calls work(queue) on up to `threads` threads (0: one for each processor), of which the caller is one,
// unless its stack is less than work needs (0: any is enough); work takes jobs until none is left. Fewer
// threads where the system gives no more. Returns when all have ended, and then throws what the lowest job
// has thrown, if any has. False, with nothing done, where there is no thread with this stack.
bool onThreads(std::uint32_t jobs, int threads, const std::function<void(JobQueue&)>& work,
               std::size_t stack = 0);

// work(job) for every 0 <= job < jobs, as onThreads.
void parallelFor(std::uint32_t jobs, int threads, const std::function<void(std::uint32_t)>& work);

// In a smaller range, a thread's start is not worth it.
inline constexpr std::uint32_t parallelSize = 1 << 15;

// How many pieces parallelPieces makes at most.
inline std::uint32_t mostPieces(int threads) { return 4 * static_cast<std::uint32_t>(threads) + 1; }

// work(piece, from, to) for pieces of a range of numbers.
void parallelPieces(std::uint32_t begin, std::uint32_t end, int threads,
                    const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& work);

}  // namespace raytracer
