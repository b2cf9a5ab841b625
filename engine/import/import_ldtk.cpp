#include "import/import_ldtk.hpp"

#include <algorithm>
#include <optional>

#include "core/text.hpp"
#include "import/import_entities.hpp"
#include "import/ldtk_entities.hpp"
#include "import/ldtk_stacks.hpp"
#include "import/ldtk_tilesets.hpp"
#include "import/loaders/ldtk_loader.hpp"
#include "import/tiled_json.hpp"
#include "scene/files/tiles_json.hpp"

namespace plumb {
namespace {

using ldtk::Layer;
using ldtk::Level;

constexpr std::string_view kEnding = ".scene.json";

/// A layer of a level, its definition, and its tiles sorted into stacks.
struct LayerPlan {
    const Layer* layer = nullptr;
    const ldtk::LayerKind* kind = nullptr;
    LdtkStacks stacks;
};

/// Imports one world of a project into a scene.
class WorldImporter {
public:
    WorldImporter(const ldtk::Project& project, const ldtk::World& world, SceneDraft& draft)
        : project_{project}, world_{world}, draft_{draft}, tilesets_{project, draft} {}

    void import() {
        planLayers();
        describe();
        for (std::size_t i = 0; i < world_.levels.size(); ++i) addLevel(world_.levels[i], plans_[i]);
        for (Json& entity : draft_.entities()) {
            if (entity.contains("properties")) linkEntities(entity["properties"], ids_);
        }
        draft_.report.addEditorKeys("LDtk", project_.editorKeys);
        if (bounds_) draft_.addCamera({bounds_->min.x, bounds_->min.y, bounds_->size().x, bounds_->size().y});
    }

private:
    /// Assigns drawing orders, which all levels of a world share: a layer gets one for each tile of its
    /// highest stack in any level, because stacked tiles are imported as separate layers.
    void planLayers() {
        std::vector<std::size_t> depth;
        for (const Level& level : world_.levels) {
            std::vector<LayerPlan>& plan = plans_.emplace_back();
            for (auto layer = level.layers.rbegin(); layer != level.layers.rend(); ++layer) {
                const ldtk::Tileset* tileset = project_.tileset(layer->tileset);
                const int size = tileset == nullptr ? layer->grid : tileset->grid;
                const int count = tileset == nullptr ? 0 : tileset->columns() * tileset->rows();
                plan.push_back({&*layer, project_.layerKind(layer->kind), stackTiles(*layer, size, count)});
                if (depth.size() < plan.size()) depth.resize(plan.size());
                std::size_t& maximum = depth[plan.size() - 1];
                maximum = std::max(maximum, plan.back().stacks.levels.size());
            }
        }
        int order = 0;
        for (const std::size_t levels : depth) {
            firstOrder_.push_back(std::min(order, kHighestLayerOrder));
            order += static_cast<int>(levels) + 1;  // + 1: the values of an IntGrid, drawn below its tiles
        }
        if (order > kHighestLayerOrder) {
            draft_.report.problems.push_back(
                {world_.name,
                 format("the layers and their stacked tiles need {} drawing orders; the maximum is {}", order,
                        kHighestLayerOrder),
                 "reduce the number of layers or stacked tiles; some tiles may be drawn in the wrong order"});
        }
    }

    void describe() {
        Json json = Json::object();
        json["version"] = project_.version;
        json["world"] = world_.name;
        json["layout"] = world_.layout;
        if (!world_.iid.empty()) json["iid"] = world_.iid;
        if (!project_.enums.empty()) json["enums"] = project_.enums;
        if (!project_.contents.empty()) json["contents"] = project_.contents;
        draft_.extra["ldtk"] = std::move(json);
        const bool sameColor =
            std::all_of(world_.levels.begin(), world_.levels.end(),
                        [&](const Level& level) { return level.color == world_.levels.front().color; });
        oneColor_ = sameColor;
        if (sameColor && !world_.levels.empty())
            draft_.extra["background"] = colorJson(world_.levels.front().color);
        int rules = 0;
        for (const ldtk::LayerKind& kind : project_.layers) rules += kind.ruleGroups;
        if (rules > 0) {
            draft_.report.note(
                format("{} auto-layer rule groups were not imported; the tiles they placed were", rules));
        }
    }

    void addLevel(const Level& level, const std::vector<LayerPlan>& plan) {
        ++draft_.report.levels;
        const Rect area{0.0f, 0.0f, static_cast<float>(level.width), static_cast<float>(level.height)};
        ids_[level.iid] = draft_.open(level.iid, level.name, level.position);
        Json& added = draft_.last();
        if (Json properties = ldtkProperties(level.fields, project_, 1); !properties.empty())
            added["properties"] = std::move(properties);
        added["ldtk"]["iid"] = level.iid;
        added["ldtk"]["size"] = Json::array({level.width, level.height});
        if (level.depth != 0) {
            added["ldtk"]["depth"] = level.depth;
            draft_.report.note(format("level {}: its world depth is {}; all depths are imported to one scene",
                                      level.name, level.depth));
        }
        if (!oneColor_) draft_.addBackground(level.iid + "/color", area, level.color);
        if (!level.image.empty()) addPicture(level);
        for (std::size_t i = 0; i < plan.size(); ++i) addLayer(level, plan[i], firstOrder_[i]);
        draft_.close();
        const AABB box{level.position, level.position + Vec2{area.width, area.height}};
        bounds_ = bounds_ ? merged(*bounds_, box) : box;
    }

    void addPicture(const Level& level) {
        const StagedImage& image = draft_.stage.image(project_.folder / level.image, {});
        const Rect crop = level.imageCrop.empty()
                              ? Rect{0.0f, 0.0f, static_cast<float>(std::max(image.width, 1)),
                                     static_cast<float>(std::max(image.height, 1))}
                              : level.imageCrop;
        Json components = Json::object();
        components["Transform"] = transformJson(level.imageTopLeft, 0.0f, level.imageScale);
        Json& sprite = components["Sprite"] = Json::object();
        sprite["texture"] = image.path;
        sprite["width"] = static_cast<int>(crop.width);
        sprite["height"] = static_cast<int>(crop.height);
        sprite["source"] = Json::array({crop.x, crop.y, crop.width, crop.height});
        sprite["layer"] = -1;
        draft_.add(level.iid + "/picture", "background image", std::move(components));
    }

    void addLayer(const Level& level, const LayerPlan& plan, int order) {
        const Layer& layer = *plan.layer;
        ++draft_.report.layers;
        draft_.nameLayer(order, layer.name);
        const std::string key = level.iid + "/" + layer.iid;
        if (layer.type == "IntGrid") addValues(plan, key, order);
        for (std::size_t i = 0; i < plan.stacks.levels.size(); ++i)
            addStack(plan, i, key, std::min(order + 1 + static_cast<int>(i), kHighestLayerOrder));
        if (layer.tiles.empty() && layer.type != "Entities" && layer.type != "IntGrid")
            addEmpty(plan, key, order);
        for (const ldtk::Entity& entity : layer.entities)
            addLdtkEntity(entity, layer, project_, tilesets_, order, draft_, ids_);
        tellParallax(plan);
        if (layer.type == "Entities" && layer.entities.empty())
            draft_.report.note(format("level {}: its layer {} has no entities", level.name, layer.name));
    }

    /// Returns the components that all entities of a layer have: a Transform at the layer's offset.
    Json placed(const LayerPlan& plan) const {
        Json components = Json::object();
        components["Transform"] = transformJson(plan.layer->offset, 0.0f, {1.0f, 1.0f});
        return components;
    }

    void finish(const LayerPlan& plan, Json& components, bool shown) {
        if (!plan.layer->visible || !shown) components["Hidden"] = Json::object();
        const Vec2 parallax = plan.kind == nullptr ? Vec2{} : plan.kind->parallax;
        if (parallax == Vec2{}) return;
        components["ParallaxLayer"] = ldtkParallax(*plan.kind);
    }

    void tellParallax(const LayerPlan& plan) {
        if (plan.kind == nullptr || plan.kind->parallax == Vec2{}) return;
        if (plan.kind->scalesWithParallax) {
            draft_.report.note(
                format("layer {}: LDtk also scales it by its parallax; the imported layer is not scaled",
                       plan.layer->name));
        }
        const auto& entities = plan.layer->entities;
        const bool unseen = std::any_of(entities.begin(), entities.end(),
                                        [](const ldtk::Entity& entity) { return !entity.tile; });
        if (unseen)
            draft_.report.note(
                format("layer {}: it has parallax, but its entities without an image do not move with it",
                       plan.layer->name));
    }

    Json tilesJson(const LayerPlan& plan, std::string tileset, const TileGrid& grid, int order,
                   double opacity) {
        const Layer& layer = *plan.layer;
        Json tiles = Json::object();
        tiles["tileset"] = std::move(tileset);
        tiles["cells"] = tilesToJson(grid);
        tiles["tileSize"] = Json::array({layer.grid, layer.grid});
        tiles["layer"] = order;
        tiles["tint"] = colorJson(withOpacity(Color{}, static_cast<float>(opacity)));
        return tiles;
    }

    /// Adds the values of an IntGrid as colored tiles, drawn below the tiles placed by rules; hidden if LDtk
    /// does not show them.
    void addValues(const LayerPlan& plan, const std::string& key, int order) {
        const Layer& layer = *plan.layer;
        bool solid = false;
        if (plan.kind == nullptr || plan.kind->values.empty()) return;
        const std::string file = tilesets_.valuesFile(layer, *plan.kind, solid);
        TileGrid cells{layer.columns, layer.rows};
        int unknown = 0;
        for (std::size_t i = 0; i < layer.values.size(); ++i) {
            if (layer.values[i] == 0) continue;
            const auto& values = plan.kind->values;
            const auto at = std::find_if(values.begin(), values.end(),
                                         [&](const auto& known) { return known.value == layer.values[i]; });
            if (at != values.end()) {
                const auto index = static_cast<int>(i);
                cells.set(index % layer.columns, index / layer.columns,
                          cellOf(static_cast<int>(at - values.begin())));
                ++draft_.report.tiles;
            } else {
                ++unknown;
            }
        }
        if (unknown > 0) {
            draft_.report.problems.push_back(
                {format("layer {}", layer.name),
                 format("{} cells have values that the layer does not define", unknown),
                 "define these values in LDtk"});
        }
        Json components = placed(plan);
        components["TileLayer"] = tilesJson(plan, file, cells, order, 1.0);
        if (solid) components["TileCollider"] = Json::object();
        finish(plan, components, showsValues(layer));
        draft_.add(key + "/values", format("{} values", layer.name), std::move(components));
    }

    /// True if LDtk shows the values of an IntGrid layer: it has no tileset and is not the source of another
    /// layer's rules. Also true if its tileset's image is missing, since otherwise nothing would be visible.
    bool showsValues(const Layer& layer) {
        const bool drawnByOther =
            std::any_of(project_.layers.begin(), project_.layers.end(),
                        [&layer](const ldtk::LayerKind& kind) { return kind.source == layer.kind; });
        if (layer.opacity == 0.0) return false;
        if (project_.tileset(layer.tileset) == nullptr) return !drawnByOther;
        return !layer.tiles.empty() && tilesets_.picture(layer.tileset).width == 0;
    }

    void addStack(const LayerPlan& plan, std::size_t index, const std::string& key, int order) {
        const Layer& layer = *plan.layer;
        const LdtkStacks::Level& stack = plan.stacks.levels[index];
        const std::string name = index == 0 ? layer.name : format("{} {}", layer.name, index + 1);
        if (stack.count > 0) {
            draft_.report.tiles += stack.count;
            Json components = placed(plan);
            components["TileLayer"] =
                tilesJson(plan, tilesets_.file(layer.tileset, layer.grid), stack.cells, order, layer.opacity);
            finish(plan, components, true);
            draft_.add(format("{}/tiles {}", key, index), name, std::move(components));
        }
        if (stack.loose.empty()) return;
        draft_.open(format("{}/loose {}", key, index), name + ", off the grid", layer.offset);
        for (std::size_t i = 0; i < stack.loose.size(); ++i)
            addLoose(plan, *stack.loose[i], format("{}/loose {}/{}", key, index, i), order);
        draft_.close();
    }

    void addLoose(const LayerPlan& plan, const ldtk::Tile& tile, const std::string& key, int order) {
        ++draft_.report.tiles;
        const Layer& layer = *plan.layer;
        const ldtk::Tileset* tileset = project_.tileset(layer.tileset);
        Json components = Json::object();
        components["Transform"] =
            transformJson({static_cast<float>(tile.x), static_cast<float>(tile.y)}, 0.0f, {1.0f, 1.0f});
        Json& sprite = components["Sprite"] = Json::object();
        const Rect source =
            tileset == nullptr ? Rect{0.0f, 0.0f, 16.0f, 16.0f} : tileset->sourceOf(tile.tile);
        const std::string& picture = tilesets_.picture(layer.tileset).path;
        if (!picture.empty()) sprite["texture"] = picture;
        sprite["width"] = static_cast<int>(source.width);
        sprite["height"] = static_cast<int>(source.height);
        sprite["source"] = Json::array({source.x, source.y, source.width, source.height});
        sprite["layer"] = order;
        sprite["tint"] = colorJson(withOpacity(Color{}, static_cast<float>(layer.opacity) * tile.opacity));
        if ((tile.flips & 1u) != 0) sprite["flipX"] = true;
        if ((tile.flips & 2u) != 0) sprite["flipY"] = true;
        finish(plan, components, true);
        draft_.add(key, format("tile {}", tile.tile), std::move(components));
    }

    /// Adds an empty TileLayer for a layer without tiles, so that it can be painted.
    void addEmpty(const LayerPlan& plan, const std::string& key, int order) {
        const Layer& layer = *plan.layer;
        Json components = placed(plan);
        components["TileLayer"] = tilesJson(plan, tilesets_.file(layer.tileset, layer.grid),
                                            TileGrid{layer.columns, layer.rows}, order, layer.opacity);
        finish(plan, components, true);
        draft_.add(key + "/tiles 0", layer.name, std::move(components));
    }

    const ldtk::Project& project_;
    const ldtk::World& world_;
    SceneDraft& draft_;
    LdtkTilesets tilesets_;
    std::vector<std::vector<LayerPlan>> plans_;  // layers of each level, bottom first
    std::vector<int> firstOrder_;                // lowest drawing order of each layer, bottom first
    LdtkIds ids_;
    std::optional<AABB> bounds_;
    bool oneColor_ = true;
};

/// Adds the report of a further world to the report of the project.
void append(ImportReport& all, ImportReport&& next) {
    all.levels += next.levels;
    all.layers += next.layers;
    all.tiles += next.tiles;
    all.objects += next.objects;
    all.tilesets += next.tilesets;
    all.images += next.images;
    all.files.insert(all.files.begin(), next.files.begin(), next.files.end());
    for (std::string& note : next.notes) all.note(std::move(note));
    all.addEditorKeys(next.editor, next.editorKeys);
    all.problems.insert(all.problems.end(), next.problems.begin(), next.problems.end());
    all.note(format("another world of the project was imported as {}", next.scene));
}

/// Returns the path for the scene of a further world of a project, in the folder of the first scene.
ImportTarget placeOf(const ImportTarget& first, const std::string& world, std::set<std::string>& taken) {
    ImportTarget place = first;
    const std::string name = format("{}-{}", first.name, plainName(world));
    place.name = name;
    for (int number = 2; !taken.insert(place.name).second; ++number)
        place.name = format("{}-{}", name, number);
    const std::string folder = Path{first.path}.parent_path().generic_string();
    place.path = format("{}{}{}{}", folder, folder.empty() ? "" : "/", place.name, kEnding);
    return place;
}

}  // namespace

Result<ImportReport> importLdtk(const Path& file, const Path& scene) {
    const Result<ImportTarget> place = ImportTarget::of(scene, kEnding);
    if (!place) return place.error();
    std::vector<Error> problems;
    const Result<ldtk::Project> project = loadLdtk(file, problems);
    if (!project) return project.error();
    std::optional<ImportReport> all;
    std::vector<ImportedFile> files;
    std::set<std::string> taken{place->name};
    for (const ldtk::World& world : project->worlds) {
        SceneDraft draft{all ? placeOf(*place, world.name, taken) : *place};
        draft.report.from = "LDtk project";
        if (!all) draft.report.problems = problems;
        WorldImporter{*project, world, draft}.import();
        Result<ImportReport> report = draft.finish(files);
        if (!report) return report.error();
        if (all) {
            append(*all, std::move(*report));
        } else {
            all = std::move(*report);
        }
    }
    if (!all) return Error{file.filename().string(), "the project has no world", "add a level in LDtk"};
    // All files are written only now, so that a world that fails leaves no files of the other worlds.
    if (const Result<Done> done = commitImport(place->root, files); !done) return done.error();
    return std::move(*all);
}

}  // namespace plumb
