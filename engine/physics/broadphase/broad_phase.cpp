#include "physics/broadphase/broad_phase.hpp"

#include <array>

#include "physics/broadphase/partitioned_broad_phase.hpp"

namespace plumb::physics {

namespace {

struct Kind {
    std::string_view name;
    std::unique_ptr<BroadPhase> (*make)();
};

constexpr std::array<Kind, static_cast<std::size_t>(BroadPhaseKind::Count)> kKinds{{
    {"tree", makeTree},
    {"grid", makeGrid},
    {"sweep and prune", makeSweepAndPrune},
    {"quadtree", makeQuadtree},
}};

const Kind& entryOf(BroadPhaseKind kind) {
    const auto i = static_cast<std::size_t>(kind);
    return kKinds[i < kKinds.size() ? i : 0];
}

}  // namespace

std::unique_ptr<BroadPhase> makeBroadPhase(BroadPhaseKind kind) { return entryOf(kind).make(); }

std::string_view nameOf(BroadPhaseKind kind) { return entryOf(kind).name; }

}  // namespace plumb::physics
