#pragma once

#include <memory>
#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// Adds new entities to the scene: created, pasted or duplicated ones.
class InsertEntities final : public Command {
public:
    InsertEntities(std::string label, std::vector<EntityState> states)
        : label_{std::move(label)}, states_{std::move(states)} {}

    [[nodiscard]] std::string label() const override { return label_; }
    [[nodiscard]] Subject subject() const override {
        return states_.empty() ? Subject{} : Subject{states_.front().id, states_.size()};
    }
    void apply(Document& document) override;
    void revert(Document& document) override;
    [[nodiscard]] std::vector<ObjectId> ids() const;

private:
    std::string label_;
    std::vector<EntityState> states_;
};

/// Makes a command that creates an entity with a Transform and, if not empty, a name.
std::unique_ptr<InsertEntities> createEntity(Document& document, std::string_view name, Vec2 position,
                                             ObjectId parent = {});
/// Makes a command that inserts copies of entities and all their descendants.
std::unique_ptr<InsertEntities> duplicateEntities(Document& document, const std::vector<ObjectId>& objects);

}  // namespace plumb::editor
