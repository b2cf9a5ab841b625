#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// Adds, removes or overwrites whole components of one type.
class ChangeComponents final : public Command {
public:
    struct Change {
        ObjectId object;
        std::optional<ComponentState> state;  ///< nullopt: the component is removed
    };

    ChangeComponents(std::string label, const TypeInfo& type, std::vector<Change> changes)
        : label_{std::move(label)}, type_{type}, changes_{std::move(changes)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    [[nodiscard]] Subject subject() const override {
        return changes_.empty() ? Subject{} : Subject{changes_.front().object, changes_.size()};
    }
    void apply(Document& document) override { swapComponents(document); }
    void revert(Document& document) override { swapComponents(document); }
    bool absorb(const Command& next) override;
    [[nodiscard]] bool changesNothing(const Document& document) const override;
    [[nodiscard]] const std::vector<Change>& changes() const { return changes_; }

private:
    void swapComponents(Document& document);

    std::string label_;
    const TypeInfo& type_;
    std::vector<Change> changes_;  // states to swap in: the new ones, after `apply` the old ones
};

/// Adds a default component to the entities that lack it.
std::unique_ptr<Command> addComponent(const Document& document, const std::vector<ObjectId>& objects,
                                      const TypeInfo& type);
std::unique_ptr<Command> removeComponent(const Document& document, const std::vector<ObjectId>& objects,
                                         const TypeInfo& type);
/// Renames an entity. An empty name removes the Name component.
std::unique_ptr<Command> renameEntity(Document& document, ObjectId object, std::string_view name);

}  // namespace plumb::editor
