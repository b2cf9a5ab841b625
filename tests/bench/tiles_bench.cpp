// Editing times of a huge map: with the model alone, and with the mouse
// in complete frames of the window while the journal is written.

#include <cstdio>
#include <filesystem>
#include <string>

#include "app/engine_types.hpp"
#include "core/clock.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "physics/terrain/terrain_outlines.hpp"
#include "platform/image_file.hpp"
#include "scene/components/colliders/tile_collider.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/physics_drawing.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/physics/physics_state.hpp"
#include "tests/bench/open_editor.hpp"

namespace plumb::bench {
namespace {

using editor::CellPlace;

constexpr std::string_view kPath = "scenes/huge.scene.json";
constexpr std::string_view kTileset = "assets/ground.tileset.json";
constexpr float kTile = 16.0f;         // px
constexpr double kFrame = 1.0 / 60.0;  // s
constexpr int kColumns = 8;            // columns of the tileset
constexpr int kTerrainTiles = 47;      // number of masks of a blob terrain
constexpr int kPlainTiles = 17;
constexpr int kFollowed = 20;  // number of edits whose colliders are checked

/// Makes a map whose lower half is ground with round caves, like a real level half empty and half solid.
TileGrid makeMap(int side) {
    TileGrid grid{side, side};
    const auto ground = TileGrid::filled(cellOf(46));
    for (int row = grid.chunkRows() / 2; row < grid.chunkRows(); ++row) {
        for (int column = 0; column < grid.chunkColumns(); ++column) grid.put(column, row, ground);
    }
    Random random = Random::seeded(5);
    const int caves = side * side / 16384;
    for (int cave = 0; cave < caves; ++cave) {
        const int radius = 4 + static_cast<int>(random.below(28));
        const auto middleX = static_cast<int>(random.below(static_cast<std::uint32_t>(side)));
        const int middleY = side / 2 + static_cast<int>(random.below(static_cast<std::uint32_t>(side / 2)));
        for (int y = -radius; y <= radius; ++y) {
            for (int x = -radius; x <= radius; ++x) {
                const int away = x * x + y * y;
                if (away > radius * radius) continue;
                const bool border = away > (radius - 1) * (radius - 1);
                grid.set(middleX + x, middleY + y, border ? cellOf(static_cast<int>(random.below(16))) : 0);
            }
        }
    }
    return grid;
}

/// Makes a tileset of a blob terrain and some tiles without terrain, all of them solid.
Tileset makeTileset() {
    Tileset set;
    set.image = "assets/ground.png";
    set.tileWidth = set.tileHeight = static_cast<int>(kTile);
    set.columns = kColumns;
    set.count = kTerrainTiles + kPlainTiles;
    Terrain terrain;
    terrain.id = 1;
    terrain.name = "ground";
    terrain.mode = TerrainMode::Blob;
    int next = 0;
    for (const std::uint8_t mask : masksOf(terrain.mode)) terrain.tiles.push_back({next++, mask});
    set.terrains.push_back(std::move(terrain));
    for (int id = 0; id < set.count; ++id) {
        Tile& tile = set.tiles.emplace_back();
        tile.id = id;
        tile.shape = TileShape::Full;  // tiles without a shape would have no collider to measure
    }
    return set;
}

Image makePicture() {
    Image image{kColumns * static_cast<int>(kTile),
                (kTerrainTiles + kPlainTiles) / kColumns * static_cast<int>(kTile),
                {}};
    image.rgba.assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4,
                      200);
    return image;
}

std::string sceneOf(int side) {
    const TypeRegistry types = engineTypes();
    World world{types};
    Random random = Random::seeded(1);
    const SceneId scene = addScene(world, kPath);
    const Entity map = world.createEntity();
    map.addComponent<SceneEntity>(SceneEntity{newStableId(random), 0, scene});
    map.addComponent<Transform>();
    map.addComponent<TileCollider>();
    auto& layer = map.addComponent<TileLayer>();
    layer.cells = world.tiles().add(makeMap(side));
    layer.tileset = {world.texts().add(kTileset)};
    layer.tileSize = {kTile, kTile};
    return sceneToJson(world, {types, nullptr}, scene);
}

Vec2 middleOf(int x, int y) {
    return {(static_cast<float>(x) + 0.5f) * kTile, (static_cast<float>(y) + 0.5f) * kTile};
}

/// Drags the current tool from one cell to another, without a window.
void stroke(editor::Workspace& workspace, CellPlace from, CellPlace to) {
    editor::Pointer pointer{.position = middleOf(from.x, from.y)};
    workspace.tool().press(workspace.tools(), pointer);
    pointer.position = middleOf(to.x, to.y);
    workspace.tool().drag(workspace.tools(), pointer);
    workspace.tool().release(workspace.tools(), pointer);
}

/// Returns the number of collider edges of all maps in a world.
std::size_t segmentsOf(World& world) {
    std::size_t count = 0;
    for (const TileTerrain& terrain : world.resource<PhysicsState>().terrains) {
        for (const physics::TerrainOutline& chunk : terrain.outlines->chunks()) count += chunk.size();
    }
    return count;
}

class TilesBench {
public:
    TilesBench(const Path& project, int side, const Options& options)
        : project_{project},
          side_{side},
          box_{options.quick ? 200 : 1000},
          rounds_{options.quick ? 2 : 5},
          frames_{options.quick ? 50 : 200},
          wanted_{options.rest.empty() ? std::string{} : options.rest.front()} {}

    int run(const Options& options) {
        open();
        if (wants("edit") || wants("collider")) changeColliders();
        if (wants("cells")) changeMany();
        if (wants("painting")) paint();
        if (wants("play")) play();
        if (wants("save")) save();
        return options.jsonPath.empty() || writeRows(options.jsonPath, table_.rows()) ? 0 : 1;
    }

private:
    [[nodiscard]] bool wants(std::string_view part) const { return wanted_.empty() || wanted_ == part; }
    [[nodiscard]] editor::Workspace& workspace() { return editor_->workspace(); }

    void open() {
        editor_ = std::make_unique<OpenEditor>(project_, kPath);
        table_.add(
            "open", 1,
            timesOf(rounds_, &wallSeconds, [&](int) { static_cast<void>(workspace().open(kPath).ok()); }),
            1.0);
        editor_->frames(4);
    }

    void changeColliders() {
        World& world = workspace().document.world;
        table_.add("first collider", 1, timesOf(1, &wallSeconds, [&](int) { previewPhysics(world); }), 0.1);
        runAction(workspace(), "tool.brush");
        table_.add("edit one tile and update its collider", 1,
                   timesOf(200, &wallSeconds,
                           [&](int i) {
                               putTile(i, 0);
                               previewPhysics(world);
                           }),
                   1e-3);
        std::size_t before = segmentsOf(world);
        for (int i = 0; i < kFollowed; ++i) {
            putTile(i, 1);
            previewPhysics(world);
            const std::size_t now = segmentsOf(world);
            if (now <= before) std::printf("THE COLLIDER DID NOT CHANGE after edit %d: %zu edges\n", i, now);
            before = now;
        }
        workspace().startPlaying(true);
        if (workspace().play.running()) {
            World& played = workspace().play.world();
            previewPhysics(played);
            std::printf("    edges of colliders: %zu in the scene, %zu in the game\n", before,
                        segmentsOf(played));
            workspace().stopPlaying();
        }
    }
    /// Puts a tile in an empty part of the map, so that it adds collider edges.
    /// @param i    column of the tile
    /// @param row  row of the tile; use a row that is still empty
    void putTile(int i, int row) {
        workspace().tiles.stamp.cells = {cellOf(50)};
        const CellPlace at{side_ / 2 + i * 2, side_ / 4 + row * 2};
        stroke(workspace(), at, at);
    }

    void changeMany() {
        const std::size_t cells = static_cast<std::size_t>(box_) * static_cast<std::size_t>(box_);
        runAction(workspace(), "tool.rectangle");
        table_.add("rectangle of many cells", cells,
                   timesOf(rounds_, &wallSeconds,
                           [&](int i) {
                               workspace().tiles.stamp.cells = {cellOf(50 + i)};
                               stroke(workspace(), {10, 10}, {9 + box_, 9 + box_});
                           }),
                   0.2);
        runAction(workspace(), "tool.fill");
        table_.add("fill of many cells", cells,
                   timesOf(rounds_, &wallSeconds,
                           [&](int i) {
                               workspace().tiles.stamp.cells = {cellOf(57 + i)};
                               stroke(workspace(), {20, 20}, {20, 20});
                           }),
                   0.2);
        table_.add("undo fill", cells, timesOf(1, &wallSeconds, [&](int) { workspace().undo.undo(); }), 0.2);
    }

    /// Measures frames of painting with the mouse in the window: strokes of 50 frames, each in an area that
    /// was not painted yet, so that every stroke changes the map.
    void addPainting(const std::string& name, float zoom) {
        workspace().view.show(middleOf(side_ / 2 + 50 * areas_++, side_ / 2), zoom);
        editor_->frames(3);
        const auto frame = [&](int i) {
            const int part = i % 50;
            if (part == 0) ++strokes_;
            const float line = static_cast<float>(strokes_ % 14) * 17.0f - 119.0f;  // px of the window
            const Vec2 at = editor_->middle() + Vec2{static_cast<float>(part) * 4.0f - 100.0f, line};
            if (part == 1) return editor_->press();
            if (part == 49) return editor_->release();
            editor_->moveTo(at);
        };
        const std::size_t before = workspace().undo.size();
        table_.add(name, 1, pacedTimesOf(3, frames_, frame), kFrame);
        if (workspace().undo.size() == before) std::printf("NOTHING WAS PAINTED\n");
    }

    void paint() {
        const float all = 1280.0f / (static_cast<float>(side_) * kTile);
        for (const char* tool : {"tool.brush", "tool.terrain"}) {
            runAction(workspace(), tool);
            workspace().tiles.stamp.cells = {cellOf(63)};
            const std::string name = tool == std::string_view{"tool.brush"} ? "painting" : "painting terrain";
            addPainting(name, 1.0f);
            addPainting(name + ", zoom 0.25", 0.25f);
            addPainting(name + ", whole map in sight", all);
        }
        runAction(workspace(), "tiles.collision");
        addPainting("painting terrain, its collision shown", 1.0f);
        addPainting("painting terrain, its collision shown, zoom 0.34", 0.34f);
        runAction(workspace(), "tiles.collision");
        runAction(workspace(), "view.physics");
        addPainting("painting terrain, physics shown", 1.0f);
        addPainting("painting terrain, physics shown, zoom 0.25", 0.25f);
        runAction(workspace(), "view.physics");
    }

    void play() {
        table_.add("play to first tick", 1,
                   timesOf(1, &wallSeconds,
                           [&](int) {
                               workspace().startPlaying();
                               editor_->frames(2);
                           }),
                   0.1);
        table_.add("frame of playing", 1, pacedTimesOf(2, frames_, [&](int) { editor_->frame(); }), kFrame);
        workspace().stopPlaying();
        editor_->frame();
    }

    void save() {
        runAction(workspace(), "tool.brush");
        const auto saveOnce = [&](int i) {
            putTile(i, 2);
            static_cast<void>(workspace().save().ok());
        };
        table_.add("save after an edit", 1, timesOf(rounds_, &wallSeconds, saveOnce), 1.0);
        World& world = workspace().document.world;
        table_.add(
            "save after all tiles changed", 1,
            timesOf(1, &wallSeconds,
                    [&](int) {
                        TileGrid grid = makeMap(side_);
                        *world.tiles().edit(
                            world.get<TileLayer>(workspace().document.find(workspace().tiles.layer)).cells) =
                            std::move(grid);
                        const double start = wallSeconds();
                        static_cast<void>(workspace().save().ok());
                        std::printf("    %s s of this for saving\n",
                                    fixedText(wallSeconds() - start, 3).c_str());
                    }),
            0.0);
    }

    Path project_;
    int side_;
    int box_;
    int rounds_;
    int frames_;
    std::string wanted_;
    int areas_ = 0;    // number of areas painted so far
    int strokes_ = 0;  // number of strokes so far
    TimeTable table_{"a huge map"};
    std::unique_ptr<OpenEditor> editor_;
};

}  // namespace

int runTiles(const Options& options) {
    const int side = options.quick ? 1024 : 16384;
    const TemporaryProject project{"tiles_bench"};
    const std::string scene = sceneOf(side);
    project.write(kPath, scene);
    project.write(kTileset, writeTileset(makeTileset()));
    if (const Result<std::string> png = encodePng(makePicture())) project.write("assets/ground.png", *png);
    std::printf("%d x %d tiles, %zu bytes of scene\n", side, side, scene.size());
    return TilesBench{project.root(), side, options}.run(options);
}

}  // namespace plumb::bench
