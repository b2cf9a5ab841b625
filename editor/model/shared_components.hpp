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
/// @param types  the document's, which outlive a game's
std::vector<ComponentHolders> componentHolders(const TypeRegistry& types, const World& world,
                                               std::span<const EntityId> entities);

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

/// Which bytes of the value are not the same in all of them: none is zero where they differ. Numbers that are
/// equal count as the same.
class MixedBytes {
public:
    MixedBytes() = default;
    explicit MixedBytes(const FieldInfo& field) : bytes_(field.size) {}

    /// Marks where two values at addresses differ.
    void compare(const FieldInfo& field, const void* a, const void* b);
    [[nodiscard]] bool any() const { return any_; }
    /// Whether further values can change nothing any more.
    [[nodiscard]] bool all() const;
    [[nodiscard]] bool any(std::size_t at, std::size_t size) const;
    [[nodiscard]] bool bit(unsigned bit) const;
    /// Whether they are lists that are not all as long.
    [[nodiscard]] bool lengths() const { return lengths_; }

private:
    std::vector<std::byte> bytes_;
    bool any_ = false;
    bool lengths_ = false;
};

/// One field of what is selected, as the inspector shows it.
struct SharedField {
    FieldValue value;       ///< of the one selected last
    MixedBytes mixed;       ///< against the others
    bool isDefault = true;  ///< of all of them
};

/// The components of one type that several entities have. Valid until one of them comes, goes or is changed.
struct HeldComponents {
    const TypeInfo* type = nullptr;
    const void* inHand = nullptr;        ///< of the last of the entities; null: none of them has one
    std::vector<const void*> different;  ///< those of which not every byte is as in that one
};
HeldComponents heldComponents(const World& world, const TypeInfo& type, std::span<const EntityId> entities);

/// @param fresh  a default component of the type
/// @pre   there is one in hand
SharedField sharedField(const ObjectNames& names, const FieldInfo& field, const HeldComponents& held,
                        const ComponentState& fresh);

/// Whether a field does something in one of them: another field may switch it off.
bool isShown(const FieldInfo& field, const HeldComponents& held);

}  // namespace plumb::editor
