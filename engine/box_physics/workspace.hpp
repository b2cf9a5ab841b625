#pragma once

#include <cstdint>
#include <vector>

#include "box_physics/broadphase/cell_grid.hpp"
#include "box_physics/contact_event.hpp"
#include "box_physics/narrowphase/contact.hpp"

namespace plumb::box_physics {

/// Two bodies whose paths come near each other; a is the lower index.
struct Pair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend bool operator==(Pair, Pair) = default;
};

/// Memory that a step needs and the next one reuses. Everything in it follows from the world, so a copy of
/// the world leaves it behind and builds its own.
struct Workspace {
    std::vector<Vec2> path;                  ///< m: how far each body would go if nothing were in the way
    std::vector<Vec2> pull;                  ///< m/s2: acceleration of each body in this step
    std::vector<Vec2> shift;                 ///< m: what contacts add to the way of each body
    std::vector<AABB> bounds;                ///< m: of each body over the whole step
    std::vector<std::uint8_t> marks;         ///< bits of BodyMark
    std::vector<std::uint32_t> movers;       ///< indices of bodies that move
    std::vector<std::uint32_t> broad;        ///< static bodies too large for the grid, and tile fields
    std::vector<std::uint32_t> gridded;      ///< static bodies that are no tile fields
    std::vector<std::uint32_t> largeMovers;  ///< that reach too many cells
    std::vector<Pair> pairs;
    std::vector<Pair> unsortedPairs;
    std::vector<std::uint32_t> counts;
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> order;  ///< of contacts: between movable bodies first, against fixed ones last
    std::vector<float> earliest;       ///< part of the step at which each body first hits something fixed
    std::vector<ContactEvent> touching;  ///< the pairs of this step, before they replace the world's
    CellGrid fixedGrid;                  ///< static bodies; kept until one changes
    CellGrid movingGrid;
    bool fixedGridStale = true;

    Workspace() = default;
    Workspace(const Workspace&) {}
    Workspace& operator=(const Workspace&) { return fixedGridStale = true, *this; }
    Workspace(Workspace&&) noexcept = default;
    Workspace& operator=(Workspace&&) noexcept = default;
    ~Workspace() = default;
};

enum BodyMark : std::uint8_t {
    kInContact = 1,   ///< a solid contact holds or will hold it in this step
    kNeedsSweep = 2,  ///< so fast that its way must be checked again after the solver
};

}  // namespace plumb::box_physics
