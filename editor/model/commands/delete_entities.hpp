#pragma once

#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/entity_state.hpp"

namespace plumb::editor {

/// Deletes entities and their descendants. References to them become null; undo restores the entities with
/// their ids and positions in the file, and the references.
class DeleteEntities final : public Command {
public:
    explicit DeleteEntities(std::vector<ObjectId> objects) : objects_{std::move(objects)} {}

    [[nodiscard]] std::string label() const override;
    [[nodiscard]] Subject subject() const override {
        return objects_.empty() ? Subject{} : Subject{objects_.front(), objects_.size()};
    }
    void apply(Document& document) override;
    void revert(Document& document) override;

private:
    struct Reference {
        ObjectId owner;
        const TypeInfo* type = nullptr;
        const FieldInfo* field = nullptr;
        FieldValue value;
    };

    void cutReferences(Document& document, const std::vector<ObjectId>& deleted);

    std::vector<ObjectId> objects_;
    std::vector<EntityState> states_;
    std::vector<Reference> references_;
    std::vector<ObjectId> selected_;
};

}  // namespace plumb::editor
