// How long the editor takes for what one does to a huge map. The targets are seconds on the reference
// machine.

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "app/engine_types.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/tile_layers.hpp"
#include "editor/model/tools/tile_tools.hpp"
#include "editor/model/workspace.hpp"
#include "render/recording_device.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/tile_collider.hpp"
#include "scene/components/tile_layer.hpp"
#include "scene/components/transform.hpp"
#include "scene/draw_scene.hpp"
#include "scene/physics_drawing.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {
namespace {

using editor::CellPlace;
using Clock = std::chrono::steady_clock;

constexpr std::string_view kPath = "scenes/huge.scene.json";
constexpr float kTile = 16.0f;  // px
constexpr double kNanoseconds = 1e9;

/// Ground below a wavy line, with caves: what a level of that size would be, half empty and half full.
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

/// A project in a temporary folder with one huge scene.
class HugeScene {
public:
    explicit HugeScene(int side) : root_{makeFolder()}, types_{engineTypes()}, assets_{root_} {
        World world{types_};
        Random random = Random::seeded(1);
        const SceneId scene = addScene(world, kPath);
        const Entity map = world.createEntity();
        map.addComponent<SceneEntity>(SceneEntity{newStableId(random), 0, scene});
        map.addComponent<Transform>();
        map.addComponent<TileCollider>();
        auto& layer = map.addComponent<TileLayer>();
        layer.cells = world.tiles().add(makeMap(side));
        layer.tileSize = {kTile, kTile};
        const std::string text = sceneToJson(world, {types_, nullptr}, scene);
        bytes_ = text.size();
        static_cast<void>(writeFile(root_ / kPath, text).ok());
    }
    ~HugeScene() { std::filesystem::remove_all(root_); }
    HugeScene(const HugeScene&) = delete;
    HugeScene& operator=(const HugeScene&) = delete;

    [[nodiscard]] std::unique_ptr<editor::Workspace> workspace() {
        return std::make_unique<editor::Workspace>(types_, assets_, editor::ProjectFolder{root_});
    }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    AssetStore& assets() { return assets_; }

private:
    static Path makeFolder() {
        Path folder = std::filesystem::temp_directory_path() / "plumb_tiles_bench";
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder / "scenes");
        return folder;
    }
    Path root_;
    TypeRegistry types_;
    AssetStore assets_;
    std::size_t bytes_ = 0;
};

template <class Run>
double secondsOf(Run run) {
    const auto begin = Clock::now();
    run();
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// The smallest and the middle of several runs.
template <class Run>
Row rowOf(std::string name, int rounds, double target, Run run) {
    std::vector<double> seconds;
    for (int i = 0; i < rounds; ++i) seconds.push_back(secondsOf([&] { run(i); }));
    std::sort(seconds.begin(), seconds.end());
    Row row{std::move(name),
            1,
            seconds.front() * kNanoseconds,
            seconds[seconds.size() / 2] * kNanoseconds,
            0.0,
            target * kNanoseconds};
    print(row);
    return row;
}

Vec2 middleOf(int x, int y) {
    return {(static_cast<float>(x) + 0.5f) * kTile, (static_cast<float>(y) + 0.5f) * kTile};
}

void stroke(editor::Workspace& workspace, CellPlace from, CellPlace to) {
    editor::Pointer pointer{.position = middleOf(from.x, from.y)};
    workspace.tool().press(workspace.tools(), pointer);
    pointer.position = middleOf(to.x, to.y);
    workspace.tool().drag(workspace.tools(), pointer);
    workspace.tool().release(workspace.tools(), pointer);
}

/// One frame of painting, without the graphics card: a piece of a stroke, and the picture of what is seen.
void addPainting(editor::Workspace& workspace, AssetStore& assets, int side, std::vector<Row>& rows) {
    Tileset tileset;
    tileset.count = 64;
    tileset.columns = 8;
    workspace.document.world.get<TileLayer>(workspace.document.find(workspace.tiles.layer)).tileset =
        assets.addTileset("made", tileset);
    RecordingDevice device;
    SceneRenderer renderer{device, assets};
    DrawList list;
    for (const float zoom : {1.0f, 0.1f, 1280.0f / (static_cast<float>(side) * kTile)}) {
        SceneView how;
        how.view.size = {1280.0f, 720.0f};
        how.view.zoom = zoom;
        how.view.center = middleOf(side / 2, side / 2);
        const auto frame = [&](int i) {
            const int x = side / 2 - 40 + i % 40 * 2;
            stroke(workspace, {x, side / 2 + i / 40}, {x + 2, side / 2 + i / 40});
            list.begin(how.view);
            renderer.collect(workspace.document.world, how, list);
            device.forgetDraws();
        };
        frame(0);
        workspace.tiles.stamp.cells = {cellOf(static_cast<int>(zoom * 50.0f) + 1)};
        rows.push_back(rowOf(format("frame of painting, zoom {}", fixedText(static_cast<double>(zoom), 3)),
                             60, 1.0 / 60.0, frame));
    }
}

}  // namespace

int runTiles(const Options& options) {
    const int side = options.quick ? 1024 : 16384;
    const int rounds = options.quick ? 2 : 5;
    const int box = options.quick ? 200 : 1000;
    HugeScene huge{side};
    std::printf("%d x %d tiles, %zu bytes of scene\n", side, side, huge.bytes());
    printHeader();
    std::vector<Row> rows;
    std::unique_ptr<editor::Workspace> workspace;
    rows.push_back(rowOf("open", rounds, 1.0, [&](int) {
        workspace = huge.workspace();
        static_cast<void>(workspace->open(kPath).ok());
    }));
    runAction(*workspace, "tool.brush");
    World& world = workspace->document.world;
    rows.push_back(rowOf("first collider", 1, 0.0, [&](int) { previewPhysics(world); }));
    rows.push_back(rowOf("edit one tile, its collider too", 200, 1e-3, [&](int i) {
        workspace->tiles.stamp.cells = {cellOf(i % 3)};
        stroke(*workspace, {side / 2 + i, side / 2 + i % 50}, {side / 2 + i, side / 2 + i % 50});
        previewPhysics(world);
    }));
    runAction(*workspace, "tool.rectangle");
    rows.push_back(rowOf(format("rectangle of {} cells", box * box), rounds, 0.2, [&](int i) {
        workspace->tiles.stamp.cells = {cellOf(50 + i)};
        stroke(*workspace, {10, 10}, {9 + box, 9 + box});
    }));
    runAction(*workspace, "tool.fill");
    rows.push_back(rowOf(format("fill of {} cells", box * box), rounds, 0.2, [&](int i) {
        workspace->tiles.stamp.cells = {cellOf(30 + i)};
        stroke(*workspace, {20, 20}, {20, 20});
    }));
    rows.push_back(rowOf("undo of it", 1, 0.2, [&](int) { workspace->undo.undo(); }));
    runAction(*workspace, "tool.brush");
    addPainting(*workspace, huge.assets(), side, rows);
    rows.push_back(rowOf("save", rounds, 0.0, [&](int) { static_cast<void>(workspace->save().ok()); }));
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
