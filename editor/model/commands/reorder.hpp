#pragma once

#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/object_id.hpp"

namespace plumb::editor {

/// All that have a place of their own in the file, in its order: all but the parts of prefabs.
std::vector<ObjectId> fileOrder(const Document& document);

/// Lets entities stand in this order on the places that they have.
void placeInOrder(Document& document, const std::vector<ObjectId>& line);

/// Moves entities to other places in the file, which is the order of the tree. Only what stands elsewhere
/// afterwards is written, so the file differs in the lines that moved.
class Reorder final : public Command {
public:
    /// @param beside  before or behind this entity they come to stand, in the order in which they are named
    Reorder(std::vector<ObjectId> objects, ObjectId beside, bool behind)
        : objects_{std::move(objects)}, beside_{beside}, behind_{behind} {}

    [[nodiscard]] std::string label() const override { return "change order"; }
    void apply(Document& document) override;
    void revert(Document& document) override;
    [[nodiscard]] bool changesNothing(const Document&) const override { return after_.empty(); }

private:
    void keepWhatMoves();

    std::vector<ObjectId> objects_;
    ObjectId beside_;
    bool behind_;
    // Those that are in the way, in both orders. Not their numbers: reading a scene again gives out new ones.
    std::vector<ObjectId> before_;
    std::vector<ObjectId> after_;
};

}  // namespace plumb::editor
