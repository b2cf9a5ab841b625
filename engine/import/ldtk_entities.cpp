#include "import/ldtk_entities.hpp"

#include <algorithm>
#include <optional>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "import/tiled_json.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

using ldtk::Fill;

/// Returns the element type of "Array<…>", or the type itself if it is not an array.
std::string_view itemType(std::string_view type) {
    if (!startsWith(type, "Array<")) return type;
    type.remove_prefix(6);
    if (endsWith(type, ">")) type.remove_suffix(1);
    return type;
}

Json pointJson(const Json& value, int grid) {
    Json json = value;
    const auto cell = [&](const char* key) {
        const Json* found = findMember(value, key);
        return found == nullptr ? 0.0 : double{floatOf(*found).value_or(0.0f)};
    };
    json["position"] = Json::array({(cell("cx") + 0.5) * grid, (cell("cy") + 0.5) * grid});
    return json;
}

Json valueJson(const Json& value, std::string_view type, const ldtk::Project& project, int grid) {
    if (value.is_array()) {
        Json list = Json::array();
        for (const Json& item : value) list.push_back(valueJson(item, type, project, grid));
        return list;
    }
    if (!value.is_object()) return value;
    if (type == "Point") return pointJson(value, grid);
    if (type == "Tile") {
        Json json = value;
        const Json* member = findMember(value, "tilesetUid");
        const std::optional<int> uid = member == nullptr ? std::nullopt : intOf(*member);
        const ldtk::Tileset* tileset = uid ? project.tileset(*uid) : nullptr;
        if (tileset != nullptr) json["tileset"] = tileset->name;
        return json;
    }
    return value;
}

/// Returns the size at which an image is drawn in its entity's box, px.
Vec2 pictureSize(Fill fill, Vec2 box, Vec2 picture) {
    const Vec2 ratio{box.x / std::max(picture.x, 1.0f), box.y / std::max(picture.y, 1.0f)};
    switch (fill) {
        case Fill::FitInside: return picture * std::min(ratio.x, ratio.y);
        case Fill::Cover: return picture * std::max(ratio.x, ratio.y);
        case Fill::Plain: return picture;
        case Fill::Stretch:
        case Fill::Repeat:
        case Fill::NineSlice:
        case Fill::None: break;
    }
    return box;
}

/// Reports fill modes that a Sprite does not support: repeated, nine-slice, and clipped to the box.
void tellFill(const ldtk::EntityKind& kind, ImportReport& report) {
    if (kind.fill == Fill::Repeat || kind.fill == Fill::NineSlice) {
        report.note(format("entities {}: their image is stretched; LDtk {} it", kind.name,
                           kind.fill == Fill::Repeat ? "repeats" : "keeps the borders of"));
    }
    if (kind.fill == Fill::Cover)
        report.note(format("entities {}: their image extends beyond their box; LDtk clips it", kind.name));
}

Json spriteJson(const ldtk::Entity& entity, const ldtk::EntityKind* kind, const ldtk::Layer& layer,
                LdtkTilesets& tilesets, int order) {
    const ldtk::TileRect& tile = *entity.tile;
    const StagedImage& picture = tilesets.picture(tile.tileset);
    const Vec2 box{static_cast<float>(entity.width), static_cast<float>(entity.height)};
    const Vec2 wanted =
        pictureSize(kind == nullptr ? Fill::Stretch : kind->fill, box, {tile.area.width, tile.area.height});
    const auto side = static_cast<float>(limits::kImageSide);
    const Vec2 size{std::clamp(wanted.x, 0.0f, side), std::clamp(wanted.y, 0.0f, side)};
    const double opacity = layer.opacity * (kind == nullptr ? 1.0 : kind->opacity);
    Json sprite = Json::object();
    if (!picture.path.empty()) {
        sprite["texture"] = picture.path;
        sprite["source"] = Json::array({tile.area.x, tile.area.y, tile.area.width, tile.area.height});
    }
    sprite["width"] = std::max(static_cast<int>(size.x + 0.5f), 1);
    sprite["height"] = std::max(static_cast<int>(size.y + 0.5f), 1);
    sprite["layer"] = order;
    const Color tint = picture.path.empty() ? entity.color : Color{};
    sprite["tint"] = colorJson(withOpacity(tint, static_cast<float>(opacity)));
    sprite["pivot"] = vec2Json(entity.pivot);
    return sprite;
}

/// Returns a trigger BoxCollider for a resizable entity, because resizable entities usually mark areas.
Json areaJson(const ldtk::Entity& entity) {
    Json box = Json::object();
    box["width"] = entity.width;
    box["height"] = entity.height;
    const Vec2 corner{-entity.pivot.x * static_cast<float>(entity.width),
                      -entity.pivot.y * static_cast<float>(entity.height)};
    if (corner != Vec2{}) box["offset"] = vec2Json(corner);
    box["isTrigger"] = true;
    return box;
}

}  // namespace

Json ldtkParallax(const ldtk::LayerKind& kind) {
    // Factor 0 means fixed to the world in LDtk, fixed to the screen in the engine.
    tiled::Layer moving;
    moving.parallax = Vec2{1.0f, 1.0f} - kind.parallax;
    return parallaxJson(moving);
}

Json ldtkProperties(const std::vector<ldtk::Field>& fields, const ldtk::Project& project, int grid) {
    Json properties = Json::object();
    for (const ldtk::Field& field : fields)
        properties[field.name] = valueJson(field.value, itemType(field.type), project, grid);
    return properties;
}

void addLdtkEntity(const ldtk::Entity& entity, const ldtk::Layer& layer, const ldtk::Project& project,
                   LdtkTilesets& tilesets, int order, SceneDraft& draft, LdtkIds& ids) {
    const ldtk::EntityKind* kind = project.entityKind(entity.kind);
    Json components = Json::object();
    components["Transform"] = transformJson(entity.position + layer.offset, 0.0f, {1.0f, 1.0f});
    if (entity.tile) components["Sprite"] = spriteJson(entity, kind, layer, tilesets, order);
    if (kind != nullptr && kind->resizable) components["BoxCollider"] = areaJson(entity);
    if (!layer.visible) components["Hidden"] = Json::object();
    const ldtk::LayerKind* layerKind = project.layerKind(layer.kind);
    if (entity.tile && layerKind != nullptr && layerKind->parallax != Vec2{})
        components["ParallaxLayer"] = ldtkParallax(*layerKind);
    if (kind != nullptr && entity.tile) tellFill(*kind, draft.report);
    ids[entity.iid] = draft.add(entity.iid, entity.name, std::move(components));
    ++draft.report.objects;
    Json& added = draft.last();
    if (Json properties = ldtkProperties(entity.fields, project, layer.grid); !properties.empty())
        added["properties"] = std::move(properties);
    Json notes = Json::object();
    notes["iid"] = entity.iid;
    notes["layer"] = layer.name;
    notes["size"] = Json::array({entity.width, entity.height});
    for (const std::string& tag : entity.tags) notes["tags"].push_back(tag);
    if (entity.tile) {
        const ldtk::Tileset* tileset = project.tileset(entity.tile->tileset);
        const Rect& area = entity.tile->area;
        notes["tile"]["tileset"] = tileset == nullptr ? "" : tileset->name;
        notes["tile"]["source"] = Json::array({area.x, area.y, area.width, area.height});
    } else if (kind != nullptr) {
        notes["drawnAs"] = kind->drawnAs;
        if (entity.pivot != Vec2{}) notes["pivot"] = vec2Json(entity.pivot);
        notes["color"] = colorJson(kind->color);
    }
    Json types = Json::object();
    for (const ldtk::Field& field : entity.fields) types[field.name] = field.type;
    if (!types.empty()) notes["types"] = std::move(types);
    added["ldtk"] = std::move(notes);
}

void linkEntities(Json& properties, const LdtkIds& ids) {
    if (const std::string* iid = findText(properties, "entityIid")) {
        const auto found = ids.find(*iid);
        if (found != ids.end()) properties["entity"] = found->second;
        return;
    }
    if (!properties.is_structured()) return;
    for (Json& inner : properties) linkEntities(inner, ids);
}

}  // namespace plumb
