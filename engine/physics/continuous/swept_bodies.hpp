#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Filter layers of the proxies in Workspace::sweptProxies. Bullets search all three, other bodies only some.
inline constexpr std::uint32_t kBulletLayer = 1, kFastLayer = 2, kKinematicLayer = 4;

/// True if the step has so few paths that testing each pair is faster than a tree (by a factor of 50).
inline bool areFewPaths(const Workspace& work) { return work.fastBodies.size() <= 48; }

inline bool isBullet(const World& world, std::uint32_t body) {
    return (world.bodies.info[body].flags & kBullet) != 0;
}
/// True if contacts or joints act on the body in this step.
inline bool isHeld(const StepContext& step, std::uint32_t body) { return step.work.colourMasks[body] != 0; }
inline int hitsOf(const Workspace& work, std::uint32_t body) {  // SweptBody::hits; 0 if not swept
    const std::uint32_t place = work.bodyScratch[body];
    return place == kNone ? 0 : work.swept[place].hits;
}

/// Returns the path of a body through this step, from its current pose and its displacement in the step.
Sweep pathOf(const StepContext& step, std::uint32_t body);
/// Returns the path of any body in this step; of a swept one, its path since its last hit. A body that is not
/// swept rests if it is static or held (isHeld()).
Sweep currentPathOf(const StepContext& step, std::uint32_t body);
/// True if a body with the path `own` may tunnel through a thin shape that moves along `path`. False for a
/// body that lies in a drum and rotates with it, at any speed of the drum.
bool isFastBeside(const Sweep& own, const Sweep& path, const BodyInfo& info);
SweptBody sweptBodyOf(const StepContext& step, std::uint32_t body);

/// Limits the speed of all points of a body. Without a limit the angular velocity could become infinite where
/// the arms of joints are many times longer than the body.
void limitMotion(World& world, std::uint32_t body);

inline std::uint32_t layerOf(const World& world, std::uint32_t body) {
    if (!isDynamic(world, body)) return kKinematicLayer;
    return isBullet(world, body) ? kBulletLayer : kFastLayer;
}
/// Returns the bounds of the remaining path of a body.
AABB pathBounds(const StepContext& step, const SweptBody& swept);
/// Finds the next hit of work.swept[place] and stores it in SweptBody::next. Of two hits at the same time it
/// takes the one with the lower shape index, because the order of search results is arbitrary.
/// @param found  scratch memory
void findNextHit(const StepContext& step, std::size_t place, std::vector<std::uint32_t>& found,
                 DetectionCounts& counts);

}  // namespace plumb::physics
