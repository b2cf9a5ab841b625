#pragma once

#include "physics/contact.hpp"

namespace plumb::physics {

struct World;

/// What the owner of a world may say about contacts. Called in a fixed order, by the thread that steps; they
/// must answer alike for alike worlds, or the same steps no longer give the same bits.
struct ContactHooks {
    void* context = nullptr;  ///< given back to the functions
    /// May these two meet? Asked when their bounds begin to overlap; after a no, when one has moved on.
    bool (*filter)(void* context, const World& world, ShapeId a, ShapeId b) = nullptr;
    /// Does this contact push in this step? Asked in each step while they touch.
    bool (*preSolve)(void* context, const World& world, const Contact& contact) = nullptr;
};

}  // namespace plumb::physics
