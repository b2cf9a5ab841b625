#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// Turns a tree of entities into an instance of a prefab with the same content. The entities are kept, so
/// references to them stay valid; the root's descendants get the ids of parts of the instance.
/// @pre  the prefab has a part for each descendant of the root
class BecomeInstance final : public Command {
public:
    /// @param parts     all descendants of the root, each with the id of its part in the prefab
    /// @param prefabs   must outlive the command
    BecomeInstance(ObjectId root, std::map<ObjectId, std::uint64_t> parts, std::string path,
                   PrefabLibrary& prefabs)
        : root_{root}, parts_{std::move(parts)}, path_{std::move(path)}, prefabs_{prefabs} {}

    [[nodiscard]] std::string label() const override { return "become an instance"; }
    void apply(Document& document) override;
    void revert(Document& document) override;

private:
    /// State of an entity before the command.
    struct Before {
        ObjectId id;
        ObjectId made;                       ///< id after the command
        std::vector<ComponentState> states;  ///< its SceneEntity, PrefabInstance and PrefabPart
    };

    static void rename(Document& document, ObjectId from, ObjectId to);

    ObjectId root_;
    std::map<ObjectId, std::uint64_t> parts_;
    std::string path_;  // path of the prefab's file
    PrefabLibrary& prefabs_;
    std::vector<Before> before_;
    std::vector<ObjectId> line_;  // file order before the command
    std::vector<ObjectId> selected_;
};

}  // namespace plumb::editor
