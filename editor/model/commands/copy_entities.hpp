#pragma once

#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// Copies entities with their descendants, each copy right after its original, and selects the copies. Merges
/// later changes of the copies in the same gesture, so that dragging a copy is one undo step.
class CopyEntities final : public Command {
public:
    explicit CopyEntities(std::vector<ObjectId> originals) : originals_{std::move(originals)} {}

    [[nodiscard]] std::string label() const override;
    [[nodiscard]] Subject subject() const override {
        return originals_.empty() ? Subject{} : Subject{originals_.front(), originals_.size()};
    }
    void apply(Document& document) override;
    void revert(Document& document) override;
    bool absorb(const Command& next) override;

private:
    [[nodiscard]] std::vector<ObjectId> ids() const;

    std::vector<ObjectId> originals_;
    std::vector<EntityState> copies_;  // made by the first `apply`, so that redo keeps their ids
    std::vector<ObjectId> sources_;    // original of each copy
    bool changed_ = false;             // merged changes: `revert` must read the copies again
};

}  // namespace plumb::editor
