// Finds where a range of primitives is best split in two, and splits it, for bvh_build.cpp. By the surface
// area heuristic with bins (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007).
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "raytracer/numerics/vector4.h"
#include "raytracer/util/large_vector.h"

namespace raytracer {

struct BuildBox {
    static constexpr float infinite = std::numeric_limits<float>::infinity();
    Float4 low{infinite, infinite, infinite, infinite}, high{-infinite, -infinite, -infinite, -infinite};

    void add(const BuildBox& other) {
        low = low < other.low ? low : other.low;
        high = high > other.high ? high : other.high;
    }
    void add(Float4 point) { add(BuildBox{point, point}); }
    float halfArea() const {
        const Float4 size = high - low;
        return size[0] * (size[1] + size[2]) + size[1] * size[2];
    }
};

// A primitive in the build: its box, and its number as the bits of low[3].
struct PrimitiveReference {
    Float4 low, high;
    BuildBox box() const { return {low, high}; }
    std::uint32_t primitive() const { return std::bit_cast<std::uint32_t>(float{low[3]}); }
    void setPrimitive(std::uint32_t number) { low[3] = std::bit_cast<float>(number), high[3] = 0; }

    float twiceCenter(int axis) const {
        return reinterpret_cast<const float*>(&low)[axis] + reinterpret_cast<const float*>(&high)[axis];
    }
    // Twice the box's centre. Leaves out the number in low[3]: as a denormal it would be slow to add.
    Float4 center() const {
        const Int4 mask{-1, -1, -1, 0};
        return std::bit_cast<Float4>(std::bit_cast<Int4>(low) & mask) + high;
    }
};

struct Range {
    std::uint32_t begin = 0, end = 0;
    BuildBox box, centers;

    std::uint32_t size() const { return end - begin; }
    void add(const PrimitiveReference& reference) {
        box.add(reference.box()), centers.add(reference.center());
    }
};

class RangeSplitter {
  public:
    // With more than one thread, they share the binning of a large range.
    RangeSplitter(LargeVector<PrimitiveReference>& references, int threads, std::uint32_t leafSize)
        : references_(references), threads_(threads), leafSize_(leafSize) {}

    // Splits the range, and sorts its references accordingly. Splits at the plane between two bins where the
    // sum of surface area times number of leaves, over both sides, is least. From a certain depth on, or
    // where all centres coincide, splits into halves.
    void split(const Range& range, int depth, bool onAllThreads, Range& left, Range& right) const;

  private:
    struct Plane {
        int axis = -1;
        int bin = 0;  // the first bin of the right side
        float cost = BuildBox::infinite;
        BuildBox left, right;
    };
    struct Binning;
    struct Bins;

    Plane best(const Range& range, const Binning& binning, bool onAllThreads) const;
    void bin(std::uint32_t begin, std::uint32_t end, const Binning& binning, Bins& bins) const;
    void binAlongOne(std::uint32_t begin, std::uint32_t end, const Binning& binning, Bins& bins) const;
    // Half of the surface area, times the number of leaves that so many primitives fill.
    float cost(const BuildBox& box, std::uint32_t count) const {
        const std::uint32_t leaves = (count + leafSize_ - 1) / leafSize_;
        return box.halfArea() * static_cast<float>(leaves);
    }
    void partition(const Range& range, const Binning& binning, const Plane& plane, Range& left,
                   Range& right) const;
    void halve(const Range& range, Range& left, Range& right) const;

    LargeVector<PrimitiveReference>& references_;
    int threads_;
    std::uint32_t leafSize_;
};

}  // namespace raytracer
