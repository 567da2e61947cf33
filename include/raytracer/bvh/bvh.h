// A bounding volume hierarchy that culls in float: of many boxes or triangles, the few that a ray might meet.
//
// It may only discard, never decide: whatever it returns is tested again in Real, and what it leaves out
// must be something that Real arithmetic would not have hit either. Hence everything here is rounded
// outwards: boxes, the ray's origin (a small box itself, see BvhRay::slack), distances. A picture is the same
// with any tree, any instruction set or none. Independent of Real, so compiled once but for the traversal's
// inner loops (bvh_kernel.h), which are compiled for each instruction set.
//
// Eight children to a node (Wald, Benthin and Boulos, Getting Rid of Packets, 2008). A mesh's leaf is a block
// of up to eight triangles, their corners on a 16-bit grid of the block's own, tested together before Real
// sees any of them.
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
    bool ball = false;  // it is a cube but for rounding, and what is in it lies in the ball inscribed in it
};

// The nearest floats that are surely below and above; coordinates beyond the range of float become infinite.
float floatBelow(double x);
float floatAbove(double x);

// The points origin + t * direction with t >= 0.
struct BvhRay {
    glm::dvec3 origin, direction;
    // How far off, for each axis, the computed hits of these primitives may lie from primitive or ray.
    double slack = 0;
};

// Rays together: each starts within a box and has a direction within another, both axis by axis (x, y, z, 0).
struct BvhBeam {
    alignas(32) double originLow[4], originHigh[4], directionLow[4], directionHigh[4];
    double slack = 0;  // as BvhRay's
};

// In a tree a node is found by its place in units of this many bytes.
inline constexpr std::uint32_t bvhUnit = 32;

// Child boxes as planes[2 * axis + (0: low, 1: high)][child]. A slot without a child is an inverted infinite
// box.
struct alignas(bvhUnit) BvhNode {
    float planes[6][8];
    std::uint32_t child[8];

    // A child is a node's place, or, with this bit, a leaf: of boxes the one primitive's name, of triangles a
    // block's place. A box with a ball in it has the next bit too.
    static constexpr std::uint32_t leafBit = std::uint32_t{1} << 31, ballBit = leafBit >> 1;
};

// The head of a leaf's triangles, in 32-bit words. After it a primitive number for each triangle, then for
// each corner and axis a 16-bit grid coordinate for each triangle. A point is base + grid / 2^exponent.
struct BvhBlock {
    float base[3];
    std::int16_t exponent;
    std::uint16_t count;
    static constexpr std::size_t words = 4;
};

// How the primitives' space becomes the one that the tree computes in: (x - center) * scale.
struct BvhFrame {
    glm::dvec3 center{0};
    double extent = 0;                      // no primitive is further from the center, along any axis
    double scale = 1;                       // a power of two
    std::size_t count = 0;                  // of primitives
    bool triangles = false, balls = false;  // what kinds of leaves there are beside boxes
};

struct BvhKernel;

class Bvh {
  public:
    Bvh() = default;

    // Over boxes, which must be usable, with a name for each: a number of the caller's, less than 2^30.
    static Bvh ofBoxes(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names,
                       const BuildOptions& options = {});
    static bool usable(const FloatBox& box);

    // Over a mesh's triangles. Empty where the coordinates are so large that their differences overflow.
    static Bvh ofTriangles(const MeshData& mesh, const BuildOptions& options = {});

    bool empty() const { return !hasRoot_; }

    const BvhFrame& frame() const { return frame_; }
    std::size_t memory() const;  // bytes

  private:
    friend class BvhBuilder;
    friend class BvhCursor;

    Bvh(std::size_t count, InstructionSet set);

    const BvhKernel* kernel_ = nullptr;
    LargeVector<BvhNode> nodes_;
    LargeVector<std::uint32_t> words_;  // of blocks
    std::uint32_t root_ = 0;
    bool hasRoot_ = false;
    BvhFrame frame_;
};

// What a traversal works on: a ray, made ready, and the nodes still to be seen.
struct BvhTraversal {
    const BvhNode* nodes;
    const std::uint32_t* words;  // null for boxes
    bool balls;                  // some boxes have a ball in them

    // For each axis: 1 / direction, the same a little larger (growth), and what a plane's distance is to be
    // reckoned from. The origin is a box; near takes the side of it that makes t small, far the other.
    alignas(16) float nearInverse[4], farInverse[4], nearOffset[4], farOffset[4];
    std::uint32_t nearPlane[3];  // which planes of a node

    // A distance is wrong by less than 2^-22 of itself: rounding the direction, the inverse, a difference and
    // a product. The farther of two that are compared is made larger by this.
    static constexpr float growth = 1 + 0x1p-20f;

    float ballOrigin[4], ballDirection[4];  // for balls: in the tree's frame
    float ballMargin;                       // how much larger to make them

    // For triangles: z has the largest component of the direction. In the tree's frame.
    std::uint32_t x, y, z;
    double shearX, shearY, origin[4], slack;
    double shearHalf, originHalf;  // of a beam these are its middle's; its lines' differ by so much
    bool isBeam;

    // The most entries that a tree of the builder's greatest depth can leave.
    static constexpr int stackSize = 7 * 56 + 1;
    int depth = 0;
    std::uint32_t foundCount = 0;
    std::uint32_t found[8];
    std::uint64_t stack[stackSize];  // distance (its bits, in the upper half) and child
};

// The way of a ray, or of a beam of them, through a tree, from near to far but for the overlap of boxes.
class BvhCursor {
  public:
    // Through a tree that is not empty.
    BvhCursor(const Bvh& bvh, const BvhRay& ray);
    BvhCursor(const Bvh& bvh, const BvhBeam& beam);

    // Whether the tree can be used; if not, every primitive counts. A ray's numbers may be out of all
    // proportion; a beam's rays may also part along some axis, or spread so wide that they are faster one
    // at a time.
    bool usable() const { return usable_; }

    // Moves on to the next primitives that might be hit at t <= limit; false when there are none.
    bool next(double limit);

    // Those: a few at a time, so that Real is asked soon and can lower the limit.
    std::span<const std::uint32_t> primitives() const { return {state_.found, state_.foundCount}; }

  private:
    void start(const Bvh& bvh);

    const BvhKernel* kernel_;
    BvhTraversal state_;
    double tScale_ = 0;  // the ray's t in units of the normalised direction
    bool usable_ = false;
};

}  // namespace raytracer
