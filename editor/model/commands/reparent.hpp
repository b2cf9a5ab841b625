#pragma once

#include <optional>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/object_id.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {

/// The transform that is kept when an entity gets another parent.
enum class KeepPlace : unsigned char {
    InWorld,   ///< world pose: position, rotation and scale are recomputed for the new parent
    InParent,  ///< local transform: the entity moves to the same pose relative to the new parent
};

/// Gives entities another parent, or none. Skips entities that would become their own ancestor, and parts of
/// prefab instances, whose parent is defined by the prefab.
class Reparent final : public Command {
public:
    Reparent(std::vector<ObjectId> objects, ObjectId parent, KeepPlace keep = KeepPlace::InWorld);

    [[nodiscard]] std::string label() const override {
        return parent_ ? "change parent" : "remove from parent";
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
