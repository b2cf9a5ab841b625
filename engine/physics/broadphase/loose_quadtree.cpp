#include "physics/broadphase/loose_quadtree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "physics/broadphase/overlap.hpp"
#include "physics/broadphase/spread.hpp"

namespace plumb::physics {

namespace {

constexpr float kFar = 0x1p40f;           // m: further out there are no squares
constexpr float kSmallest = 0x1p-20f;     // m
constexpr float kLeastOfSpacing = 0.25f;  // smaller squares tell nobody apart

/// The power of two that is not below x.
float powerAbove(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(((bits + 0x7fffffu) >> 23) << 23);
}

}  // namespace

void LooseQuadtree::clear() {
    nodes_.clear();
    items_.clear();
    free_.clear();
    root_ = kNobody;
    size_ = chosenFor_ = 0;
    layers_ = masks_ = 0;
}

bool LooseQuadtree::isOutside(const AABB& box) const {
    const auto isNear = [](Vec2 point) { return std::fabs(point.x) < kFar && std::fabs(point.y) < kFar; };
    return !(isNear(box.min) && isNear(box.max));
}

LooseQuadtree::Goal LooseQuadtree::goalOf(const AABB& box) const {
    const Vec2 size = box.size();
    return {middleOf(box), powerAbove(std::max({size.x * 0.5f, size.y * 0.5f, leastHalf_}))};
}

bool LooseQuadtree::holds(const Node& node, const Goal& goal) {
    return node.half >= goal.half && std::fabs(goal.middle.x - node.middle.x) <= node.half &&
           std::fabs(goal.middle.y - node.middle.y) <= node.half;
}

void LooseQuadtree::growRoot(const Goal& goal) {
    if (root_ == kNobody) {
        root_ = static_cast<std::uint32_t>(nodes_.size());
        const float size = goal.half * 2.0f;
        const Vec2 corner{std::floor(goal.middle.x / size) * size, std::floor(goal.middle.y / size) * size};
        nodes_.push_back({corner + Vec2{goal.half, goal.half}, goal.half});
    }
    while (!holds(nodes_[root_], goal)) {
        const Node old = nodes_[root_];
        const Vec2 way{goal.middle.x < old.middle.x ? -old.half : old.half,
                       goal.middle.y < old.middle.y ? -old.half : old.half};
        Node node{old.middle + way, old.half * 2.0f};
        node.children[(way.x < 0.0f ? 1u : 0u) | (way.y < 0.0f ? 2u : 0u)] = root_;
        node.count = old.count;
        nodes_[root_].parent = static_cast<std::uint32_t>(nodes_.size());
        root_ = nodes_[root_].parent;
        nodes_.push_back(node);
    }
}

std::uint32_t LooseQuadtree::childFor(std::uint32_t node, const Goal& goal) {
    const bool right = goal.middle.x >= nodes_[node].middle.x;
    const bool below = goal.middle.y >= nodes_[node].middle.y;
    const std::size_t quarter = (right ? 1u : 0u) | (below ? 2u : 0u);
    if (nodes_[node].children[quarter] == kNobody) {
        const float half = nodes_[node].half * 0.5f;
        const Vec2 middle = nodes_[node].middle + Vec2{right ? half : -half, below ? half : -half};
        nodes_[node].children[quarter] = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({middle, half, node});
    }
    return nodes_[node].children[quarter];
}

void LooseQuadtree::link(std::uint32_t place, std::uint32_t node) {
    Item& item = items_[place];
    item.node = node;
    item.previous = kNobody;
    item.next = nodes_[node].firstItem;
    if (item.next != kNobody) items_[item.next].previous = place;
    nodes_[node].firstItem = place;
}

void LooseQuadtree::unlink(std::uint32_t place) {
    const Item& item = items_[place];
    if (item.previous != kNobody) {
        items_[item.previous].next = item.next;
    } else {
        nodes_[item.node].firstItem = item.next;
    }
    if (item.next != kNobody) items_[item.next].previous = item.previous;
}

/// Puts an item below a node that holds it, or kNobody for the top.
void LooseQuadtree::insert(std::uint32_t place, std::uint32_t from) {
    if (isOutside(items_[place].box)) return link(place, kOutside);
    const Goal goal = goalOf(items_[place].box);
    std::uint32_t node = from;
    if (node == kNobody) {
        growRoot(goal);
        node = root_;
        ++nodes_[node].count;
    }
    while (nodes_[node].half > goal.half) {
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
    layers_ |= item.filter.layers | overruledBy(item.filter.group);
    masks_ |= item.filter.mask | overruledBy(item.filter.group);
}

bool LooseQuadtree::mayMeet(const Filter& filter) const {
    const std::uint32_t overruled = overruledBy(filter.group);
    return ((filter.layers | overruled) & masks_) != 0 && ((filter.mask | overruled) & layers_) != 0;
}

void LooseQuadtree::erase(std::uint32_t place) {
    unlink(place);
    for (std::uint32_t node = items_[place].node; node != kNobody && node != kOutside;
         node = nodes_[node].parent)
        --nodes_[node].count;
    items_[place].node = kNobody;
    free_.push_back(place);
    --size_;
}

bool LooseQuadtree::isDue(std::size_t arrivals) const {
    // Squares may be too large or too small by now, and empty ones too many.
    return size_ + arrivals > 2 * std::size_t{chosenFor_} || nodes_.size() > 8 * items_.size() + 4096;
}

bool LooseQuadtree::take(const Proxies& proxies, std::span<std::uint32_t> arrivals, std::uint32_t,
                         std::span<std::uint32_t> places, std::uint32_t first) {
    std::vector<std::uint32_t> all;
    const bool isNew = isDue(arrivals.size());
    if (isNew) {
        for (const Item& item : items_) {
            if (item.node != kNobody) all.push_back(item.id);
        }
        all.insert(all.end(), arrivals.begin(), arrivals.end());
        arrivals = all;
        clear();
        nodes_.push_back({});
        chosenFor_ = static_cast<std::uint32_t>(arrivals.size());
        const Spread spread = spreadOf(proxies, arrivals);
        leastHalf_ = powerAbove(
            std::clamp(std::max(spread.extent * 0.5f, spread.spacing * kLeastOfSpacing), kSmallest, kFar));
    }
    for (const std::uint32_t id : arrivals) {
        auto place = static_cast<std::uint32_t>(items_.size());
        if (free_.empty()) {
            items_.emplace_back();
        } else {
            place = free_.back();
            free_.pop_back();
        }
        read(proxies, place, id);
        insert(place, kNobody);
        ++size_;
        places[id] = first + place;
    }
    return isNew;
}

std::uint32_t LooseQuadtree::move(const Proxies& proxies, std::uint32_t place) {
    read(proxies, place, items_[place].id);
    const Item& item = items_[place];
    const std::uint32_t old = item.node;
    if (old == kOutside || isOutside(item.box)) {
        erase(place);
        free_.pop_back();
        ++size_;
        insert(place, kNobody);
        return place;
    }
    const Goal goal = goalOf(item.box);
    if (nodes_[old].half == goal.half && holds(nodes_[old], goal)) return place;
    // Up to the first square that holds it, and down again.
    unlink(place);
    std::uint32_t node = old;
    while (node != kNobody && !holds(nodes_[node], goal)) {
        --nodes_[node].count;
        node = nodes_[node].parent;
    }
    insert(place, node);
    return place;
}

}  // namespace plumb::physics
