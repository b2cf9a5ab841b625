#pragma once

#include <cstdint>

#include "physics/world.hpp"

namespace plumb::physics {

/// What a body's shapes are to the broad phase now.
ProxyMotion motionOf(const World& world, std::uint32_t shape);

/// The frame of a body's shapes, near enough to the origin to be float.
inline Frame frameOf(const BodyPose& pose) {
    return {toVec2(pose.centre) - rotate(pose.rotation, pose.localCentre), pose.rotation};
}

/// m: the shape where it is now, without a margin.
AABB tightBounds(const World& world, std::uint32_t shape);

/// Gives a new shape its bounds and has it looked up.
void setBounds(World& world, std::uint32_t shape);
/// The same for all shapes of a body that jumped.
void refreshBounds(World& world, std::uint32_t body);

/// The broad phase has to be told of the shape.
void noteChanged(World& world, std::uint32_t shape);
/// The broad phase has to look for pairs of the shape in the next step.
void noteMoved(World& world, std::uint32_t shape);

/// Something that contacts copied from the shape has changed.
void refreshContacts(World& world, std::uint32_t shape);
/// The same for all shapes of a body that turns otherwise than before.
void refreshContactsOf(World& world, std::uint32_t body);

}  // namespace plumb::physics
