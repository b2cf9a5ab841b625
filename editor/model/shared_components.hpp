#pragma once

#include <span>
#include <vector>

#include "editor/model/edit_fields.hpp"

namespace plumb::editor {

/// True for component types that no component list shows: name, parent, children, and the links to scene and
/// prefab, which the scene tree and the inspector's header show.
bool isHiddenInComponentLists(const TypeInfo& type);

/// A component type and the number of entities that have it.
struct ComponentHolders {
    const TypeInfo* type = nullptr;
    std::size_t count = 0;
};

/// Returns each component type that at least one of the entities has, in registry order.
/// @param types  the document's, which outlive those of a running game
std::vector<ComponentHolders> componentHolders(const TypeRegistry& types, const World& world,
                                               std::span<const EntityId> entities);

/// Key for values cached from the selected entities: the cache is valid while selectedState() returns the
/// same value.
struct SelectedState {
    std::uint64_t scene = static_cast<std::uint64_t>(-1);  ///< Document::sceneRevision
    std::uint64_t selection = 0;                           ///< Selection::revision()
    std::int64_t tick = -1;                                ///< tick of the running game; -1: none runs
    friend bool operator==(const SelectedState&, const SelectedState&) = default;
};
SelectedState selectedState(const Workspace& workspace);

/// Returns the ids of the entities that have the component.
std::vector<ObjectId> holdersOf(const Workspace& workspace, std::span<const ObjectId> ids,
                                const TypeInfo& type);

/// Mask of the bytes in which a field's values differ between entities: nonzero where they differ. Numbers
/// are compared by value, so 0 and -0 are equal.
class MixedBytes {
public:
    MixedBytes() = default;
    explicit MixedBytes(const FieldInfo& field) : bytes_(field.size) {}

    /// Marks the bytes in which the field's values at `a` and `b` differ.
    void compare(const FieldInfo& field, const void* a, const void* b);
    [[nodiscard]] bool any() const { return any_; }  ///< true if any byte is marked
    /// True if all bytes are marked, so further comparisons can be skipped.
    [[nodiscard]] bool all() const;
    [[nodiscard]] bool any(std::size_t at, std::size_t size) const;  ///< the same, for `size` bytes
    [[nodiscard]] bool bit(unsigned bit) const;  ///< true if the bit with this index is marked
    /// True if the values are lists of different lengths.
    [[nodiscard]] bool lengths() const { return lengths_; }

private:
    std::vector<std::byte> bytes_;
    bool any_ = false;
    bool lengths_ = false;
};

/// One field of the selected entities, as the inspector shows it.
struct SharedField {
    FieldValue value;       ///< value of the entity selected last
    MixedBytes mixed;       ///< bytes in which other entities differ from `value`
    bool isDefault = true;  ///< all the values are the default
};

/// The components of one type on several entities. Valid until one of them is added, removed or changed.
struct HeldComponents {
    const TypeInfo* type = nullptr;
    const void* inHand = nullptr;        ///< component of the last entity that has one; null: none has
    std::vector<const void*> different;  ///< components that are not bytewise equal to `inHand`
};
HeldComponents heldComponents(const World& world, const TypeInfo& type, std::span<const EntityId> entities);

/// @param fresh  a component of the type with default values
/// @pre   held.inHand is not null
SharedField sharedField(const ObjectNames& names, const FieldInfo& field, const HeldComponents& held,
                        const ComponentState& fresh);

/// True if the inspector shows the field: its condition on another field (shownIf) holds in one of the
/// components, and it does not store another field's value of the last tick, like previousPosition.
bool isShown(const FieldInfo& field, const HeldComponents& held);

}  // namespace plumb::editor
