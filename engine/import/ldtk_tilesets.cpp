#include "import/ldtk_tilesets.hpp"

#include <algorithm>
#include <array>

#include "assets/tileset.hpp"
#include "core/text.hpp"
#include "import/tiled_json.hpp"
#include "platform/image_file.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

constexpr int kMaxValueSide = 64;  // px: maximum side of a tile made for an IntGrid value
constexpr std::array<std::string_view, 9> kSolidWords{"wall",  "solid", "ground", "dirt",     "stone",
                                                      "block", "rock",  "brick",  "collision"};
constexpr std::array<std::string_view, 4> kOneWayWords{"one_way", "oneway", "platform", "semisolid"};

std::string lowerCase(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

template <class Words>
bool hasAny(const std::string& name, const Words& words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// Returns the collision of an IntGrid value, guessed from its name, because LDtk has no field for it.
std::string collisionByName(const std::string& name) {
    const std::string lower = lowerCase(name);
    if (hasAny(lower, kOneWayWords)) return "oneWay";
    return hasAny(lower, kSolidWords) ? "full" : "";
}

/// Draws a row of squares, one per value, with darker edges that make cells distinguishable.
Image valuesPicture(const std::vector<ldtk::IntGridValue>& values, int side) {
    Image image;
    image.width = side * static_cast<int>(values.size());
    image.height = side;
    image.rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(side) * 4);
    std::size_t at = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Color color = values[static_cast<std::size_t>(x / side)].color;
            const bool edge = y == 0 || y == side - 1 || x % side == 0 || x % side == side - 1;
            const int part = edge ? 6 : 8;
            for (const std::uint8_t channel : {color.r, color.g, color.b})
                image.rgba[at++] = static_cast<std::uint8_t>(channel * part / 8);
            image.rgba[at++] = 200;
        }
    }
    return image;
}

const Json& listIn(const Json& json, std::string_view key) {
    static const Json kNone = Json::array();
    const Json* list = findArray(json, key);
    return list == nullptr ? kNone : *list;
}

/// Converts LDtk's enum tags and custom data of tiles to properties of each tile.
Json tilesJson(const ldtk::Tileset& tileset, std::vector<Error>& problems) {
    std::map<int, Json> byTile;
    const auto tell = [&](std::string_view list, const Json& found, std::string_view form) {
        problems.push_back({format("tileset {}: {}", tileset.name, list),
                            format("expected {}, found {}", form, briefText(found)),
                            "save the project again in LDtk; this entry was ignored"});
    };
    for (const Json& item : listIn(tileset.notes, "customData")) {
        const Json* id = findMember(item, "tileId");
        const std::optional<int> tile = id == nullptr ? std::nullopt : intOf(*id);
        const std::string* data = findText(item, "data");
        if (tile && data != nullptr) {
            byTile[*tile]["data"] = *data;
        } else {
            tell("customData", item, "a tile id and a string");
        }
    }
    for (const Json& tag : listIn(tileset.notes, "enumTags")) {
        const std::string* value = findText(tag, "enumValueId");
        if (value == nullptr || findArray(tag, "tileIds") == nullptr) {
            tell("enumTags", tag, "the name of a value and an array of tile ids");
            continue;
        }
        for (const Json& id : listIn(tag, "tileIds")) {
            if (const std::optional<int> tile = intOf(id)) {
                byTile[*tile]["tags"].push_back(*value);
            } else {
                tell("enumTags.tileIds", id, "a tile id");
            }
        }
    }
    Json tiles = Json::array();
    for (auto& [id, properties] : byTile) {
        Json tile = Json::object();
        tile["id"] = id;
        tile["properties"] = std::move(properties);
        tiles.push_back(std::move(tile));
    }
    return tiles;
}

Json looseJson(int tile, const std::string& image, const Rect& area) {
    Json json = Json::object();
    json["tile"] = tile;
    json["image"] = image;
    json["source"] = Json::array({area.x, area.y, area.width, area.height});
    return json;
}

}  // namespace

const StagedImage& LdtkTilesets::picture(int uid) {
    const auto [at, isNew] = pictures_.try_emplace(uid);
    StagedImage& staged = at->second;
    const ldtk::Tileset* tileset = project_.tileset(uid);
    if (!isNew || tileset == nullptr) return staged;
    if (tileset->image.empty()) {
        draft_.report.problems.push_back({format("tileset {}", tileset->name),
                                          "the tileset uses LDtk's built-in icons, which are not in a file",
                                          "colored boxes are shown instead; use an image file in LDtk"});
        return staged;
    }
    const std::string lower = lowerCase(tileset->image);
    if (endsWith(lower, ".aseprite") || endsWith(lower, ".ase")) {
        const Path png = (project_.folder / tileset->image).replace_extension(".png");
        std::error_code ignored;
        if (std::filesystem::exists(png, ignored)) {
            draft_.report.note(format("tileset {}: {} was used instead of the .aseprite file", tileset->name,
                                      png.filename().string()));
            return staged = draft_.stage.image(png, {});
        }
        draft_.report.problems.push_back(
            {format("tileset {}", tileset->name),
             format("{} is an Aseprite file, which the engine cannot read", tileset->image),
             "export it as a .png of the same name to the same folder and import again"});
        staged.path = format("assets/{}/{}.png", draft_.place.name, tileset->name);
        return staged;
    }
    return staged = draft_.stage.image(project_.folder / tileset->image, {});
}

std::string LdtkTilesets::file(int uid, int grid) {
    const auto [at, isNew] = files_.try_emplace({uid, grid});
    const ldtk::Tileset* tileset = project_.tileset(uid);
    if (!isNew || tileset == nullptr) return at->second;
    const std::string image = picture(uid).path;
    const bool loose = tileset->grid != grid;
    const int all = tileset->columns() * tileset->rows();
    const int count = std::min(all, loose ? kMaxLooseTiles : Tileset::kMaxTiles);
    if (count < all) {
        draft_.report.problems.push_back(
            {format("tileset {}", tileset->name),
             format("only the first {} of the tileset's {} tiles were imported", count, all),
             "split the tileset, or make its tiles as large as the layer's cells"});
    }
    Json json = Json::object();
    json["format"] = Tileset::kFormat;
    json["tileSize"] = Json::array({grid, grid});
    if (!loose) {
        if (!image.empty()) json["image"] = image;
        if (tileset->padding > 0) json["margin"] = tileset->padding;
        if (tileset->spacing > 0) json["spacing"] = tileset->spacing;
    } else {
        for (int tile = 0; tile < count; ++tile)
            json["images"].push_back(looseJson(tile, image, tileset->sourceOf(tile)));
        json["offset"] = Json::array({0, tileset->grid - grid});
    }
    json["columns"] = tileset->columns();
    json["count"] = count;
    if (Json tiles = tilesJson(*tileset, draft_.report.problems); !tiles.empty())
        json["tiles"] = std::move(tiles);
    Json notes = Json::object();
    notes["name"] = tileset->name;
    for (const auto& [key, value] : tileset->notes.items()) notes[key] = value;
    json["ldtk"] = std::move(notes);
    const std::string name = tileset->grid == grid ? tileset->name : format("{}-{}", tileset->name, grid);
    ++draft_.report.tilesets;
    return at->second = draft_.stage.add(name, ".tileset.json", writeJson(json));
}

std::string LdtkTilesets::valuesFile(const ldtk::Layer& layer, const ldtk::LayerKind& kind, bool& solid) {
    const auto [at, isNew] = values_.try_emplace(layer.kind);
    solid = at->second.second;
    if (!isNew || kind.values.empty()) return at->second.first;
    const int side = std::min(layer.grid, kMaxValueSide);
    const Result<std::string> png = encodePng(valuesPicture(kind.values, side));
    if (!png) return {};
    Json json = Json::object();
    json["format"] = Tileset::kFormat;
    json["tileSize"] = Json::array({side, side});
    json["image"] = draft_.stage.add(layer.name + "-values", ".png", *png);
    json["columns"] = kind.values.size();
    json["count"] = kind.values.size();
    std::string solids;
    for (std::size_t i = 0; i < kind.values.size(); ++i) {
        const ldtk::IntGridValue& value = kind.values[i];
        Json tile = Json::object();
        tile["id"] = i;
        if (const std::string collision = collisionByName(value.name); !collision.empty()) {
            tile["collision"] = collision;
            solids += format("{}\"{}\"", solids.empty() ? "" : ", ", value.name);
        }
        tile["properties"]["value"] = value.value;
        if (!value.name.empty()) tile["properties"]["name"] = value.name;
        json["tiles"].push_back(std::move(tile));
    }
    solid = !solids.empty();
    const std::string file = draft_.stage.add(layer.name + "-values", ".tileset.json", writeJson(json));
    draft_.report.note(
        solid ? format("layer {}: its values {} were made solid because of their names; change that in {}",
                       layer.name, solids, file)
              : format("layer {}: no value's name suggests a solid tile; set the collision in {}", layer.name,
                       file));
    ++draft_.report.tilesets;
    at->second = {file, solid};
    return file;
}

}  // namespace plumb
