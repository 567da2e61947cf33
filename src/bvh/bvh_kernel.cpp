// The traversal's inner loops, compiled once for each instruction set, into a namespace of its own. Nothing
// may be compiled here that another file might share: the linker keeps one copy of it, which may then run on
// a processor without the instruction set.
#include "bvh_kernel.h"

#include <algorithm>
#include <bit>

#include "bvh_leaves.h"
#include "bvh_prepare.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {
namespace {

// A ray's numbers, broadcast to all lanes. They stay in registers during the traversal.
struct SpreadRay {
    FloatLanes nearInverse[3], farInverse[3], nearOffset[3], farOffset[3], limit;
    const char* nearPlane[3];  // of the node at place 0
    const char* farPlane[3];
};

inline SpreadRay spread(const BvhTraversal& s, float limit) {
    SpreadRay ray;
    const auto* planes = reinterpret_cast<const char*>(s.nodes->planes);
    constexpr std::size_t planeSize = sizeof s.nodes->planes[0];
    for (int axis = 0; axis < 3; ++axis) {
        ray.nearInverse[axis] = s.nearInverse[axis];
        ray.farInverse[axis] = s.farInverse[axis];
        ray.nearOffset[axis] = s.nearOffset[axis];
        ray.farOffset[axis] = s.farOffset[axis];
        ray.nearPlane[axis] = planes + s.nearPlane[axis] * planeSize;
        ray.farPlane[axis] = planes + (s.nearPlane[axis] ^ 1) * planeSize;
    }
    ray.limit = limit;
    return ray;
}

// Returns the children whose boxes the ray enters before it leaves them, and the distances, at least +0, at
// which it enters. With an origin that is finite and an inverse that is finite and not zero, no NaN can
// occur: empty slots give +-infinity.
inline LaneBits hitChildren(const SpreadRay& ray, std::uint32_t place, FloatLanes& distance) {
    const std::size_t node = std::size_t{place} * bvhUnit;
    const auto planes = [node](const char* first) {
        return FloatLanes::load(static_cast<const float*>(__builtin_assume_aligned(first + node, bvhUnit)));
    };
    FloatLanes near[3], far[3];
    for (int axis = 0; axis < 3; ++axis) {
        near[axis] =
            multiplySubtract(planes(ray.nearPlane[axis]), ray.nearInverse[axis], ray.nearOffset[axis]);
        far[axis] = multiplySubtract(planes(ray.farPlane[axis]), ray.farInverse[axis], ray.farOffset[axis]);
    }
    distance = later(later(near[0], near[1]), later(near[2], 0));
    return allLanes ^ bits(isLater(distance, earlier(earlier(far[0], far[1]), earlier(far[2], ray.limit))));
}

// A stack entry: the bits of the distance above the child. Distances are not negative (nor -0), so the order
// of entries is that of distances.
inline std::uint64_t entryOf(const BvhNode& node, const float (&distances)[8], int lane) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(distances[lane])} << 32 | node.child[lane];
}

// Pushes the children that are hit, farthest first, except for the nearest, which it returns. hits: at least
// two.
inline std::uint64_t sortChildren(BvhTraversal& s, const BvhNode& node, const float (&distances)[8],
                                  LaneBits hits) {
    const std::uint64_t a = entryOf(node, distances, std::countr_zero(hits));
    hits &= hits - 1;
    const std::uint64_t b = entryOf(node, distances, std::countr_zero(hits));
    hits &= hits - 1;
    std::uint64_t nearest = std::min(a, b);
    std::uint64_t* const base = s.stack + s.depth;
    std::uint64_t* top = base;
    *top = std::max(a, b);
    for (; hits != 0; hits &= hits - 1) {
        const std::uint64_t c = entryOf(node, distances, std::countr_zero(hits));
        std::uint64_t farther = std::max(nearest, c);
        nearest = std::min(nearest, c);
        std::uint64_t* place = ++top;
        for (; place > base && place[-1] < farther; --place) *place = place[-1];
        *place = farther;
    }
    s.depth += static_cast<int>(top - base) + 1;
    return nearest;
}

// Pushes all children that are hit, the nearest last.
inline void pushChildren(BvhTraversal& s, const BvhNode& node, const FloatLanes& distance, LaneBits hits) {
    float distances[8];
    store(distance, distances);
    if ((hits & (hits - 1)) == 0) s.stack[s.depth++] = entryOf(node, distances, std::countr_zero(hits));
    else {
        const std::uint64_t nearest = sortChildren(s, node, distances, hits);
        s.stack[s.depth++] = nearest;
    }
}

// Takes all leaves among the children that are hit, and pushes the nodes. For beams: their primitives are
// tested together, in any order.
inline bool findLeaves(BvhTraversal& s, const BvhNode& node, const FloatLanes& distance, LaneBits hits) {
    const LaneBits leaves = hits & topBits(node.child, 0);
    if (leaves == 0) return false;
    s.foundCount = 0;
    for (LaneBits left = leaves; left != 0; left &= left - 1)
        s.found[s.foundCount++] = node.child[std::countr_zero(left)] & ~(BvhNode::leafBit | BvhNode::ballBit);
    if (hits != leaves) pushChildren(s, node, distance, hits & ~leaves);
    return true;
}

enum class Step { Down, None, Found };

// Steps from a node to the nearest of its children that the ray hits, and pushes the others.
inline Step stepDown(BvhTraversal& s, const SpreadRay& ray, std::uint32_t& child) {
    FloatLanes distance;
    LaneBits hits = hitChildren(ray, child, distance);
    if (hits == 0) return Step::None;
    const auto* nodes = reinterpret_cast<const char*>(s.nodes);
    const BvhNode& node = *reinterpret_cast<const BvhNode*>(nodes + std::size_t{child} * bvhUnit);
    if (s.balls) {
        const LaneBits balls = hits & topBits(node.child, 1);
        if (balls != 0) hits &= ~balls | hitBalls(s, node);
        if (hits == 0) return Step::None;
    }
    if (s.isBeam && !s.words && findLeaves(s, node, distance, hits)) return Step::Found;
    if ((hits & (hits - 1)) == 0) {
        child = node.child[std::countr_zero(hits)];
        return Step::Down;
    }
    float distances[8];
    store(distance, distances);
    child = static_cast<std::uint32_t>(sortChildren(s, node, distances, hits));
    return Step::Down;
}

inline bool findInLeaf(BvhTraversal& s, std::uint32_t child) {
    if (s.words) return findTriangles(s, s.words + (child & ~BvhNode::leafBit));
    s.found[0] = child & ~(BvhNode::leafBit | BvhNode::ballBit);
    s.foundCount = 1;
    return true;
}

bool advance(BvhTraversal& s, float limit) {
    const SpreadRay ray = spread(s, limit);
    const std::uint32_t limitBits = std::bit_cast<std::uint32_t>(limit);
    while (s.depth > 0) {
        const std::uint64_t entry = s.stack[--s.depth];
        if (entry >> 32 > limitBits) continue;
        auto child = static_cast<std::uint32_t>(entry);
        Step step = Step::Down;
        while (step == Step::Down && !(child & BvhNode::leafBit)) step = stepDown(s, ray, child);
        if (step == Step::Found || (step == Step::Down && findInLeaf(s, child))) return true;
    }
    return false;
}

constexpr BvhKernel kernel{prepareRay, prepareBeam, advance};

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE

template <>
const BvhKernel& bvhKernel<InstructionSet::RAYTRACER_INSTRUCTION_SET>() {
    return kernel;
}

}  // namespace raytracer
