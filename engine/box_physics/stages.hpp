#pragma once

#include "box_physics/simulation.hpp"

namespace plumb::box_physics {

/// What every stage is given.
struct StepContext {
    World& world;
    const Settings& settings;
    float dt;  ///< s
    unsigned effects;
    Vec2 up;
};

// One line per stage, in the order of the step; each has a file of its own name in stages/.

/// Writes: velocity, work.pull, work.path, work.bounds, work.movers. Reads: acceleration, target.
void applyForces(StepContext& step);
/// Writes: work.pairs (sorted), work.fixedGrid when stale. Reads: work.bounds, filters.
void findPairs(StepContext& step);
/// Writes: work.contacts (sorted as the pairs), work.order. Reads: work.pairs, shapes, work.path.
void updateContacts(StepContext& step);
/// Writes: velocity, work.shift, impulses in work.contacts, grounded.
void solveContacts(StepContext& step);
/// Writes: position, moved. Reads: velocity, work.shift, work.contacts.
void moveBodies(StepContext& step);
/// Writes: events, touching. Reads: work.contacts.
void publishEvents(StepContext& step);

}  // namespace plumb::box_physics
