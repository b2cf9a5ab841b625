#pragma once

#include <cstdint>

#include "core/text_store.hpp"
#include "reflect/type_info.hpp"

namespace plumb {

/// Refers to a file of the project by the hash of its path. The stores map it to the path.
template <AssetKind Kind>
struct AssetRef {
    TextId path;

    [[nodiscard]] bool empty() const { return path.empty(); }
    friend bool operator==(AssetRef, AssetRef) = default;
};

using TextureId = AssetRef<AssetKind::Texture>;
using TilesetId = AssetRef<AssetKind::Tileset>;
using AnimationId = AssetRef<AssetKind::Animation>;
using SoundId = AssetRef<AssetKind::Sound>;
using FontId = AssetRef<AssetKind::Font>;
using SceneId = AssetRef<AssetKind::Scene>;
using PrefabId = AssetRef<AssetKind::Prefab>;

/// Refers to a tile grid in the store of its world; 0: none.
struct TilesId {
    std::uint32_t value = 0;

    friend bool operator==(TilesId, TilesId) = default;
};

}  // namespace plumb
