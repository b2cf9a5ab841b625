#pragma once

#include <vector>

#include "core/text_store.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class AssetStore;
class TypeRegistry;
class World;

/// An asset, identified by its kind and path.
struct AssetName {
    AssetKind kind = AssetKind::None;
    TextId path;

    friend bool operator==(const AssetName&, const AssetName&) = default;
    friend bool operator<(const AssetName& a, const AssetName& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.path.value < b.path.value;
    }
};

/// Returns the assets that the components of a world reference: sorted, without duplicates.
/// @param kind  only assets of this kind; None: of all kinds
std::vector<AssetName> namedAssets(const World& world, const TypeRegistry& types,
                                   AssetKind kind = AssetKind::None);

/// Keeps the assets that a world references, and the files of its scenes,
/// acquired in the asset store; with the world's PrefabLibrary also what the prefabs need that components
/// name, so that spawning the first of them loads nothing. Assets that two consecutive scenes share stay
/// loaded; those no longer referenced are released and may be unloaded.
class SceneAssets {
public:
    explicit SceneAssets(AssetStore& assets) : assets_{assets} {}
    ~SceneAssets();
    SceneAssets(const SceneAssets&) = delete;
    SceneAssets& operator=(const SceneAssets&) = delete;

    /// Loads and acquires newly referenced assets and releases those no longer referenced. Call it after
    /// scenes were loaded or unloaded.
    void follow(const World& world, const TypeRegistry& types);

    [[nodiscard]] const std::vector<AssetName>& held() const { return held_; }

private:
    AssetStore& assets_;
    std::vector<AssetName> held_;  // sorted
};

}  // namespace plumb
