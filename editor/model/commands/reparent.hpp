#pragma once

#include <vector>

#include "editor/model/command.hpp"
#include "editor/model/object_id.hpp"

namespace plumb::editor {

/// Gives entities another parent, or none. What would become its own ancestor stays where it is.
class Reparent final : public Command {
public:
    Reparent(std::vector<ObjectId> objects, ObjectId parent);

    [[nodiscard]] std::string label() const override {
        return parent_ ? "change parent" : "take from parent";
    }
    void apply(Document& document) override { swapParents(document); }
    void revert(Document& document) override { swapParents(document); }

private:
    struct Change {
        ObjectId object;
        ObjectId parent;  // the one that it does not have now
    };

    void swapParents(Document& document);

    ObjectId parent_;
    std::vector<Change> changes_;
};

}  // namespace plumb::editor
