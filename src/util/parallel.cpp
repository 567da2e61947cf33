#include "raytracer/util/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace raytracer {
namespace {

// What the threads share.
struct Jobs {
    std::uint32_t count;
    std::atomic<std::uint32_t> next{0};
    std::mutex mutex{};
    std::exception_ptr error{};
    std::uint32_t errorJob = 0;
};

class ThreadQueue final : public JobQueue {
  public:
    explicit ThreadQueue(Jobs& jobs) : jobs_(jobs) {}

    bool next(std::uint32_t& job) override {
        job_ = job = jobs_.next.fetch_add(1);
        return job < jobs_.count;
    }

    void fail(std::exception_ptr error) {
        const std::lock_guard lock(jobs_.mutex);
        if (jobs_.error && jobs_.errorJob < job_) return;
        jobs_.error = std::move(error);
        jobs_.errorJob = job_;
    }

  private:
    Jobs& jobs_;
    std::uint32_t job_ = 0;  // taken last
};

}  // namespace

int threadCount(int asked) {
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void onThreads(std::uint32_t count, int threads, const std::function<void(JobQueue&)>& work) {
    Jobs jobs{count};
    const auto take = [&] {
        ThreadQueue queue(jobs);
        try {
            work(queue);
        } catch (...) {
            queue.fail(std::current_exception());
        }
    };
    {
        const std::uint32_t wanted = std::min(static_cast<std::uint32_t>(threadCount(threads)), count);
        std::vector<std::jthread> others;
        while (others.size() + 1 < wanted) others.emplace_back(take);
        take();
    }
    if (jobs.error) std::rethrow_exception(jobs.error);
}

void parallelFor(std::uint32_t jobs, int threads, const std::function<void(std::uint32_t)>& work) {
    onThreads(jobs, threads, [&](JobQueue& queue) {
        for (std::uint32_t job; queue.next(job);) work(job);
    });
}

void parallelPieces(std::uint32_t begin, std::uint32_t end, int threads,
                    const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& work) {
    const std::uint32_t size = end - begin;
    const std::uint32_t pieces =
        size < parallelSize ? 1 : std::min(size / (parallelSize / 4), mostPieces(threads) - 1);
    parallelFor(pieces, threads, [&](std::uint32_t piece) {
        const auto at = [&](std::uint32_t i) {
            return begin + static_cast<std::uint32_t>(std::uint64_t{size} * i / pieces);
        };
        work(piece, at(piece), at(piece + 1));
    });
}

}  // namespace raytracer
