#pragma once

#include <vector>

#include "core/text_store.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

class AssetStore;
class TypeRegistry;
class World;

/// An asset by what it is and where it lies.
struct AssetName {
    AssetKind kind = AssetKind::None;
    TextId path;

    friend bool operator==(const AssetName&, const AssetName&) = default;
    friend bool operator<(const AssetName& a, const AssetName& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.path.value < b.path.value;
    }
};

/// The assets that the components of a world name: sorted, each once.
std::vector<AssetName> namedAssets(const World& world, const TypeRegistry& types);

/// Keeps the assets that a world names, and the files of its scenes, in the store, and those only: what two
/// scenes share stays loaded when one follows the other, what is named no more may be unloaded.
class SceneAssets {
public:
    explicit SceneAssets(AssetStore& assets) : assets_{assets} {}
    ~SceneAssets();
    SceneAssets(const SceneAssets&) = delete;
    SceneAssets& operator=(const SceneAssets&) = delete;

    /// Loads and acquires what the world names and did not before, and releases what it names no more. Call
    /// it after scenes came or went.
    void follow(const World& world, const TypeRegistry& types);

    [[nodiscard]] const std::vector<AssetName>& held() const { return held_; }

private:
    AssetStore& assets_;
    std::vector<AssetName> held_;  // sorted
};

}  // namespace plumb
