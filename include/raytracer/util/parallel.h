// Shares out numbered jobs among threads. The program has no other threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace raytracer {

// The number of threads that the user asks for; 0 means one for each processor.
int threadCount(int asked);

// Hands out the jobs 0, 1, ..., each to one thread.
class JobQueue {
  public:
    virtual bool next(std::uint32_t& job) = 0;  // takes a job; false if none is left

  protected:
    ~JobQueue() = default;
};

// The least stack of each new thread, in bytes. It does not depend on the process's limit (ulimit -s).
inline constexpr std::size_t usualStack = std::size_t{1} << 20;

// The bytes that the main thread's stack has at least: three quarters of the process's limit (ulimit -s).
std::size_t mainStack();
// The limit (ulimit -s), in bytes, with which mainStack() is at least `bytes`.
constexpr std::size_t limitForMainStack(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

// Calls work(queue) on up to `threads` threads (0: one for each processor), fewer if the system has no more.
// work takes jobs until none is left. It needs `stack` bytes of stack (0: any stack is enough). The calling
// thread takes part if its stack is large enough. Returns when all threads have ended. If jobs threw,
// rethrows the exception of the lowest one. Returns false, with nothing done, if no thread has such a stack.
bool onThreads(std::uint32_t jobs, int threads, const std::function<void(JobQueue&)>& work,
               std::size_t stack = 0);

// Calls work(job) for every 0 <= job < jobs, on threads as onThreads does.
void parallelFor(std::uint32_t jobs, int threads, const std::function<void(std::uint32_t)>& work);

// A smaller range is not worth the start of a thread.
inline constexpr std::uint32_t parallelSize = 1 << 15;

// An upper bound on the number of pieces that parallelPieces makes.
inline std::uint32_t mostPieces(int threads) { return 4 * static_cast<std::uint32_t>(threads) + 1; }

// Calls work(piece, from, to) for consecutive pieces of the range [begin, end).
void parallelPieces(std::uint32_t begin, std::uint32_t end, int threads,
                    const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& work);

}  // namespace raytracer
