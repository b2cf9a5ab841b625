#pragma once

#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"

namespace plumb::editor {

/// Sets one field of one component type on several entities. Works for every component type, through
/// reflection.
class SetField final : public Command {
public:
    struct Change {
        ObjectId object;
        FieldValue value;
    };

    SetField(const TypeInfo& type, const FieldInfo& field, std::vector<Change> changes)
        : type_{type}, field_{field}, changes_{std::move(changes)} {}

    [[nodiscard]] std::string label() const override;
    [[nodiscard]] Subject subject() const override {
        return changes_.empty() ? Subject{} : Subject{changes_.front().object, changes_.size()};
    }
    void apply(Document& document) override { swapValues(document); }
    void revert(Document& document) override { swapValues(document); }
    bool absorb(const Command& next) override;
    [[nodiscard]] bool changesNothing(const Document& document) const override;

private:
    void swapValues(Document& document);

    const TypeInfo& type_;
    const FieldInfo& field_;
    std::vector<Change> changes_;  // values to swap in: the new ones, after `apply` the old ones
};

}  // namespace plumb::editor
