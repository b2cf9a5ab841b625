#include "editor/model/tiles/tile_layer_edit.hpp"

#include <algorithm>
#include <utility>

#include "assets/autotile.hpp"
#include "core/text.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/commands/change_components.hpp"
#include "editor/model/commands/insert_entities.hpp"
#include "editor/model/commands/set_field.hpp"
#include "editor/model/document/entity_state.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/terrain_paint.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/parallax_layer.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor {
namespace {

constexpr Vec2 kNewLayer{64.0f, 32.0f};  // size of the first layer in cells

template <class Component, class T>
void setField(Workspace& workspace, ObjectId object, std::string_view field, const T& value) {
    if (!workspace.canEdit()) return;
    const TypeInfo& type = workspace.document.types().of<Component>();
    workspace.undo.push(std::make_unique<SetField>(
        type, *type.find(field), std::vector<SetField::Change>{{object, FieldValue::of(value)}}));
}

const TileLayer* layerOf(const Workspace& workspace, ObjectId layer) {
    return workspace.document.world.find<TileLayer>(workspace.document.find(layer));
}

/// Returns the layer `step` positions in front of the active one; null at the end of the list.
ObjectId neighbour(const Workspace& workspace, int step) {
    const std::vector<ObjectId> layers = tileLayers(workspace.document);
    const ObjectId active = activeTileLayer(workspace.document, workspace.tiles);
    const auto at = std::find(layers.begin(), layers.end(), active) - layers.begin() - step;
    return at < 0 || at >= static_cast<std::ptrdiff_t>(layers.size()) ? ObjectId{}
                                                                      : layers[static_cast<std::size_t>(at)];
}

template <class T>
void setIn(ComponentState& state, const TypeInfo& type, std::string_view field, const T& value) {
    std::memcpy(type.find(field)->in(static_cast<void*>(state.bytes.data())), &value, sizeof value);
}

}  // namespace

void selectNextTileLayer(Workspace& workspace, int step) {
    const ObjectId next = neighbour(workspace, step);
    if (!next) return;
    workspace.tiles.layer = next;
    workspace.tiles.selected.clear();
    workspace.document.selection.set({next});
    workspace.notice = format("Layer: {}", workspace.document.nameOf(next));
}

void moveTileLayer(Workspace& workspace, int step) {
    const ObjectId other = neighbour(workspace, step);
    const ObjectId active = activeTileLayer(workspace.document, workspace.tiles);
    if (!other || !active) return;
    const int own = layerOf(workspace, active)->layer;
    const int theirs = layerOf(workspace, other)->layer;
    Transaction change{workspace.undo, step > 0 ? "raise layer" : "lower layer"};
    setField<TileLayer>(workspace, active, "layer", own == theirs ? own + step : theirs);
    if (own != theirs) setField<TileLayer>(workspace, other, "layer", own);
    change.commit();
}

void setLayerOpacity(Workspace& workspace, ObjectId layer, float opacity) {
    Color tint = layerOf(workspace, layer)->tint;
    tint.a = static_cast<std::uint8_t>(std::clamp(opacity, 0.0f, 1.0f) * 255.0f + 0.5f);
    setField<TileLayer>(workspace, layer, "tint", tint);
}

void setLayerTint(Workspace& workspace, ObjectId layer, Color tint) {
    setField<TileLayer>(workspace, layer, "tint", tint);
}

void setLayerOffset(Workspace& workspace, ObjectId layer, Vec2 offset) {
    setField<Transform>(workspace, layer, "position", offset);
}

Vec2 layerParallax(const Workspace& workspace, ObjectId layer) {
    const auto* backdrop = workspace.document.world.find<ParallaxLayer>(workspace.document.find(layer));
    return backdrop == nullptr ? Vec2{1.0f, 1.0f} : backdrop->factor;
}

void setLayerParallax(Workspace& workspace, ObjectId layer, Vec2 factor) {
    const Document& document = workspace.document;
    if (!workspace.canEdit() || layerParallax(workspace, layer) == factor) return;
    // Replaces the whole component, so that a drag that first adds it is one undo step.
    const TypeInfo& type = document.types().of<ParallaxLayer>();
    const EntityId entity = document.find(layer);
    ComponentState state = document.world.has<ParallaxLayer>(entity) ? readComponent(document, type, entity)
                                                                     : defaultComponent(type);
    setIn(state, type, "factor", factor);
    workspace.undo.push(std::make_unique<ChangeComponents>(
        "set parallax", type, std::vector<ChangeComponents::Change>{{layer, std::move(state)}}));
}

bool isSolidLayer(const Workspace& workspace, ObjectId layer) {
    return workspace.document.world.has<TileCollider>(workspace.document.find(layer));
}

void setLayerSolid(Workspace& workspace, ObjectId layer, bool solid) {
    Document& document = workspace.document;
    if (!workspace.canEdit() || isSolidLayer(workspace, layer) == solid) return;
    const TypeInfo& type = document.types().of<TileCollider>();
    workspace.undo.push(solid ? addComponent(document, {layer}, type)
                              : removeComponent(document, {layer}, type));
    workspace.undo.endGesture();
}

void addTileLayer(Workspace& workspace) {
    Document& document = workspace.document;
    const ObjectId active = activeTileLayer(document, workspace.tiles);
    const TileLayer* like = layerOf(workspace, active);
    const TileGrid* grid = gridOf(document, active);
    const std::vector<ObjectId> layers = tileLayers(document);

    TileLayer made;
    if (like != nullptr) made = {like->tileset, {}, {}, like->tileSize, 0, {}};
    if (!layers.empty()) made.layer = layerOf(workspace, layers.front())->layer + 1;
    made.cells = document.world.tiles().add(
        grid != nullptr ? TileGrid{grid->width(), grid->height()}
                        : TileGrid{static_cast<int>(kNewLayer.x), static_cast<int>(kNewLayer.y)});
    const auto* place = document.world.find<Transform>(document.find(active));
    const bool solid = like == nullptr || isSolidLayer(workspace, active);
    Transaction change{workspace.undo, "add tile layer"};
    workspace.undo.push(createEntity(document, "tiles", place == nullptr ? Vec2{} : place->position));
    const ObjectId entity = document.selection.all().back();
    const TypeInfo& type = document.types().of<TileLayer>();
    workspace.undo.push(std::make_unique<ChangeComponents>(
        "add TileLayer", type,
        std::vector<ChangeComponents::Change>{{entity, ComponentState{&type, FieldValue::of(made).bytes}}}));
    if (solid) workspace.undo.push(addComponent(document, {entity}, document.types().of<TileCollider>()));
    change.commit();
    workspace.tiles.layer = entity;
}

void retileLayer(Workspace& workspace) {
    const ObjectId layer = activeTileLayer(workspace.document, workspace.tiles);
    const TileGrid* grid = gridOf(workspace.document, layer);
    const TileGrid* terrain = terrainOf(workspace.document, layer);
    const Tileset* tileset = tilesetOf(workspace.document, layer);
    if (grid == nullptr || terrain == nullptr || tileset == nullptr || !workspace.canEdit()) {
        workspace.notice = "This layer has no terrain; paint some with the Terrain tool first";
        return;
    }
    PaintTiles::Change change = retiled(*grid, *terrain, Autotile{*tileset});
    if (change.empty()) {
        workspace.notice = "All tiles match the terrain already";
        return;
    }
    workspace.undo.push(std::make_unique<PaintTiles>(layer, std::move(change), "retile terrain"));
    workspace.undo.endGesture();
}

}  // namespace plumb::editor
