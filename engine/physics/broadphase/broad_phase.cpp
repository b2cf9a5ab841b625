#include "physics/broadphase/broad_phase.hpp"

#include <array>

#include "physics/broadphase/box_searches.hpp"
#include "physics/broadphase/grid.hpp"
#include "physics/broadphase/quadtree.hpp"
#include "physics/broadphase/regions.hpp"
#include "physics/broadphase/sweep_and_prune.hpp"
#include "physics/broadphase/tree.hpp"

namespace plumb::physics {

namespace {

struct Kind {
    std::string_view name;
    std::unique_ptr<BroadPhase> (*make)();
    void (*visitRegions)(const BroadPhase& broadPhase, RegionVisitor& visitor);
};

template <class Phase>
std::unique_ptr<BroadPhase> make() {
    return std::make_unique<Phase>(boxSearchesFor(simdWidth()));
}

template <class Phase>
void visitRegionsOf(const BroadPhase& broadPhase, RegionVisitor& visitor) {
    static_cast<const Phase&>(broadPhase).visitRegions(visitor);
}

template <class Phase>
constexpr Kind kindOf(std::string_view name) {
    return {name, &make<Phase>, &visitRegionsOf<Phase>};
}

constexpr std::array<Kind, static_cast<std::size_t>(BroadPhaseKind::Count)> kKinds{{
    kindOf<TreeBroadPhase>("tree"),
    kindOf<GridBroadPhase>("grid"),
    kindOf<SweepAndPruneBroadPhase>("sweep and prune"),
    kindOf<QuadtreeBroadPhase>("quadtree"),
}};

const Kind& entryOf(BroadPhaseKind kind) {
    const auto i = static_cast<std::size_t>(kind);
    return kKinds[i < kKinds.size() ? i : 0];
}

}  // namespace

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind) { return entryOf(kind).make(); }

std::string_view nameOf(BroadPhaseKind kind) { return entryOf(kind).name; }

void visitRegions(const BroadPhase& broadPhase, BroadPhaseKind kind, RegionVisitor& visitor) {
    entryOf(kind).visitRegions(broadPhase, visitor);
}

}  // namespace plumb::physics
