#pragma once

#include <cstdint>
#include <vector>

#include "ecs/world.hpp"
#include "math/angle.hpp"
#include "math/vec2.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// Position, rotation and scale, without the values of the previous tick.
struct Pose {
    Vec2 position;           ///< px
    float rotation = 0.0f;   ///< rad, clockwise on screen
    Vec2 scale{1.0f, 1.0f};  ///< ratio

    friend bool operator==(const Pose&, const Pose&) = default;
};

/// Interpolates between the pose one tick ago (alpha 0) and
/// now (alpha 1). Rotation takes the shorter direction.
Pose blended(const Transform& transform, float alpha);
/// Like blended(), but faster and exact for alpha 1.
inline Pose interpolated(const Transform& transform, float alpha) {
    if (alpha >= 1.0f) return {transform.position, transform.rotation, transform.scale};
    return blended(transform, alpha);
}

/// Converts `child` from the frame of `parent` to the frame that `parent` is given in.
inline Pose composed(const Pose& parent, const Pose& child) {
    return {parent.position + rotated(scaled(child.position, parent.scale), parent.rotation),
            parent.rotation + child.rotation, scaled(parent.scale, child.scale)};
}
/// Inverse of composed(): converts `child` to the frame of `parent`.
Pose relativeTo(const Pose& parent, const Pose& child);

/// Returns the world pose of an entity: its Transform combined with those of its ancestors.
/// An entity without a Transform has the pose of its parent.
Pose worldPose(const World& world, EntityId entity, float alpha = 1.0f);

/// World poses of many entities, as worldPose() with the same bits: the pose of a common ancestor is computed
/// once, so that the poses of a chain of n entities cost O(n), not O(n²).
class WorldPoses {
public:
    WorldPoses() = default;
    /// A copy is empty: what is remembered is not part of a state.
    WorldPoses(const WorldPoses&) : WorldPoses{} {}
    WorldPoses& operator=(const WorldPoses&) { return clear(), *this; }

    /// @pre since clear(), the world has not changed, or forget() was called for each change
    Pose of(const World& world, EntityId entity, float alpha = 1.0f);
    /// Returns the pose of an entity with this parent and this pose relative to it.
    Pose of(const World& world, const Pose& own, EntityId parent, float alpha = 1.0f) {
        return parent ? composed(of(world, parent, alpha), own) : own;
    }
    /// To be called when the Transform of an entity was written.
    void forget(EntityId entity) {
        if (isKnown(entity)) clear();
    }
    /// To be called when the world may have changed.
    void clear() { ++pass_; }

private:
    struct Known {
        std::uint64_t pass = 0;  // the pose is valid if this is the current one
        std::uint32_t generation = 0;
        Pose pose;
    };

    [[nodiscard]] bool isKnown(EntityId id) const {
        return id.index < known_.size() && known_[id.index].pass == pass_ &&
               known_[id.index].generation == id.generation;
    }

    std::vector<Known> known_;    // indexed by EntityId::index
    std::vector<EntityId> path_;  // of(): the ancestors whose pose is not known; a member to reuse its memory
    std::uint64_t pass_ = 1;
    float alpha_ = 1.0f;
};

/// Copies the current pose of every Transform and the zoom of every Camera to their `previous` fields. Call
/// at the start of a tick; drawing interpolates from there.
void storePreviousTransforms(World& world);

}  // namespace plumb
