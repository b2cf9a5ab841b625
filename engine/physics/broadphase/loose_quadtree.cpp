#include "physics/broadphase/loose_quadtree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/broadphase/partitioned_broad_phase.hpp"
#include "physics/model/side_table.hpp"

namespace plumb::physics {

namespace {

constexpr float kFar = 0x1p40f;        // m: no squares beyond this distance
constexpr float kSmallest = 0x1p-12f;  // m: minimum half width of a square
constexpr std::uint32_t kMany = 8;     // a square with more boxes than this is split

/// The smallest power of two that is at least x.
float powerAbove(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(((bits + 0x7fffffu) >> 23) << 23);
}

}  // namespace

void LooseQuadtree::visitRegions(const std::function<void(const AABB&)>& visit) const {
    for (std::size_t i = kOutside + 1; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        const Vec2 half{node.half, node.half};
        if (node.count > 0) visit({node.middle - half, node.middle + half});
    }
}

bool LooseQuadtree::isOutside(const AABB& box) {
    const auto isNear = [](Vec2 point) { return std::fabs(point.x) < kFar && std::fabs(point.y) < kFar; };
    return !(isNear(box.min) && isNear(box.max));
}

LooseQuadtree::Goal LooseQuadtree::goalOf(const AABB& box) {
    const Vec2 size = box.size();
    return {middleOf(box), powerAbove(std::max({size.x * 0.5f, size.y * 0.5f, kSmallest}))};
}

bool LooseQuadtree::holds(const Node& node, const Goal& goal) {
    return node.half >= goal.half && std::fabs(goal.middle.x - node.middle.x) <= node.half &&
           std::fabs(goal.middle.y - node.middle.y) <= node.half;
}

void LooseQuadtree::makeChildren(std::uint32_t node) {
    const Node parent = nodes_[node];
    const float half = parent.half * 0.5f;
    nodes_[node].children = static_cast<std::uint32_t>(nodes_.size());
    for (int i = 0; i < 4; ++i) {
        const Vec2 displacement{i % 2 == 0 ? -half : half, i / 2 == 0 ? -half : half};
        nodes_.push_back({kNowhere, parent.middle + displacement, half, node});
    }
}

/// Doubles the root until it holds the goal: the former root becomes a quarter of the new one, and so on.
void LooseQuadtree::growRoot(const Goal& goal) {
    if (root_ == kNone) {
        root_ = static_cast<std::uint32_t>(nodes_.size());
        const float size = goal.half * 2.0f;
        const Vec2 corner{std::floor(goal.middle.x / size) * size, std::floor(goal.middle.y / size) * size};
        nodes_.push_back({kNowhere, corner + Vec2{goal.half, goal.half}, goal.half});
    }
    while (!holds(nodes_[root_], goal)) {
        Node old = nodes_[root_];
        const Vec2 displacement{goal.middle.x < old.middle.x ? -old.half : old.half,
                                goal.middle.y < old.middle.y ? -old.half : old.half};
        nodes_[root_] = {old.reach, old.middle + displacement, old.half * 2.0f};
        nodes_[root_].count = old.count;
        makeChildren(root_);
        const std::uint32_t quarter =
            nodes_[root_].children + ((displacement.x < 0.0f ? 1u : 0u) | (displacement.y < 0.0f ? 2u : 0u));
        old.parent = root_;
        nodes_[quarter] = old;
        for (std::uint32_t place = old.firstItem; place != kNone; place = items_[place].next)
            items_[place].node = quarter;
        for (std::uint32_t i = 0; i < 4 && old.children != kNone; ++i)
            nodes_[old.children + i].parent = quarter;
    }
}

std::uint32_t LooseQuadtree::childFor(std::uint32_t node, const Goal& goal) const {
    const Node& parent = nodes_[node];
    return parent.children +
           ((goal.middle.x >= parent.middle.x ? 1u : 0u) | (goal.middle.y >= parent.middle.y ? 2u : 0u));
}

/// Enlarges the bounds of a node and of those above it by a box.
void LooseQuadtree::reachOut(std::uint32_t node, const AABB& box) {
    for (; node != kNone && merged(nodes_[node].reach, box) != nodes_[node].reach; node = nodes_[node].parent)
        nodes_[node].reach = merged(nodes_[node].reach, box);
}

/// Counts one item less in the node.
void LooseQuadtree::leave(std::uint32_t node) {
    if (--nodes_[node].count == 0) nodes_[node].reach = kNowhere;
}

void LooseQuadtree::link(std::uint32_t place, std::uint32_t node) {
    Item& item = items_[place];
    item.node = node;
    item.previous = kNone;
    item.next = nodes_[node].firstItem;
    if (item.next != kNone) items_[item.next].previous = place;
    nodes_[node].firstItem = place;
    if (node != kOutside) reachOut(node, item.box);
}

void LooseQuadtree::unlink(std::uint32_t place) {
    const Item& item = items_[place];
    if (item.previous != kNone) {
        items_[item.previous].next = item.next;
    } else {
        nodes_[item.node].firstItem = item.next;
    }
    if (item.next != kNone) items_[item.next].previous = item.previous;
}

/// Creates the four quarters and moves down the items that they can hold.
void LooseQuadtree::split(std::uint32_t node) {
    makeChildren(node);
    std::uint32_t next = kNone;
    for (std::uint32_t place = nodes_[node].firstItem; place != kNone; place = next) {
        next = items_[place].next;
        const Goal goal = goalOf(items_[place].box);
        if (goal.half >= nodes_[node].half) continue;
        unlink(place);
        const std::uint32_t child = childFor(node, goal);
        ++nodes_[child].count;
        link(place, child);
    }
}

/// Inserts an item below the node `from`, which must hold it; kNone: below the root.
void LooseQuadtree::insert(std::uint32_t place, std::uint32_t from) {
    if (isOutside(items_[place].box)) return link(place, kOutside);
    const Goal goal = goalOf(items_[place].box);
    std::uint32_t node = from;
    if (node == kNone) {
        growRoot(goal);
        node = root_;
        ++nodes_[node].count;
    }
    while (nodes_[node].half > goal.half) {
        if (nodes_[node].children == kNone) {
            if (nodes_[node].count <= kMany) break;
            split(node);
        }
        node = childFor(node, goal);
        ++nodes_[node].count;
    }
    link(place, node);
}

void LooseQuadtree::read(const Proxies& proxies, std::uint32_t place, std::uint32_t id) {
    Item& item = items_[place];
    item.box = usable(proxies.bounds[id]);
    item.filter = proxies.filters[id];
    item.id = id;
    item.awake = proxies.motions[id] == ProxyMotion::Awake;
    all_.add(item.filter);
}

void LooseQuadtree::erase(std::uint32_t place) {
    unlink(place);
    for (std::uint32_t node = items_[place].node; node != kNone && node != kOutside;
         node = nodes_[node].parent)
        leave(node);
    items_[place].node = kNone;
    free_.push_back(place);
}

bool LooseQuadtree::isDue(std::size_t arrivals, std::uint32_t) const {
    // Most boxes are new, or boxes that moved on have left too many empty squares behind.
    return arrivals > size() || nodes_.size() > 2 * items_.size() + 4096;
}

void LooseQuadtree::add(const Proxies& proxies, std::span<const std::uint32_t> ids, const PlaceList& list) {
    for (const std::uint32_t id : ids) {
        const std::uint32_t place = takeIndex(free_, items_);
        read(proxies, place, id);
        insert(place, kNone);
        list.set(id, place);
    }
}

void LooseQuadtree::sort(const Proxies& proxies, std::span<std::uint32_t> ids, std::uint32_t,
                         const PlaceList& list) {
    nodes_.assign(1, {});
    items_.clear();
    free_.clear();
    root_ = kNone;
    all_ = {};
    curve_.sort(proxies.bounds, ids);
    add(proxies, ids, list);
}

void LooseQuadtree::find(const BoxSearches&, const AABB& box, const LineSweep* sweep, std::uint32_t mask,
                         std::vector<std::uint32_t>& found) const {
    const auto take = [&](const Item& item) {
        if ((item.filter.layers & mask) != 0) found.push_back(item.id);
    };
    if (sweep == nullptr) return visitNear(box, nullptr, [&](std::uint32_t place) { take(items_[place]); });
    visitNear(box, sweep, [&](std::uint32_t place) {
        if (mayCollide(*sweep, items_[place].box)) take(items_[place]);
    });
}

std::uint32_t LooseQuadtree::move(const Proxies& proxies, std::uint32_t place) {
    read(proxies, place, items_[place].id);
    const Item& item = items_[place];
    const std::uint32_t old = item.node;
    const bool isFar = isOutside(item.box);
    const Goal goal = goalOf(item.box);
    const auto fits = [&](std::uint32_t node) { return !isFar && holds(nodes_[node], goal); };
    if (old != kOutside && fits(old) && (nodes_[old].children == kNone || nodes_[old].half == goal.half)) {
        reachOut(old, item.box);
        return place;
    }
    // Goes up to the first square that holds the box, and down again from there.
    unlink(place);
    std::uint32_t node = old != kOutside ? old : kNone;
    while (node != kNone && !fits(node)) {
        leave(node);
        node = nodes_[node].parent;
    }
    insert(place, node);
    return place;
}

}  // namespace plumb::physics
