#include "raytracer/bvh/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bvh_kernel.h"
#include "bvh_split.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/parallel.h"

namespace raytracer {

namespace {

// The largest coordinate of a box in a tree: surface areas times numbers of primitives stay finite.
constexpr float largestCoordinate = 0x1p40f;

template <InstructionSet... sets>
const BvhKernel& kernelAmong(InstructionSet set) {
    const BvhKernel* const kernels[] = {&bvhKernel<sets>()...};
    return *kernels[static_cast<std::size_t>(set)];
}

const BvhKernel& kernelOf(InstructionSet set) {
    using enum InstructionSet;
    return kernelAmong<RAYTRACER_INSTRUCTION_SETS>(set);
}

}  // namespace

Bvh::Bvh(std::size_t count, bool triangles, const BuildOptions& options)
    : kernel_(&kernelOf(options.instructionSet)) {
    frame_.count = count;
    frame_.triangles = triangles;
    // As trees are: a node for 4 boxes or 16 triangles, and a block for 8 of these. What several threads have
    // built is in memory twice, while it is joined.
    constexpr double ofBox = sizeof(BvhNode) / 4.0,
                     ofTriangle = sizeof(BvhNode) / 16.0 + 6 * sizeof(words_[0]);
    const int copies = count >= parallelSize && threadCount(options.threads) > 1 ? 2 : 1;
    requireMemory({}, "the tree of " + std::to_string(count) + (triangles ? " triangles" : " shapes"),
                  static_cast<double>(count) *
                      (sizeof(PrimitiveReference) + copies * (triangles ? ofTriangle : ofBox)));
}

float floatBelow(double x) {
    const float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) > x ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
                                            : nearest;
}

float floatAbove(double x) { return -floatBelow(-x); }

bool Bvh::usable(const FloatBox& box) {
    bool result = true;
    for (int axis = 0; axis < 3; ++axis)  // false for NaN too
        result = result && box.low[axis] >= -largestCoordinate && box.high[axis] <= largestCoordinate;
    return result;
}

std::size_t Bvh::memory() const {
    return nodes_.size() * sizeof(BvhNode) + words_.size() * sizeof(words_[0]);
}

BvhCursor::BvhCursor(const Bvh& bvh, const BvhRay& ray) : kernel_(bvh.kernel_) {
    tScale_ = kernel_->prepareRay(state_, bvh.frame_, ray);
    start(bvh);
}

BvhCursor::BvhCursor(const Bvh& bvh, const BvhBeam& beam) : kernel_(bvh.kernel_) {
    tScale_ = kernel_->prepareBeam(state_, bvh.frame_, beam);
    start(bvh);
}

void BvhCursor::start(const Bvh& bvh) {
    usable_ = tScale_ > 0;
    if (!usable_) return;
    state_.nodes = bvh.nodes_.data();
    state_.words = bvh.frame_.triangles ? bvh.words_.data() : nullptr;
    state_.stack[0] = bvh.root_;
    state_.depth = 1;
}

bool BvhCursor::next(double limit) {
    if (state_.depth == 0) return false;
    // Rounded up: the factor is far more than the roundings of the product and the conversion.
    const double scaled =
        std::clamp(limit * tScale_ * (1 + 0x1p-20), 0.0, double{std::numeric_limits<float>::max()});
    return kernel_->advance(state_, static_cast<float>(scaled));
}

}  // namespace raytracer
