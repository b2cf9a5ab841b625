#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Layers of Workspace::sweptProxies: bullets search for all of them, other bodies for some.
inline constexpr std::uint32_t kBulletLayer = 1, kFastLayer = 2, kKinematicLayer = 4;

/// So few paths in a step are tested one by one: that takes
/// a fiftieth of the time of building and searching a tree.
inline bool areFewPaths(const Workspace& work) { return work.fastBodies.size() <= 48; }

inline bool isBullet(const World& world, std::uint32_t body) {
    return (world.bodies.info[body].flags & kBullet) != 0;
}
/// True if contacts or joints hold the body.
inline bool isHeld(const StepContext& step, std::uint32_t body) { return step.work.colourMasks[body] != 0; }
inline int hitsOf(const Workspace& work, std::uint32_t body) {
    const std::uint32_t place = work.bodyScratch[body];
    return place == kNone ? 0 : work.swept[place].hits;
}

/// The path of a body through this step, from its current pose and its displacement in the step.
Sweep pathOf(const StepContext& step, std::uint32_t body);
/// The path of a body that may be hit. A body that does not move, or is held, is treated as at rest.
Sweep pathOfMet(const StepContext& step, std::uint32_t body);
/// True if a body may tunnel through something thin that moves along `path`. A
/// body that lies in a drum and rotates with it may not, however fast the drum is.
bool isFastBeside(const Sweep& own, const Sweep& path, const BodyInfo& info);
SweptBody sweptBodyOf(const StepContext& step, std::uint32_t body);

/// Limits the speed of all points of a body. Otherwise spin could grow until
/// it is not finite, where joints have arms of many times the body's size.
void limitMotion(World& world, std::uint32_t body);

std::uint32_t layerOf(const World& world, std::uint32_t body);
/// Bounds of the remaining path of a body.
AABB pathBounds(const StepContext& step, const SweptBody& swept);
/// Finds the next hit of a body. Of two hits at the same time the lower
/// shape index counts, because the order of search results is arbitrary.
/// @param found  scratch memory
void findNextHit(const StepContext& step, std::size_t place, std::vector<std::uint32_t>& found,
                 DetectionCounts& counts);

}  // namespace plumb::physics
