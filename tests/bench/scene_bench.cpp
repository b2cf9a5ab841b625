// Loading and saving times of scenes, and time of a tick that spawns many bodies. The targets are seconds on
// the reference machine.

#include <cstdio>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/type_registry.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/colliders/circle_collider.hpp"
#include "scene/components/drawing/sprite.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/transform.hpp"
#include "scene/files/prefab.hpp"
#include "scene/files/scene_file.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/physics_system.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {
namespace {

constexpr const char* kPath = "scenes/bench.scene.json";
constexpr double kSecond = 1e9;  // ns

struct Stage {
    TypeRegistry types;
    PrefabLibrary prefabs{types};
    SceneContext context{types, &prefabs};
    Stage() { registerSceneComponents(types); }
};

void addCrates(World& world, SceneId scene, std::size_t count) {
    Random random = Random::seeded(1);
    const TextureId texture{world.texts().add("assets/crate.png")};
    for (std::size_t i = 0; i < count; ++i) {
        const Entity crate = world.createEntity();
        crate.addComponent<SceneEntity>(SceneEntity{newStableId(random), static_cast<int>(i), scene});
        crate.addComponent<Transform>(random.between(0.0f, 1e4f), random.between(0.0f, 1e4f));
        crate.addComponent<Sprite>(texture, 16, 16);
        crate.addComponent<RigidBody>(random.between(1.0f, 9.0f));
        crate.addComponent<BoxCollider>(16, 16);
    }
}

void addMap(World& world, SceneId scene, int side) {
    Random random = Random::seeded(2);
    std::vector<TileCell> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (TileCell& cell : cells)
        cell = random.below(3) == 0 ? cellOf(static_cast<int>(random.below(200))) : 0;
    TileGrid grid;
    grid.replaceCells(side, side, std::move(cells));
    const Entity map = world.createEntity();
    map.addComponent<SceneEntity>(SceneEntity{newStableId(random), 0, scene});
    map.addComponent<Transform>();
    map.addComponent<TileLayer>().cells = world.tiles().add(std::move(grid));
}

/// Time limits for loading and saving a scene, s; 0: no limit.
struct Limits {
    double load = 0.0;
    double save = 0.0;
};

void tell(const Row& row) {
    print(row);
    const auto items = static_cast<double>(row.n);
    std::printf("    %s s in total", fixedText(row.ns * items / kSecond, 3).c_str());
    if (row.target > 0.0) std::printf(", target %s s", fixedText(row.target * items / kSecond, 3).c_str());
    std::printf("\n");
    std::fflush(stdout);
}

/// Measures opening and saving the scene in `made`, in JSON and in binary format: one row each, ns per item.
void measure(const std::string& name, std::size_t n, Limits limits, World& made, const Stage& stage,
             const Options& options, std::vector<Row>& rows) {
    const std::string text = sceneToJson(made, stage.context, sceneId(kPath));
    const std::string binary = sceneToBinary(made, stage.context, sceneId(kPath));
    World world{stage.types};
    const auto empty = [&world] { unloadScene(world, sceneId(kPath)), world.clear(); };
    std::string out;
    struct Kind {
        const char* name;
        double limit;
        Contestant contestant;
    };
    const std::vector<Kind> kinds{
        {" open json",
         limits.load,
         {empty, [&] { static_cast<void>(loadScene(world, stage.context, kPath, text)); }}},
        {" open binary",
         limits.load,
         {empty, [&] { static_cast<void>(loadSceneBinary(world, stage.context, kPath, binary)); }}},
        {" save json",
         limits.save,
         {{}, [&] { out = sceneToJson(made, stage.context, sceneId(kPath)), keep(out.data()); }}},
    };
    const auto items = static_cast<double>(n);
    for (const Kind& kind : kinds) {
        const Timing timing = race({&kind.contestant, 1}, options).front();
        rows.push_back({name + kind.name, n, timing.minimum * kSecond / items,
                        timing.median * kSecond / items, 0.0, kind.limit * kSecond / items});
        tell(rows.back());
    }
}

/// A world of bodies at rest and of bullets; every tick destroys all bullets and creates as many new ones.
class Barrage {
public:
    static constexpr std::size_t kResting = 10'000, kBullets = 1'000;

    Barrage() {
        world_.addSystem<PhysicsSystem>();
        for (std::size_t i = 0; i < kResting; ++i) {
            const Entity crate = world_.createEntity();
            crate.addComponent<Transform>(20.0f * static_cast<float>(i % 100),
                                          20.0f * static_cast<float>(i / 100));
            crate.addComponent<BoxCollider>(10.0f, 10.0f);
            crate.addComponent<RigidBody>().gravityScale = 0.0f;
        }
        constexpr int kTicksToSleep = 60;
        for (int i = 0; i < kTicksToSleep; ++i) tick(0);
    }

    void tick(std::size_t bullets) {
        world_.beginTick();
        for (const EntityId bullet : bullets_) world_.destroy(bullet);
        bullets_.clear();
        for (std::size_t i = 0; i < bullets; ++i) {
            const Entity bullet = world_.createEntity();
            bullet.addComponent<Transform>(5.0f * static_cast<float>(i), -500.0f);
            bullet.addComponent<CircleCollider>(2.0f);
            bullet.addComponent<RigidBody>().velocity = {0.0f, -300.0f};
            bullets_.push_back(bullet);
        }
        world_.update(1.0f / 60.0f);
    }

private:
    World world_;
    std::vector<EntityId> bullets_;
};

Row barrageRow(const Options& options) {
    Barrage barrage;
    const Contestant contestant{{}, [&] { barrage.tick(Barrage::kBullets); }};
    const Timing timing = race({&contestant, 1}, options).front();
    constexpr double kTarget = 0.002;  // s per tick
    constexpr auto kItems = static_cast<double>(Barrage::kBullets);
    return {"bullets spawned beside 10,000 at rest",
            Barrage::kBullets,
            timing.minimum * kSecond / kItems,
            timing.median * kSecond / kItems,
            0.0,
            kTarget * kSecond / kItems};
}

}  // namespace

int runScene(const Options& options) {
    const Stage stage;
    std::vector<Row> rows;
    printHeader();
    rows.push_back(barrageRow(options));
    tell(rows.back());
    {
        World made{stage.types};
        const std::size_t count = options.quick ? 1000 : 100000;
        addCrates(made, addScene(made, kPath), count);
        measure("entities", count, {1.0, 1.0}, made, stage, options, rows);
    }
    {
        World made{stage.types};
        const int side = options.quick ? 300 : 4096;
        addMap(made, addScene(made, kPath), side);
        measure("tiles", static_cast<std::size_t>(side) * static_cast<std::size_t>(side), {1.0, 0.0}, made,
                stage, options, rows);
    }
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
