#pragma once

#include <optional>
#include <vector>

#include "box_physics/narrowphase/sweep.hpp"
#include "box_physics/world.hpp"

namespace plumb::box_physics {

/// Which bodies a query sees.
struct Filter {
    std::uint32_t layers = 1;          ///< bits: what the query is, for the masks of others
    std::uint32_t mask = 0xffffffffu;  ///< bits: what it meets
    BodyId except;                     ///< sees everything but this one
    bool triggers = false;             ///< triggers too
    bool oneWay = true;                ///< one-way surfaces too, from above
    bool movers = true;                ///< dynamic and kinematic bodies too
};

struct CastHit {
    BodyId body;
    Touch touch;
    Vec2 point;  ///< m
};

/// The first thing that a box or circle meets on its way. Overlaps at the start count unless the way leads
/// out of them.
std::optional<CastHit> shapeCast(World& world, const Mover& mover, const Settings& settings,
                                 const Filter& filter = {});

/// The first thing on a straight line from `from` along `path` (m).
std::optional<CastHit> rayCast(World& world, Vec2 from, Vec2 path, const Settings& settings,
                               const Filter& filter = {});

/// All bodies that overlap this box or circle, by index. `mover.path` is not used.
void overlap(World& world, Mover mover, const Settings& settings, const Filter& filter,
             std::vector<BodyId>& found);

}  // namespace plumb::box_physics
