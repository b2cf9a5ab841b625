#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/hash.hpp"
#include "core/state_archive.hpp"
#include "ecs/entity.hpp"
#include "physics/world.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/transform.hpp"

namespace plumb {

/// Initial state of a body in an experiment.
struct LabStart {
    EntityId entity;
    Transform transform;
    RigidBody body;
};

/// State of a scene's Experiment: the initial state of its
/// bodies. A world resource, included in snapshots and hash.
struct Lab {
    EntityId experiment;  ///< entity of the Experiment that `starts` belongs to
    std::vector<LabStart> starts;
    std::uint64_t run = 0;        ///< incremented at every start and restart
    bool sliderMoved = false;     ///< a slider was moved since the run started
    bool sliderReleased = false;  ///< a moved slider was released in this tick

    /// Returns the initial value of an entity's component; null if it is not stored.
    [[nodiscard]] const void* startOf(EntityId entity, std::string_view component) const;
    [[nodiscard]] void* startOf(EntityId entity, std::string_view component) {
        return const_cast<void*>(static_cast<const Lab*>(this)->startOf(entity, component));
    }

    void addTo(Hasher& hasher) const;
    void archive(StateArchive& archive);
};

/// Physics worlds of all ghosts. A world resource; copied with snapshots, but not part of the hash, as the
/// simulation does not depend on it.
struct GhostWorlds {
    struct One {
        EntityId ghost;          ///< entity with the Ghost component
        std::uint64_t made = 0;  ///< hash of the ghost's settings and of Lab::run at its creation
        physics::World world;
    };
    std::vector<One> all;  ///< in order of creation

    [[nodiscard]] const One* find(EntityId ghost) const;
    /// They begin anew in a saved game.
    void archive(StateArchive& archive) {
        if (archive.reading()) all.clear();
    }
};

/// Recorded curves of all plots. A world resource that is, like GhostWorlds, not part of the hash.
struct PlotPast {
    struct Curve {
        EntityId plot;              ///< entity with the Plot component
        EntityId source;            ///< entity of a Ghost; empty: the scene's own physics
        std::uint64_t run = 0;      ///< Lab::run that the curve belongs to
        double first = 0.0;         ///< first value of the measured quantity, before normalization
        bool same = false;          ///< the ghost's state is bit-identical to the scene's
        std::uint64_t ticks = 0;    ///< number of ticks since the curve started
        std::vector<float> values;  ///< one value per tick, most recent last; limited to the plot's time axis
    };
    std::vector<Curve> curves;

    [[nodiscard]] const Curve* find(EntityId plot, EntityId source) const;
    /// They begin anew in a saved game.
    void archive(StateArchive& archive) {
        if (archive.reading()) curves.clear();
    }
};

}  // namespace plumb
