#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/document/command.hpp"
#include "editor/model/document/field_value.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {

/// Makes entities that lie in the scene an instance of a prefab that says the same. They stay the same
/// entities, so references to them stay valid; those below the first one get the ids that parts of a
/// prefab have.
/// @pre  the prefab has each of them as a part
class BecomeInstance final : public Command {
public:
    /// @param parts     all below the root, and which part of the prefab each of them is
    /// @param prefabs   outlives the command
    BecomeInstance(ObjectId root, std::map<ObjectId, std::uint64_t> parts, std::string path,
                   PrefabLibrary& prefabs)
        : root_{root}, parts_{std::move(parts)}, path_{std::move(path)}, prefabs_{prefabs} {}

    [[nodiscard]] std::string label() const override { return "become an instance"; }
    void apply(Document& document) override;
    void revert(Document& document) override;

private:
    /// What an entity was before.
    struct Before {
        ObjectId id;
        ObjectId made;
        std::vector<ComponentState> states;  ///< of the components that tie it to a scene and a prefab
    };

    static void rename(Document& document, ObjectId from, ObjectId to);

    ObjectId root_;
    std::map<ObjectId, std::uint64_t> parts_;
    std::string path_;
    PrefabLibrary& prefabs_;
    std::vector<Before> before_;
    std::vector<ObjectId> line_;  // the order of the file
    std::vector<ObjectId> selected_;
};

}  // namespace plumb::editor
