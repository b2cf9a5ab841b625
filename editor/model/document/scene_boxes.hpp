#pragma once

#include <cstdint>
#include <vector>

#include "ecs/entity.hpp"
#include "math/rect.hpp"

namespace plumb::editor {

class Document;

/// Cache of the boxes of all entities of a scene in one array, so that picking under the mouse every frame is
/// fast even with 100,000 entities. Updated through the world's change tracking.
class SceneBoxes {
public:
    /// Returns the box of the entity at this index of `Document::objects()`: an empty one if it has no
    /// Transform.
    [[nodiscard]] const AABB& at(std::size_t place) const { return boxes_[place]; }
    /// Returns the box of an entity. @pre the entity belongs to the document
    [[nodiscard]] const AABB& of(EntityId entity) const { return boxes_[placeOf_[entity.index]]; }

    /// Calls visit(index in `Document::objects()`), in ascending order, for each box that overlaps `area` or
    /// whose left or upper edge touches it.
    template <class Visit>
    void eachTouching(const AABB& area, Visit&& visit) const {
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            const AABB& box = boxes_[i];
            // Non-short-circuit & avoids four unpredictable branches.
            const bool across = (box.min.x <= area.max.x) & (area.min.x < box.max.x);
            const bool down = (box.min.y <= area.max.y) & (area.min.y < box.max.y);
            if (across & down) visit(i);
        }
    }

    /// Updates the boxes that may have changed since the last call.
    void follow(const Document& document);

private:
    static constexpr std::uint32_t kNowhere = ~0u;

    void makeAll(const Document& document);
    void update(const Document& document, EntityId entity);
    /// Updates an entity and its descendants, unless this call of `follow` has already done so.
    void updateMoved(const Document& document, EntityId entity);

    std::vector<AABB> boxes_;
    std::vector<EntityId> entities_;      // by index in objects()
    std::vector<std::uint32_t> placeOf_;  // index in objects(), by EntityId::index
    std::vector<std::uint32_t> passOf_;   // `pass_` of the last update of an entity, by index in objects()
    std::uint32_t pass_ = 0;              // number of the present update
    std::vector<EntityId> restless_;      // entities whose boxes change without a component write
    std::uint64_t tree_ = ~0ull;          // Document::treeRevision at the last update
    std::uint64_t members_ = 0;           // changes when an entity gains or loses a component with a box
    std::uint64_t mark_ = 0;              // change mark of the world at the last update
};

}  // namespace plumb::editor
