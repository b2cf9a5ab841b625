#pragma once

#include <cstdint>
#include <vector>

#include "ecs/entity.hpp"
#include "math/rect.hpp"

namespace plumb::editor {

class Document;

/// The boxes around all entities of a scene, side by side in memory, so that looking for what lies under the
/// mouse in every frame costs little in a scene of 100,000 things. They follow the world by its own marks of
/// what was written, whatever wrote it.
class SceneBoxes {
public:
    /// Of the entity at this place of `Document::objects()`. One without a place has a box that contains
    /// nothing.
    [[nodiscard]] const AABB& at(std::size_t place) const { return boxes_[place]; }
    /// @pre the entity is one of the document
    [[nodiscard]] const AABB& of(EntityId entity) const { return boxes_[placeOf_[entity.index]]; }

    /// Calls visit(place) for all whose box touches `area`, if only with its left or upper edge, in order.
    template <class Visit>
    void eachTouching(const AABB& area, Visit&& visit) const {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const AABB& box = boxes_[i];
            // All four at once: a guess at each of them would be wrong too often.
            const bool across = (box.min.x <= area.max.x) & (area.min.x < box.max.x);
            const bool down = (box.min.y <= area.max.y) & (area.min.y < box.max.y);
            if (across & down) visit(i);
        }
    }

    /// Makes anew what may have changed since.
    void follow(const Document& document);

private:
    static constexpr std::uint32_t kNowhere = ~0u;

    void makeAll(const Document& document);
    void update(const Document& document, EntityId entity);
    /// With all below it, unless that was done in this look already.
    void updateMoved(const Document& document, EntityId entity);

    std::vector<AABB> boxes_;
    std::vector<EntityId> entities_;      // of each place
    std::vector<std::uint32_t> placeOf_;  // by index of the entity
    std::vector<std::uint32_t> lookOf_;   // at each place, the last one that moved its box
    std::uint32_t look_ = 0;
    std::vector<EntityId> restless_;  // what changes without a component being written
    std::uint64_t tree_ = ~0ull;
    std::uint64_t members_ = 0;
    std::uint64_t mark_ = 0;
};

}  // namespace plumb::editor
