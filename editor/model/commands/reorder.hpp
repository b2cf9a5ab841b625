#pragma once

#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

/// Returns the entities in file order, without parts of prefab instances, which have no position of their
/// own.
std::vector<ObjectId> fileOrder(const Document& document);

/// Sorts the entities of `line` into its order, by redistributing their order numbers among them.
void placeInOrder(Document& document, const std::vector<ObjectId>& line);

/// Moves entities within the file order, which is also the order of siblings in the tree. Only entities whose
/// position changes get a new order number.
class Reorder final : public Command {
public:
    /// @param beside  the entities go before or (`behind`) after this entity, in their order in `objects`
    Reorder(std::vector<ObjectId> objects, ObjectId beside, bool behind)
        : objects_{std::move(objects)}, beside_{beside}, behind_{behind} {}

    [[nodiscard]] std::string label() const override { return "change order"; }
    void apply(Document& document) override;
    void revert(Document& document) override;
    [[nodiscard]] bool changesNothing(const Document&) const override { return after_.empty(); }

private:
    void keepMovedRange();

    std::vector<ObjectId> objects_;
    ObjectId beside_;
    bool behind_;
    // The affected range of entities in the old and new order. Ids, not order numbers, because reloading the
    // scene assigns new numbers.
    std::vector<ObjectId> before_;
    std::vector<ObjectId> after_;
};

}  // namespace plumb::editor
