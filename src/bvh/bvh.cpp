#include "raytracer/bvh/bvh.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <string_view>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "bvh_instruction_sets.h"

namespace raytracer {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Boxes further out than this are not put into a tree: products of three of its lengths and a count stay
// finite.
constexpr float largestCoordinate = 0x1p40f;

InstructionSet chooseInstructionSet() {
    const char* name = std::getenv("RAYTRACER_SIMD");
    const std::string_view asked = name ? name : "";
    if (asked == "scalar") return InstructionSet::Scalar;
    if (isSupported(InstructionSet::Avx2) && asked != "sse2") return InstructionSet::Avx2;
    return isSupported(InstructionSet::Sse2) ? InstructionSet::Sse2 : InstructionSet::Scalar;
}

using Prepare = double (*)(BvhTraversal&, const BvhFrame&, const BvhRay&);
using PrepareBeam = double (*)(BvhTraversal&, const BvhFrame&, const BvhBeam&);
using Advance = bool (*)(BvhTraversal&, float limit);

struct Chosen {
    InstructionSet set;
    Prepare prepare;
    PrepareBeam prepareBeam;
    Advance advance;
};

Chosen choose(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::Avx2) return {set, avx2::prepare, avx2::prepareBeam, avx2::advance};
    if (set == InstructionSet::Sse2) return {set, sse2::prepare, sse2::prepareBeam, sse2::advance};
#endif
    return {set, scalar::prepare, scalar::prepareBeam, scalar::advance};
}

Chosen chosen = choose(chooseInstructionSet());

}  // namespace

bool isSupported(InstructionSet set) {
#if defined(__x86_64__)
    return set != InstructionSet::Avx2 || (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
#else
    return set == InstructionSet::Scalar;
#endif
}

InstructionSet instructionSet() { return chosen.set; }

void setInstructionSet(InstructionSet set) { chosen = choose(set); }

void* allocateOnLargePages(std::size_t bytes, std::size_t alignment) {
    constexpr std::size_t page = std::size_t{1} << 21;  // x86's and most ARM's
    alignment = bytes >= 2 * page ? page : std::max(alignment, sizeof(void*));
    void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!memory) throw std::bad_alloc();
#if defined(__linux__)
    if (bytes >= 2 * page) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return memory;
}

float floatBelow(double x) {
    const float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) > x ? std::nextafter(nearest, -infinite) : nearest;
}

float floatAbove(double x) { return -floatBelow(-x); }

bool Bvh::usable(const FloatBox& box) {
    bool result = true;
    for (int axis = 0; axis < 3; ++axis)  // false for NaN too
        result = result && box.low[axis] >= -largestCoordinate && box.high[axis] <= largestCoordinate;
    return result;
}

std::size_t Bvh::memory() const {
    return nodes_.capacity() * sizeof(BvhNode) + words_.capacity() * sizeof(words_[0]);
}

BvhCursor::BvhCursor(const Bvh& bvh, const BvhRay& ray) {
    tScale_ = chosen.prepare(state_, bvh.frame_, ray);
    start(bvh);
}

BvhCursor::BvhCursor(const Bvh& bvh, const BvhBeam& beam) {
    tScale_ = chosen.prepareBeam(state_, bvh.frame_, beam);
    start(bvh);
}

void BvhCursor::start(const Bvh& bvh) {
    usable_ = tScale_ > 0;
    if (!usable_ || bvh.empty()) return;
    state_.nodes = bvh.nodes_.data();
    state_.words = bvh.frame_.triangles ? bvh.words_.data() : nullptr;
    state_.stack[0] = bvh.root_;
    state_.depth = 1;
}

bool BvhCursor::next(double limit) {
    if (state_.depth == 0) return false;
    // Rounded up; the factor is far more than the roundings of product and conversion.
    const double scaled =
        std::clamp(limit * tScale_ * (1 + 0x1p-20), 0.0, double{std::numeric_limits<float>::max()});
    return chosen.advance(state_, static_cast<float>(scaled));
}

}  // namespace raytracer
