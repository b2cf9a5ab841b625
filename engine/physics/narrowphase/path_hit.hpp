#pragma once

#include "physics/narrowphase/sweep.hpp"

namespace plumb::physics {

/// What a body meets next on its path.
struct PathHit {
    float part = kNever;
    std::uint32_t shape = kNone;  ///< of the body
    std::uint32_t met = kNone;    ///< the other shape
    int metHits = 0;              ///< of the other body: when it has more, its path is another one
    bool isPressed = false;       ///< they touched from the start, and now a core would pass
};

/// A body that moved fast, or was hit by one that did.
struct SweptBody {
    std::uint32_t body = kNone;
    Sweep sweep;                   ///< since its last hit
    Vec2 pull;                     ///< m/s2: by how much it gets faster on this path
    bool isHeld = false;           ///< by contacts or joints: a hit stops it, and the solver does the rest
    int hits = 0;                  ///< that changed its path
    std::uint32_t passed = kNone;  ///< shape that the owner of the world let it pass
    PathHit next;
};

/// A shape and its path.
struct Mover {
    std::uint32_t shape;
    const Sweep& sweep;
    bool goesOn = false;  ///< after a hit
};

/// Notes what the mover hits, if that is before `next`.
void meetOnPath(const World& world, const Mover& mover, const Mover& target, PathHit& next);

}  // namespace plumb::physics
