#include "physics/broadphase/broad_phase.hpp"

#include <array>

namespace plumb::physics {

std::string_view nameOf(BroadPhaseKind kind) {
    constexpr std::array<std::string_view, static_cast<std::size_t>(BroadPhaseKind::Count)> kNames{
        "tree", "grid", "sweep and prune", "quadtree"};
    return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace plumb::physics
