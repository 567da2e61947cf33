// Builds a tree from the top down, directly with eight children a node: the child with the largest surface
// area is split (bvh_split.h) until there are eight. One thread builds the top, and lets all threads bin. The
// subtrees below it are shared out among the threads.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <glm/common.hpp>

#include "bvh_split.h"
#include "raytracer/bvh/bvh.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/parallel.h"

namespace raytracer {

namespace {

constexpr std::uint32_t tasksPerThread = 12;  // many small ones share out more evenly
constexpr std::uint32_t blockSize = 8;
constexpr std::uint32_t nodeUnits = sizeof(BvhNode) / bvhUnit;

}  // namespace

class BvhBuilder {
  public:
    // A leaf has at most leafSize primitives.
    BvhBuilder(Bvh& bvh, int threads, std::uint32_t leafSize)
        : bvh_(bvh),
          threads_(threadCount(threads)),
          leafSize_(leafSize),
          splitter_(references_, threads_, leafSize) {}

    void build(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names);
    void build(const MeshData& mesh);

  private:
    // A subtree under construction. Its references are its own, until joinTasks() makes them global.
    struct Part {
        LargeVector<BvhNode> nodes;
        LargeVector<std::uint32_t> words;
    };

    // A range below the top that one thread builds into `part`, and the root that this gives.
    struct Task {
        Range range;
        int depth;
        Part part;
        std::uint32_t root;
    };

    template <class MakeReference>
    void buildTree(std::uint32_t count, const MakeReference& makeReference);
    void reserveFor(std::size_t count, Part& part) const;
    void assemble(Part& top, std::uint32_t root);
    void joinTasks(Part& top);

    std::uint32_t buildRange(Part& part, const Range& range, int depth, bool top);
    std::uint32_t splitIntoChildren(const Range& range, int depth, bool top, Range (&children)[8]);
    std::uint32_t takeSingly(const Range& range, Range (&children)[8]) const;
    std::uint32_t leaf(Part& part, const Range& range) const;
    bool isLeaf(const Range& range) const { return range.size() <= leafSize_; }

    glm::dvec3 framePoint(std::uint32_t index) const {
        return (positions_[indices_[index]] - bvh_.frame_.center) * bvh_.frame_.scale;
    }

    Bvh& bvh_;
    int threads_;
    std::uint32_t leafSize_;
    std::uint32_t taskSize_ = 0;
    LargeVector<PrimitiveReference> references_;
    RangeSplitter splitter_;
    std::vector<Task> tasks_;
    std::span<const FloatBox> boxes_;
    std::span<const std::uint32_t> names_;
    std::span<const glm::dvec3> positions_;
    std::span<const std::uint32_t> indices_;
};

void BvhBuilder::build(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names) {
    boxes_ = boxes;
    names_ = names;
    bvh_.frame_.balls = std::any_of(boxes.begin(), boxes.end(), [](const FloatBox& box) { return box.ball; });
    buildTree(static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) {
        const auto &low = boxes[i].low, &high = boxes[i].high;
        return PrimitiveReference{{low[0], low[1], low[2], 0}, {high[0], high[1], high[2], 0}};
    });
}

void BvhBuilder::build(const MeshData& mesh) {
    positions_ = mesh.positions;
    indices_ = mesh.positionIndex;
    bvh_.frame_.center = mesh.low + (mesh.high - mesh.low) / 2.0;
    const glm::dvec3 half = glm::max(mesh.high - bvh_.frame_.center, bvh_.frame_.center - mesh.low);
    const double extent = std::max(half.x, std::max(half.y, half.z));
    if (!(extent <= std::numeric_limits<double>::max() / 4)) return;
    const int exponent = extent > 0 ? std::clamp(std::ilogb(extent) + 1, -1000, 1000) : 0;
    bvh_.frame_.scale = std::scalbn(1.0, -exponent);
    bvh_.frame_.extent = std::max(extent, std::numeric_limits<double>::min());

    buildTree(static_cast<std::uint32_t>(mesh.triangleCount()), [&](std::uint32_t i) {
        const glm::dvec3 a = framePoint(3 * i), b = framePoint(3 * i + 1), c = framePoint(3 * i + 2);
        const glm::dvec3 from = glm::min(a, glm::min(b, c)), to = glm::max(a, glm::max(b, c));
        Float4 low{static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z), 0},
            high{static_cast<float>(to.x), static_cast<float>(to.y), static_cast<float>(to.z), 0};
        // One or two units in the last place outwards, and a little for 0.
        const auto outwards = [](Float4 v) { return (v < 0 ? -v : v) * 0x1p-23f + 0x1p-100f; };
        return PrimitiveReference{low - outwards(low), high + outwards(high)};
    });
}

template <class MakeReference>
void BvhBuilder::buildTree(std::uint32_t count, const MakeReference& makeReference) {
    if (count == 0) return;
    references_.resize(count);
    std::vector<Range> pieces(mostPieces(threads_));
    parallelPieces(0, count, threads_, [&](std::uint32_t piece, std::uint32_t begin, std::uint32_t end) {
        Range all;
        for (std::uint32_t i = begin; i < end; ++i) {
            references_[i] = makeReference(i);
            references_[i].setPrimitive(i);
            all.add(references_[i]);
        }
        pieces[piece] = all;
    });
    Range all;
    all.end = count;
    for (const Range& piece : pieces) all.box.add(piece.box), all.centers.add(piece.centers);
    if (threads_ > 1 && count >= parallelSize)
        taskSize_ = std::max(parallelSize / 8, count / (tasksPerThread * static_cast<unsigned>(threads_)));

    Part top;
    if (taskSize_ == 0) reserveFor(count, top);
    const std::uint32_t root = buildRange(top, all, 0, taskSize_ != 0);
    parallelFor(static_cast<std::uint32_t>(tasks_.size()), threads_, [&](std::uint32_t i) {
        Task& task = tasks_[i];
        task.root = buildRange(task.part, task.range, task.depth, false);
    });
    assemble(top, root);
}

// Reserves a little more address space than trees have taken: a vector that grows is in memory twice.
void BvhBuilder::reserveFor(std::size_t count, Part& part) const {
    part.nodes.reserve(count / (bvh_.frame_.triangles ? 16 : 3) + 1);
    if (bvh_.frame_.triangles) part.words.reserve(8 * count + BvhBlock::words);
}

// Joins the parts. In the top, a child with leafBit is a task's number.
void BvhBuilder::assemble(Part& top, std::uint32_t root) {
    bvh_.root_ = root;
    bvh_.hasRoot_ = true;
    if (tasks_.empty()) {
        bvh_.nodes_ = std::move(top.nodes);
        bvh_.words_ = std::move(top.words);
    } else {
        joinTasks(top);
    }
    bvh_.words_.resize(bvh_.words_.size() + BvhBlock::words,
                       0);  // loads of eight coordinates run past the last
}

void BvhBuilder::joinTasks(Part& top) {
    std::vector<std::uint32_t> nodeStart, wordStart;
    std::size_t nodes = top.nodes.size(), words = top.words.size();
    for (const Task& task : tasks_) {
        nodeStart.push_back(static_cast<std::uint32_t>(nodes));
        wordStart.push_back(static_cast<std::uint32_t>(words));
        nodes += task.part.nodes.size();
        words += task.part.words.size();
    }
    const auto moved = [&](std::uint32_t child, std::size_t task) {
        if (!(child & BvhNode::leafBit)) return child + nodeStart[task] * nodeUnits;
        return bvh_.frame_.triangles ? child + wordStart[task] : child;
    };
    for (BvhNode& node : top.nodes)
        for (std::uint32_t& child : node.child)
            if (child & BvhNode::leafBit)
                child = moved(tasks_[child & ~BvhNode::leafBit].root, child & ~BvhNode::leafBit);
    bvh_.nodes_.reserve(nodes);
    bvh_.nodes_.assign(top.nodes.begin(), top.nodes.end());
    bvh_.nodes_.resize(nodes);
    bvh_.words_.reserve(words + BvhBlock::words);
    bvh_.words_.assign(top.words.begin(), top.words.end());
    bvh_.words_.resize(words);
    parallelFor(static_cast<std::uint32_t>(tasks_.size()), threads_, [&](std::uint32_t i) {
        Part& part = tasks_[i].part;
        for (std::size_t n = 0; n < part.nodes.size(); ++n) {
            for (std::uint32_t& child : part.nodes[n].child) child = moved(child, i);
            bvh_.nodes_[nodeStart[i] + n] = part.nodes[n];
        }
        if (!part.words.empty())
            std::memcpy(&bvh_.words_[wordStart[i]], part.words.data(), 4 * part.words.size());
        part = {};
    });
}

std::uint32_t BvhBuilder::buildRange(Part& part, const Range& range, int depth, bool top) {
    if (top && range.size() <= taskSize_) {
        tasks_.push_back({range, depth, {}, 0});
        return BvhNode::leafBit | static_cast<std::uint32_t>(tasks_.size() - 1);
    }
    if (isLeaf(range)) return leaf(part, range);
    Range children[8];
    const std::uint32_t count = splitIntoChildren(range, depth, top, children);
    const auto index = static_cast<std::uint32_t>(part.nodes.size());
    BvhNode& node = part.nodes.emplace_back();
    for (std::uint32_t i = 0; i < 8; ++i) {
        const BuildBox box = i < count ? children[i].box : BuildBox{};
        for (int axis = 0; axis < 3; ++axis) {
            node.planes[2 * axis][i] = box.low[axis];
            node.planes[2 * axis + 1][i] = box.high[axis];
        }
        node.child[i] = 0;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t child = buildRange(part, children[i], depth + 1, top);
        part.nodes[index].child[i] = child;
    }
    return index * nodeUnits;
}

std::uint32_t BvhBuilder::splitIntoChildren(const Range& range, int depth, bool top, Range (&children)[8]) {
    if (leafSize_ == 1 && range.size() <= 8) return takeSingly(range, children);
    std::uint32_t count = 1;
    children[0] = range;
    while (count < 8) {
        int largest = -1;
        float area = -1;
        for (std::uint32_t i = 0; i < count; ++i)
            if (!isLeaf(children[i]) && children[i].box.halfArea() > area)
                largest = static_cast<int>(i), area = children[i].box.halfArea();
        if (largest < 0) break;
        const Range whole = children[largest];
        splitter_.split(whole, depth, top, children[largest], children[count++]);
    }
    return count;
}

// A child for each reference.
std::uint32_t BvhBuilder::takeSingly(const Range& range, Range (&children)[8]) const {
    for (std::uint32_t i = 0; i < range.size(); ++i) {
        children[i].add(references_[range.begin + i]);
        children[i].begin = range.begin + i, children[i].end = range.begin + i + 1;
    }
    return range.size();
}

// In a tree of boxes, a leaf is the name of its primitive; in one of triangles, a block with their corners.
std::uint32_t BvhBuilder::leaf(Part& part, const Range& range) const {
    if (!bvh_.frame_.triangles) {
        const std::uint32_t box = references_[range.begin].primitive();
        return BvhNode::leafBit | (boxes_[box].ball ? BvhNode::ballBit : 0) | names_[box];
    }
    const std::uint32_t count = range.size(), place = static_cast<std::uint32_t>(part.words.size());
    const Float4 size = range.box.high - range.box.low;
    const float largest = std::max(size[0], std::max(size[1], size[2]));
    BvhBlock block{
        {range.box.low[0], range.box.low[1], range.box.low[2]}, 0, static_cast<std::uint16_t>(count)};
    block.exponent = static_cast<std::int16_t>(std::min(15 - std::ilogb(largest * (1 + 0x1p-15f)), 100));
    const double scale = std::scalbn(1.0, block.exponent);
    part.words.resize(place + BvhBlock::words + count + (9 * count + 1) / 2);
    std::memcpy(&part.words[place], &block, sizeof block);
    std::uint32_t* primitives = &part.words[place + BvhBlock::words];
    std::uint16_t grid[9 * blockSize];
    for (std::uint32_t i = 0; i < count; ++i) {
        primitives[i] = references_[range.begin + i].primitive();
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 point = framePoint(3 * primitives[i] + corner);
            for (std::uint32_t axis = 0; axis < 3; ++axis) {
                // Not below 0, since the box is rounded outwards.
                const double step = (point[axis] - static_cast<double>(block.base[axis])) * scale + 0.5;
                grid[(3 * corner + axis) * count + i] = static_cast<std::uint16_t>(std::min(step, 65535.0));
            }
        }
    }
    std::memcpy(primitives + count, grid, 9 * count * sizeof *grid);
    return BvhNode::leafBit | place;
}

Bvh Bvh::ofBoxes(std::span<const FloatBox> boxes, std::span<const std::uint32_t> names,
                 const BuildOptions& options) {
    Bvh bvh(boxes.size(), false, options);
    BvhBuilder(bvh, options.threads, 1).build(boxes, names);
    for (const FloatBox& box : boxes)
        for (int axis = 0; axis < 3; ++axis)
            bvh.frame_.extent = std::max(
                {bvh.frame_.extent, std::abs(double{box.low[axis]}), std::abs(double{box.high[axis]})});
    return bvh;
}

Bvh Bvh::ofTriangles(const MeshData& mesh, const BuildOptions& options) {
    Bvh bvh(mesh.triangleCount(), true, options);
    BvhBuilder(bvh, options.threads, blockSize).build(mesh);
    return bvh;
}

}  // namespace raytracer
