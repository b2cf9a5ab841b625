#include "physics/broadphase/box_tree.hpp"

#include "core/cpu.hpp"
#include "physics/broadphase/box_searches.hpp"

namespace plumb::physics {

void BoxTree::clear() {
    tree_.clear();
    bounds_.clear();
    filters_.clear();
    motions_.clear();
    places_.clear();
    arrivals_.clear();
}

void BoxTree::add(const AABB& box, std::uint32_t layers) {
    arrivals_.push_back(static_cast<std::uint32_t>(bounds_.size()));
    bounds_.push_back(box);
    filters_.push_back({.layers = layers});
    motions_.push_back(ProxyMotion::Awake);
    places_.push_back(0);
}

void BoxTree::settle() {
    static_cast<void>(tree_.take({bounds_, filters_, motions_}, arrivals_, 0, places_, 0));
    tree_.settle(0);
    arrivals_.clear();
}

void BoxTree::cast(Vec2 from, Vec2 way, Vec2 half, std::uint32_t mask,
                   std::vector<std::uint32_t>& found) const {
    if (tree_.size() == 0) return;
    static const BoxSearches& searches = boxSearchesFor(simdWidth());
    searches.trees.findOnSweep(tree_, lineSweep(from, way, half), mask, found);
}

}  // namespace plumb::physics
