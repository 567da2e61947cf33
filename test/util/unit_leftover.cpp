#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "../../src/util/leftover.h"
#include "raytracer/util/parallel.h"

using namespace raytracer;

namespace {

int cleared = 0;

void countCleared(const void*) { ++cleared; }

// How many are left, in a process of its own, which this ends.
int leftoversNow() {
    const pid_t process = ::fork();
    if (process == 0) {
        Leftover::clearAll();
        ::_exit(cleared);
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("leftovers: threads make and destroy them side by side") {
    const Leftover oldest(countCleared, nullptr);
    parallelFor(8, 8, [](std::uint32_t) {
        for (int i = 0; i < 4000; ++i) {
            const Leftover one(countCleared, nullptr);
            const std::array<Leftover, 2> two{Leftover(countCleared, nullptr),
                                              Leftover(countCleared, nullptr)};
        }
    });
    CHECK(leftoversNow() == 1);
}
