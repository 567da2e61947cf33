// A bounding volume hierarchy that culls in float: of many boxes or triangles it finds the few that a ray
// might hit.
//
// It may only discard, never decide. What it returns is tested again in Real, and what it discards must be
// something that Real arithmetic would not have hit either. Hence everything here is rounded outwards: boxes,
// distances, the ray's origin (a small box itself, see BvhRay::slack). A picture is the same with any tree,
// any instruction set or none. The code does not depend on Real, so it is compiled once. Only the traversal's
// inner loops (bvh_kernel.h) are compiled for each instruction set.
//
// A node has eight children (Wald, Benthin and Boulos, Getting Rid of Packets, 2008). A mesh's leaf is a
// block of up to eight triangles. Their corners are on a 16-bit grid of the block's own, and they are tested
// together before Real sees any of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "raytracer/bvh/build_options.h"
#include "raytracer/util/large_vector.h"

namespace raytracer {

struct MeshData;  // mesh_file.h

struct FloatBox {
    float low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    bool ball = false;  // a cube up to rounding, whose contents lie in its inscribed ball
};

// The greatest float that is at most x, and the least that is at least x; infinite where no finite one is.
float floatBelow(double x);
float floatAbove(double x);

// The points origin + t * direction, t >= 0.
struct BvhRay {
    glm::dvec3 origin, direction;
    // A bound, for each axis, on the distance of a computed hit from its primitive and from the ray.
    double slack = 0;
};

// A packet of rays, bounded: each starts within a box, and has a direction within another. Both are given
// axis by axis (x, y, z; the fourth number has no meaning).
struct BvhBeam {
    alignas(32) double originLow[4], originHigh[4], directionLow[4], directionHigh[4];
    double slack = 0;  // as BvhRay's
};

// The place of a node in a tree is its offset in units of this many bytes.
inline constexpr std::uint32_t bvhUnit = 32;

// Child boxes as planes[2 * axis + (0: low, 1: high)][child]. A slot without a child has an inverted infinite
// box.
struct alignas(bvhUnit) BvhNode {
    float planes[6][8];
    std::uint32_t child[8];

    // A child is the place of a node or, with leafBit, a leaf. A leaf of a tree of boxes is the name of one
    // primitive, one of a tree of triangles is the place of a block. ballBit marks a FloatBox::ball.
    static constexpr std::uint32_t leafBit = std::uint32_t{1} << 31, ballBit = leafBit >> 1;
};

// The head of a leaf of triangles, in 32-bit words. Behind it come a primitive number for each triangle, then
// 16-bit grid coordinates: for each corner and axis, one for each triangle. A point is base + grid /
// 2^exponent.
struct BvhBlock {
    float base[3];
    std::int16_t exponent;
    std::uint16_t count;
    static constexpr std::size_t words = 4;
};

// The map from the primitives' space to the one that the tree computes in: (x - center) * scale.
struct BvhFrame {
    glm::dvec3 center{0};
    double extent = 0;                      // no primitive is farther from the center along any axis
    double scale = 1;                       // a power of two
    std::size_t count = 0;                  // of primitives
    bool triangles = false, balls = false;  // the leaves are triangles; some boxes have balls
};

struct BvhKernel;

class Bvh {
  public:
    Bvh() = default;

    // A tree over boxes, which must be usable. Each has a name, a number less than 2^30 that the caller
    // chooses.
    static Bvh ofBoxes(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names,
                       const BuildOptions& options = {});
    static bool usable(const FloatBox& box);

    // A tree over a mesh's triangles. Empty where differences of the coordinates would overflow.
    static Bvh ofTriangles(const MeshData& mesh, const BuildOptions& options = {});

    bool empty() const { return !hasRoot_; }

    const BvhFrame& frame() const { return frame_; }
    std::size_t memory() const;  // bytes

  private:
    friend class BvhBuilder;
    friend class BvhCursor;

    // Throws Error if there is too little memory to build the tree.
    Bvh(std::size_t count, bool triangles, const BuildOptions& options);

    const BvhKernel* kernel_ = nullptr;
    LargeVector<BvhNode> nodes_;
    LargeVector<std::uint32_t> words_;  // of blocks
    std::uint32_t root_ = 0;
    bool hasRoot_ = false;
    BvhFrame frame_;
};

// The state of a traversal: the prepared ray or beam, and the nodes still to be visited.
struct BvhTraversal {
    const BvhNode* nodes;
    const std::uint32_t* words;  // null for boxes
    bool balls;                  // some boxes have a ball in them

    // For each axis 1 / direction, for far planes a little larger (growth), and an offset, so that a plane's
    // t is plane * inverse - offset. The origin is a box: near takes the side that makes t smaller, far the
    // other. Of a beam's directions, near takes the fastest, far the slowest.
    alignas(16) float nearInverse[4], farInverse[4], nearOffset[4], farOffset[4];
    std::uint32_t nearPlane[3];  // indices into a node's planes

    // A distance has a relative error of about 2^-22 at most: roundings of the direction, the inverse, a
    // difference and a product. Of two distances that are compared, the farther one is enlarged by this.
    static constexpr float growth = 1 + 0x1p-20f;

    float ballOrigin[4], ballDirection[4];  // for balls: in the tree's frame
    float ballMargin;                       // added to their radii

    // For triangles, in the tree's frame. z is the axis of the direction's largest component.
    std::uint32_t x, y, z;
    double shearX, shearY, origin[4], slack;
    double shearHalf, originHalf;  // above is the middle line of a beam: its lines differ by at most this
    bool isBeam;

    // The most entries that a tree can leave: 7 for each level, and the root. It has at most 56 levels: 24
    // split by surface area, then 32 that halve (bvh_split.cpp).
    static constexpr int stackSize = 7 * 56 + 1;
    int depth = 0;
    std::uint32_t foundCount = 0;
    std::uint32_t found[8];
    std::uint64_t stack[stackSize];  // distance (its bits, in the upper half) and child
};

// The traversal of a tree by a ray or a beam: from near to far, except where boxes overlap.
class BvhCursor {
  public:
    // The tree must not be empty.
    BvhCursor(const Bvh& bvh, const BvhRay& ray);
    BvhCursor(const Bvh& bvh, const BvhBeam& beam);

    // Whether the tree can be used; if not, every primitive must be tested. It cannot where a ray's numbers
    // are out of range, where a beam's rays go both ways along some axis, or where they spread so wide that
    // they are faster one at a time.
    bool usable() const { return usable_; }

    // Moves on to the next primitives that might be hit at t <= limit; false when there are none.
    bool next(double limit);

    // The primitives found: a few at a time, so that tests in Real can soon lower the limit.
    std::span<const std::uint32_t> primitives() const { return {state_.found, state_.foundCount}; }

  private:
    void start(const Bvh& bvh);

    const BvhKernel* kernel_;
    BvhTraversal state_;
    double tScale_ = 0;  // the traversal's t is the ray's times this
    bool usable_ = false;
};

}  // namespace raytracer
