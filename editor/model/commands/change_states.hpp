#pragma once

#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// Overwrites components of several types. Each entity must already have the component to be overwritten.
class ChangeStates final : public Command {
public:
    struct Change {
        ObjectId object;
        ComponentState state;
    };

    ChangeStates(std::string label, std::vector<Change> changes)
        : label_{std::move(label)}, changes_{std::move(changes)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    void apply(Document& document) override { swapStates(document); }
    void revert(Document& document) override { swapStates(document); }
    bool absorb(const Command& next) override;
    [[nodiscard]] bool changesNothing(const Document& document) const override;

private:
    void swapStates(Document& document);

    std::string label_;
    std::vector<Change> changes_;  // states to swap in: the new ones, after `apply` the old ones
};

}  // namespace plumb::editor
