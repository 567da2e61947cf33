#include "raytracer/util/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <pthread.h>

namespace raytracer {
namespace {

// The current thread's stack in bytes; 0 on the main thread.
thread_local std::size_t workerStack = 0;

std::size_t stackHere() { return workerStack > 0 ? workerStack : mainStack(); }

// The state that the threads share.
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
    std::uint32_t job_ = 0;  // the one taken last
};

// Threads with a stack of this size, which std::thread cannot ask for.
class Threads {
  public:
    explicit Threads(std::size_t stack) {
        pthread_attr_init(&attributes_);
        pthread_attr_setstacksize(&attributes_, stack);
    }
    Threads(const Threads&) = delete;
    ~Threads() {
        for (const pthread_t thread : started_) pthread_join(thread, nullptr);
        pthread_attr_destroy(&attributes_);
    }

    // Runs the task on a new thread. The task must outlive it. False if the system has no more threads.
    bool start(const std::function<void()>& task) {
        const auto run = [](void* of) -> void* {
            (*static_cast<const std::function<void()>*>(of))();
            return nullptr;
        };
        pthread_t thread{};
        void* const argument = const_cast<std::function<void()>*>(&task);
        if (pthread_create(&thread, &attributes_, run, argument) != 0) return false;
        started_.push_back(thread);
        return true;
    }
    std::size_t count() const { return started_.size(); }

  private:
    pthread_attr_t attributes_{};
    std::vector<pthread_t> started_;
};

}  // namespace

int threadCount(int asked) {
    return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool onThreads(std::uint32_t count, int threads, const std::function<void(JobQueue&)>& work,
               std::size_t stack) {
    Jobs jobs{count};
    const std::function<void()> take = [&] {
        ThreadQueue queue(jobs);
        try {
            work(queue);
        } catch (...) {
            queue.fail(std::current_exception());
        }
    };
    const std::size_t othersStack = std::max(stack, usualStack);
    const std::function<void()> takeThere = [&] {
        workerStack = othersStack;
        take();
    };
    {
        const std::uint32_t wanted = std::min(static_cast<std::uint32_t>(threadCount(threads)), count);
        const bool takesPart = stack <= stackHere();
        Threads others(othersStack);
        while (others.count() + takesPart < wanted && others.start(takeThere)) {
        }
        if (takesPart) take();
        else if (others.count() < std::min(wanted, 1u)) return false;
    }
    if (jobs.error) std::rethrow_exception(jobs.error);
    return true;
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
