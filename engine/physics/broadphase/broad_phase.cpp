#include "physics/broadphase/broad_phase.hpp"

#include <array>

#include "physics/broadphase/hierarchical_grid.hpp"
#include "physics/broadphase/quadtree.hpp"
#include "physics/broadphase/row_broad_phase.hpp"
#include "physics/broadphase/sweep_and_prune_axis.hpp"
#include "physics/broadphase/tree.hpp"

namespace plumb::physics {

namespace {

struct Kind {
    std::string_view name;
    std::unique_ptr<BroadPhase> (*make)();
};

template <class Phase>
std::unique_ptr<BroadPhase> make() {
    return std::make_unique<Phase>();
}

constexpr std::array<Kind, static_cast<std::size_t>(BroadPhaseKind::Count)> kKinds{{
    {"tree", &make<TreeBroadPhase>},
    {"grid", &make<RowBroadPhase<HierarchicalGrid>>},
    {"sweep and prune", &make<RowBroadPhase<SweepAndPruneAxis>>},
    {"quadtree", &make<QuadtreeBroadPhase>},
}};

const Kind& entryOf(BroadPhaseKind kind) {
    const auto i = static_cast<std::size_t>(kind);
    return kKinds[i < kKinds.size() ? i : 0];
}

}  // namespace

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind) { return entryOf(kind).make(); }

std::string_view nameOf(BroadPhaseKind kind) { return entryOf(kind).name; }

}  // namespace plumb::physics
