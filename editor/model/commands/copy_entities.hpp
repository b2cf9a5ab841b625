#pragma once

#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// Copies entities, with all below them, each right behind what it is a copy of, and selects the copies. What
/// is changed of them in the same gesture belongs to it: a copy that is dragged away is one step.
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
    std::vector<EntityState> copies_;  // made when it is applied first: so that they keep their ids
    std::vector<ObjectId> sources_;    // of each of them
    bool changed_ = false;             // since they were put in: they are read again before they go
};

}  // namespace plumb::editor
