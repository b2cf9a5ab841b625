#pragma once

#include <span>

#include "physics/workspace.hpp"

namespace plumb::physics {

// Finds the fields that may act on a body by the boxes in which they act: many small fields cost no more than
// what they overlap. A field without bounds may act on everything. Springs are left out, as they know their
// bodies.

/// Updates Workspace::fieldBoxes to fields that were changed, and bodies of attractors that moved.
void updateFieldBoxes(const World& world, Workspace& work);

/// The fields that may act on a body, ascending: all for which actsOn() holds, and a few others. Valid until
/// the next call.
/// @param kinds  bits, 1 << FieldKind: those to search for; others may be among the result
std::span<const std::uint32_t> fieldsNear(const World& world, Workspace& work, std::uint32_t body,
                                          std::uint32_t kinds);

/// Calls act(body, field) for all awake bodies and the fields that act on them; `kinds` as above.
template <class Act>
void forFieldsOnBodies(const World& world, Workspace& work, std::uint32_t kinds, Act&& act) {
    updateFieldBoxes(world, work);
    for (const std::uint32_t body : world.awake) {
        if (!isDynamic(world, body)) continue;
        for (const std::uint32_t f : fieldsNear(world, work, body, kinds)) {
            if (actsOn(world, world.fields.all[f].definition, body)) act(body, f);
        }
    }
}

}  // namespace plumb::physics
