#pragma once

#include "physics/stages.hpp"

namespace plumb::physics {

/// Layers of Workspace::sweptProxies: bullets search for all of them, other bodies for some.
inline constexpr std::uint32_t kBulletLayer = 1, kFastLayer = 2, kKinematicLayer = 4;

/// So few paths of a step are looked at one by one: that takes a fiftieth of a search in a tree of them and
/// of its part in making it.
inline bool areFewPaths(const Workspace& work) { return work.fastBodies.size() <= 48; }

inline bool isBullet(const World& world, std::uint32_t body) {
    return (world.bodies.info[body].flags & kBullet) != 0;
}
/// By contacts or joints.
inline bool isHeld(const StepContext& step, std::uint32_t body) { return step.work.colourMasks[body] != 0; }
inline int hitsOf(const Workspace& work, std::uint32_t body) {
    const std::uint32_t place = work.bodyScratch[body];
    return place == kNone ? 0 : work.swept[place].hits;
}

/// The path of a body through this step: from where it is now and how far it was moved.
Sweep pathOf(const StepContext& step, std::uint32_t body);
/// The path of a body that may be hit. One that does not move or is held is slow: it is met where it is.
Sweep pathOfMet(const StepContext& step, std::uint32_t body);
/// Whether a body may pass something thin that moves along `path`: what lies in a drum does not, however fast
/// the drum rotates.
bool isFastBeside(const Sweep& own, const Sweep& path, const BodyInfo& info);
SweptBody sweptBodyOf(const StepContext& step, std::uint32_t body);

/// No point of a body is faster than bodies may be. Spins that nothing limits would grow until they are no
/// numbers, where joints have arms of many times a body's size.
void limitMotion(World& world, std::uint32_t body);

std::uint32_t layerOf(const World& world, std::uint32_t body);
/// The bounds of the rest of a body's path.
AABB pathBounds(const StepContext& step, const SweptBody& swept);
/// Finds what a body hits next. Searches give what is near in an order of their own; of two hits at one time
/// that of the lower number counts.
/// @param found  scratch memory
void findNextHit(const StepContext& step, std::size_t place, std::vector<std::uint32_t>& found,
                 DetectionCounts& counts);

}  // namespace plumb::physics
