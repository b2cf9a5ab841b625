#include "editor/model/assets/place_asset.hpp"

#include <algorithm>
#include <cmath>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/document/prefab_root.hpp"
#include "editor/model/tools/tool.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "gameplay/components/music.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/animator.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"

namespace plumb::editor {
namespace {

constexpr int kNewLayerCells = 64;  // minimum width of a new tile layer, cells

std::string nameFrom(std::string_view path) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return std::string{name.substr(0, name.find('.'))};
}

/// Builder of an entity: collects its components, then inserts it into the scene.
class NewEntity {
public:
    NewEntity(Document& document, std::string_view name, Vec2 position) : document_{document} {
        state_.id = document.newId();
        add(SceneEntity{state_.id.value, document.nextOrder(), document.scene});
        add(Name{document.world.texts().add(name)});
        add(Transform{position});
    }
    template <class T>
    void add(const T& component) {
        state_.components.push_back(componentState(document_, document_.types().of<T>(), &component));
    }
    void insert(UndoStack& undo, std::string label) {
        std::vector<EntityState> states{state_};
        belowPrefabRoot(document_, states);
        undo.endGesture();
        undo.push(std::make_unique<InsertEntities>(std::move(label), std::move(states)));
        undo.endGesture();
        document_.selection.set({state_.id});
    }

private:
    Document& document_;
    EntityState state_;
};

TextId textOf(Document& document, std::string_view path) { return document.world.texts().add(path); }

Sprite spriteOf(Workspace& workspace, std::string_view path) {
    const TextureId id = workspace.assets.loadTexture(path);
    static_cast<void>(textOf(workspace.document, path));
    const Texture* texture = workspace.assets.find(id);
    Sprite sprite{id, texture != nullptr && texture->width > 0 ? texture->width : 32,
                  texture != nullptr && texture->height > 0 ? texture->height : 32};
    sprite.pivot = {0.5f, 0.5f};
    return sprite;
}

void placeAnimation(Workspace& workspace, std::string_view path, NewEntity& entity) {
    const AnimationId id = workspace.assets.loadAnimation(path);
    static_cast<void>(textOf(workspace.document, path));
    const AnimationSet& set = workspace.assets.animation(id);
    Sprite sprite = set.image.empty() ? Sprite{} : spriteOf(workspace, set.image);
    if (set.frameWidth > 0) sprite.width = set.frameWidth;
    if (set.frameHeight > 0) sprite.height = set.frameHeight;
    sprite.pivot = {0.5f, 0.5f};
    entity.add(sprite);
    entity.add(Animator{id});
}

void placeTileset(Workspace& workspace, std::string_view path, NewEntity& entity) {
    TileLayer layer;
    layer.tileset = workspace.assets.loadTileset(path);
    static_cast<void>(textOf(workspace.document, path));
    const Tileset& set = workspace.assets.tileset(layer.tileset);
    const Vec2 picture = workspace.project.picture;
    const auto cells = [](float pixels, int tile) {
        return std::max(static_cast<int>(pixels) / std::max(tile, 1), 1);
    };
    const int width = std::max(cells(picture.x, set.tileWidth), kNewLayerCells);
    layer.cells = workspace.document.world.tiles().add(TileGrid{width, cells(picture.y, set.tileHeight)});
    entity.add(layer);
    // A layer of a tileset with solid tiles collides, as users expect.
    const auto isSolid = [](const Tile& tile) { return tile.shape != TileShape::None || tile.oneWay; };
    if (std::any_of(set.tiles.begin(), set.tiles.end(), isSolid)) entity.add(TileCollider{});
}

/// Returns size and pivot of the sprite of a prefab's root.
PlacedPicture prefabPicture(Workspace& workspace, std::string_view path) {
    PrefabLibrary* prefabs = workspace.prefabs().prefabs;
    const Result<const Prefab*> prefab = prefabs != nullptr ? prefabs->find(path) : Error{};
    if (!prefab || (*prefab)->entities.empty()) return {};
    const Json* sprite = findMember((*prefab)->entities.front().components, "Sprite");
    if (sprite == nullptr) return {};
    const Sprite normal;
    const auto number = [&](const char* field, int otherwise) {
        const Json* found = findMember(*sprite, field);
        return static_cast<float>(found != nullptr && found->is_number() ? found->get<int>() : otherwise);
    };
    PlacedPicture picture{{number("width", normal.width), number("height", normal.height)}, normal.pivot};
    const Json* pivot = findMember(*sprite, "pivot");
    if (pivot != nullptr && pivot->is_array() && pivot->size() == 2 && (*pivot)[0].is_number() &&
        (*pivot)[1].is_number())
        picture.pivot = {(*pivot)[0].get<float>(), (*pivot)[1].get<float>()};
    return picture;
}

}  // namespace

bool canBePlaced(AssetKind kind) {
    return kind == AssetKind::Texture || kind == AssetKind::Tileset || kind == AssetKind::Animation ||
           kind == AssetKind::Sound || kind == AssetKind::Prefab;
}

Result<Done> placeAsset(Workspace& workspace, std::string_view path, Vec2 at) {
    const AssetKind kind = assetKindOf(path);
    if (!workspace.canEdit()) return Error{std::string{path}, "the game is running", "stop it first"};
    if (workspace.document.scenePath.empty())
        return Error{std::string{path}, "no scene is open", "open a scene first"};
    if (kind == AssetKind::Prefab) return addInstance(workspace.prefabs(), path, at);
    if (!canBePlaced(kind)) {
        return Error{std::string{path}, format("a {} cannot be placed in a scene", nameOfKind(kind)),
                     "drop a picture, a prefab, a tileset, an animation or a sound"};
    }
    const std::string name = nameFrom(path);
    // Tile layers are placed on whole pixels; between them, tiles would be blurred or show seams.
    if (kind == AssetKind::Tileset) at = {std::round(at.x) + 0.0f, std::round(at.y) + 0.0f};
    NewEntity entity{workspace.document, name, at};
    if (kind == AssetKind::Texture) entity.add(spriteOf(workspace, path));
    if (kind == AssetKind::Animation) placeAnimation(workspace, path, entity);
    if (kind == AssetKind::Tileset) placeTileset(workspace, path, entity);
    if (kind == AssetKind::Sound) {
        static_cast<void>(textOf(workspace.document, path));
        entity.add(Music{workspace.assets.loadSound(path)});
    }
    entity.insert(workspace.undo, format("add {}", name));
    return Done{};
}

PlacedPicture placedPicture(Workspace& workspace, std::string_view path) {
    const AssetKind kind = assetKindOf(path);
    if (kind == AssetKind::Prefab) return prefabPicture(workspace, path);
    if (kind == AssetKind::Texture) {
        const Texture* texture = workspace.assets.find(workspace.assets.loadTexture(path));
        if (texture != nullptr)
            return {{static_cast<float>(texture->width), static_cast<float>(texture->height)}};
    }
    if (kind == AssetKind::Animation) {
        const AnimationSet& set = workspace.assets.animation(workspace.assets.loadAnimation(path));
        return {{static_cast<float>(set.frameWidth), static_cast<float>(set.frameHeight)}};
    }
    return {};
}

Vec2 placedOnGrid(Vec2 at, const PlacedPicture& picture, Vec2 step) {
    // Makes the offset slightly less than half a cell, so that a point exactly on a grid corner stays there.
    constexpr float kJustBefore = 0.001f;
    const Vec2 offset = snapOffset(picture.size, picture.pivot, step);
    const auto along = [](float place, float part, float toOrigin, float cell) {
        const float corner = place - toOrigin + (part - 0.5f) * cell * (1.0f - kJustBefore);
        return std::round(corner / cell) * cell + toOrigin;
    };
    return {along(at.x, picture.pivot.x, offset.x, step.x), along(at.y, picture.pivot.y, offset.y, step.y)};
}

}  // namespace plumb::editor
