#pragma once

#include <span>
#include <vector>

#include "editor/model/edit_fields.hpp"

namespace plumb::editor {

/// Components that the tree or the scene file shows in another way, so that no list of components has them.
bool hasOwnPlace(const TypeInfo& type);

/// A component type, and how many of some entities have it.
struct ComponentHolders {
    const TypeInfo* type = nullptr;
    std::size_t count = 0;
};

/// Each type that one of them has, in the order of the registry.
std::vector<ComponentHolders> componentHolders(const Workspace& workspace, std::span<const ObjectId> ids);

/// Tells whether what was found out about the selected entities still holds.
struct SelectedState {
    std::uint64_t scene = static_cast<std::uint64_t>(-1);
    std::uint64_t selection = 0;
    std::int64_t tick = -1;  ///< of the game that plays
    friend bool operator==(const SelectedState&, const SelectedState&) = default;
};
SelectedState selectedState(const Workspace& workspace);

/// Those that have the component.
std::vector<ObjectId> holdersOf(const Workspace& workspace, std::span<const ObjectId> ids,
                                const TypeInfo& type);

/// Whether a field does something in one of them: another field may switch it off.
bool isShown(const Workspace& workspace, const FieldTarget& target);

}  // namespace plumb::editor
