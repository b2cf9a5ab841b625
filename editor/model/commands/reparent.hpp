#pragma once

#include <optional>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/object_id.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {

/// What stays the same when an entity gets another parent.
enum class KeepPlace : unsigned char {
    InWorld,   ///< it stays where it is on screen: position, rotation and scale are written anew
    InParent,  ///< its own numbers stay, so it jumps to the same place in the new parent
};

/// Gives entities another parent, or none. What would become its own ancestor stays where it is, and so do
/// the parts of a prefab: the file says only with their prefab where they belong.
class Reparent final : public Command {
public:
    Reparent(std::vector<ObjectId> objects, ObjectId parent, KeepPlace keep = KeepPlace::InWorld);

    [[nodiscard]] std::string label() const override {
        return parent_ ? "change parent" : "take from parent";
    }
    [[nodiscard]] Subject subject() const override {
        return changes_.empty() ? Subject{} : Subject{changes_.front().object, changes_.size()};
    }
    void apply(Document& document) override;
    void revert(Document& document) override;

private:
    struct Change {
        ObjectId object;
        ObjectId parentBefore;
        std::optional<Transform> transformBefore;
    };

    ObjectId parent_;
    KeepPlace keep_;
    std::vector<Change> changes_;
};

}  // namespace plumb::editor
