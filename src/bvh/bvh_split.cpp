#include "bvh_split.h"

#include <algorithm>

#include "raytracer/util/parallel.h"

namespace raytracer {

namespace {

constexpr int mostBins = 16;
// Fewer than this need only half of the bins; for more, the longest axis will do (Notes.txt).
constexpr std::uint32_t fewPrimitives = 64;
constexpr int medianDepth = 24;  // from here on halves, so that the depth is bounded: BvhTraversal::stackSize

int longest(Float4 size) {
    return size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
}

}  // namespace

// Which bin a centre falls into.
struct RangeSplitter::Binning {
    int count = mostBins / 2;
    int firstAxis = 0, lastAxis = 2;  // between which a plane is looked for
    Float4 low, scale;

    explicit Binning(const Range& range) : low(range.centers.low) {
        const Float4 size = range.centers.high - range.centers.low;
        if (range.size() >= fewPrimitives) count = mostBins, firstAxis = lastAxis = longest(size);
        const float bins =
            static_cast<float>(count) * (1 - 0x1p-20f);  // keeps the highest centre in the last one
        for (int axis = 0; axis < 4; ++axis)
            scale[axis] = size[axis] > 0 ? std::min(bins / size[axis], 0x1p100f) : 0;
    }

    Int4 operator()(const PrimitiveReference& reference) const {
        return __builtin_convertvector((reference.center() - low) * scale, Int4);
    }
};

struct RangeSplitter::Bins {
    struct Bin {
        BuildBox box;
        std::uint32_t count;
    };
    Bin bin[3][mostBins];

    explicit Bins(int count) {
        for (auto& axis : bin)
            for (int i = 0; i < count; ++i) axis[i] = {{}, 0};
    }
    void add(const Bins& other) {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < mostBins; ++i) {
                bin[axis][i].box.add(other.bin[axis][i].box);
                bin[axis][i].count += other.bin[axis][i].count;
            }
    }
};

void RangeSplitter::split(const Range& range, int depth, bool onAllThreads, Range& left, Range& right) const {
    const Binning binning(range);
    const Plane plane = depth < medianDepth ? best(range, binning, onAllThreads) : Plane{};
    if (plane.axis >= 0) partition(range, binning, plane, left, right);
    else halve(range, left, right);
}

void RangeSplitter::bin(std::uint32_t begin, std::uint32_t end, const Binning& binning, Bins& bins) const {
    for (std::uint32_t i = begin; i < end; ++i) {
        const Int4 place = binning(references_[i]);
        for (int axis = binning.firstAxis; axis <= binning.lastAxis; ++axis) {
            bins.bin[axis][place[axis]].box.add(references_[i].box());
            ++bins.bin[axis][place[axis]].count;
        }
    }
}

// None where all centres coincide.
RangeSplitter::Plane RangeSplitter::best(const Range& range, const Binning& binning,
                                         bool onAllThreads) const {
    Bins bins(binning.count);
    if (onAllThreads && range.size() >= parallelSize) {
        std::vector<Bins> pieces(mostPieces(threads_), Bins(mostBins));
        parallelPieces(range.begin, range.end, threads_,
                       [&](std::uint32_t piece, std::uint32_t begin, std::uint32_t end) {
                           bin(begin, end, binning, pieces[piece]);
                       });
        for (const Bins& piece : pieces) bins.add(piece);
    } else {
        bin(range.begin, range.end, binning, bins);
    }
    Plane best;
    for (int axis = binning.firstAxis; axis <= binning.lastAxis; ++axis) {
        if (!(range.centers.high[axis] > range.centers.low[axis])) continue;
        float rightCost[mostBins];
        BuildBox box;
        std::uint32_t count = 0;
        for (int i = binning.count - 1; i > 0; --i) {
            box.add(bins.bin[axis][i].box);
            count += bins.bin[axis][i].count;
            rightCost[i] = count ? box.halfArea() * static_cast<float>(count) : BuildBox::infinite;
        }
        box = {}, count = 0;
        for (int i = 1; i < binning.count; ++i) {
            box.add(bins.bin[axis][i - 1].box);
            count += bins.bin[axis][i - 1].count;
            if (count == 0) continue;
            const float cost = box.halfArea() * static_cast<float>(count) + rightCost[i];
            if (cost < best.cost) best = {axis, i, cost};
        }
    }
    return best;
}

void RangeSplitter::partition(const Range& range, const Binning& binning, const Plane& plane, Range& left,
                              Range& right) const {
    Range sides[2];
    std::uint32_t begin = range.begin, end = range.end;
    while (begin < end) {
        PrimitiveReference& reference = references_[begin];
        const bool isRight = binning(reference)[plane.axis] >= plane.bin;
        sides[isRight].add(reference);
        if (isRight) std::swap(reference, references_[--end]);
        else ++begin;
    }
    left = sides[0], left.begin = range.begin, left.end = begin;
    right = sides[1], right.begin = begin, right.end = range.end;
}

void RangeSplitter::halve(const Range& range, Range& left, Range& right) const {
    const int axis = longest(range.centers.high - range.centers.low);
    const std::uint32_t middle = range.begin + range.size() / 2;
    std::nth_element(references_.begin() + range.begin, references_.begin() + middle,
                     references_.begin() + range.end,
                     [&](const PrimitiveReference& a, const PrimitiveReference& b) {
                         return a.center()[axis] < b.center()[axis];
                     });
    Range sides[2];
    for (std::uint32_t i = range.begin; i < range.end; ++i) sides[i >= middle].add(references_[i]);
    left = sides[0], left.begin = range.begin, left.end = middle;
    right = sides[1], right.begin = middle, right.end = range.end;
}

}  // namespace raytracer
