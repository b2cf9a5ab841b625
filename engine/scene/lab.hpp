#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/hash.hpp"
#include "ecs/entity.hpp"
#include "physics/world.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// Where a body of an experiment began.
struct LabStart {
    EntityId entity;
    Transform transform;
    RigidBody body;
};

/// What the experiment of a scene goes back to. A resource: snapshots and the hash include it.
struct Lab {
    EntityId experiment;  ///< whose starts these are
    std::vector<LabStart> starts;
    std::uint64_t run = 0;        ///< how often something began anew
    bool sliderMoved = false;     ///< since the run began
    bool sliderReleased = false;  ///< in this tick, after it was moved

    /// The component of an entity as the experiment begins with it; null for what is not remembered.
    [[nodiscard]] const void* startOf(EntityId entity, std::string_view component) const;
    [[nodiscard]] void* startOf(EntityId entity, std::string_view component) {
        return const_cast<void*>(static_cast<const Lab*>(this)->startOf(entity, component));
    }

    void addTo(Hasher& hasher) const;
};

/// A world beside the scene's own. A resource; copied with snapshots, but in no hash: nothing depends on it.
struct GhostWorlds {
    struct One {
        EntityId ghost;
        std::uint64_t made = 0;  ///< from which settings, in which run
        physics::World world;
    };
    std::vector<One> all;  ///< in the order of their entities

    [[nodiscard]] const One* find(EntityId ghost) const;
};

/// The past of all plots. A resource as GhostWorlds.
struct PlotPast {
    struct Curve {
        EntityId plot;
        EntityId source;            ///< a Ghost; empty: the scene itself
        std::uint64_t run = 0;      ///< that it belongs to
        double first = 0.0;         ///< the measure when it began
        bool same = false;          ///< now to the bit what the scene is
        std::uint64_t ticks = 0;    ///< since it began, all of them
        std::vector<float> values;  ///< one for each of the last ticks
    };
    std::vector<Curve> curves;

    [[nodiscard]] const Curve* find(EntityId plot, EntityId source) const;
};

}  // namespace plumb
