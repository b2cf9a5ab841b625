#include "app/benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/game.hpp"
#include "app/system_order.hpp"
#include "core/profile.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "scene/components.hpp"
#include "scene/contact_events.hpp"
#include "scene/physics_state.hpp"

namespace plumb {
namespace {

constexpr float kSide = 8.0f;            ///< px of an entity
constexpr float kRoomPerEntity = 16.0f;  ///< px of the arena's side for each: a quarter of it is filled
constexpr int kWarmUp = 30;              ///< ticks

void addWall(World& world, Vec2 corner, Vec2 size) {
    Entity wall = world.createEntity();
    wall.addComponent<Transform>(corner.x, corner.y);
    wall.addComponent<BoxCollider>(size.x, size.y);
    wall.addComponent<StaticBody>();
}

/// Boxes and circles that fly about in a closed room, each bouncing off the others.
void fillArena(Game& game, int entities) {
    World& world = game.world;
    world.resource<PhysicsSettings>().gravity = {};
    const float side = kRoomPerEntity * std::ceil(std::sqrt(static_cast<float>(entities)));
    addWall(world, {-32.0f, -32.0f}, {side + 64.0f, 32.0f});
    addWall(world, {-32.0f, side}, {side + 64.0f, 32.0f});
    addWall(world, {-32.0f, 0.0f}, {32.0f, side});
    addWall(world, {side, 0.0f}, {32.0f, side});
    Random random = Random::seeded(1);
    const int columns = static_cast<int>(side / kRoomPerEntity);
    for (int i = 0; i < entities; ++i) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(static_cast<float>(i % columns) * kRoomPerEntity + 4.0f,
                                       static_cast<float>(i / columns) * kRoomPerEntity + 4.0f);
        Sprite& sprite =
            entity.addComponent<Sprite>(TextureId{}, static_cast<int>(kSide), static_cast<int>(kSide));
        const auto shade = static_cast<std::uint8_t>(random.below(160) + 80);
        sprite.tint = {shade, static_cast<std::uint8_t>(255 - shade / 2), 220, 255};
        sprite.layer = i % 4;
        RigidBody& body = entity.addComponent<RigidBody>(1.0f);
        body.velocity = {random.between(-120.0f, 120.0f), random.between(-120.0f, 120.0f)};
        body.friction = 0.0f;
        body.bounciness = 1.0f;
        if (i % 2 == 0) {
            entity.addComponent<BoxCollider>(kSide, kSide);
        } else {
            entity.addComponent<CircleCollider>(kSide * 0.5f);
        }
    }
    Entity camera = world.createEntity();
    camera.addComponent<Transform>(side * 0.5f, side * 0.5f);
    camera.addComponent<Camera>().zoom = 360.0f / side;
}

double median(std::vector<double>& values) {
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

double secondsOf(const Profile& profile, std::string_view name) {
    for (const Profile::Zone& zone : profile.zones()) {
        if (zone.name == name) return zone.seconds;
    }
    return 0.0;
}

}  // namespace

BenchmarkResult runBenchmark(int entities, int ticks, Screen* screen) {
    Game game;
    addAllSystems(game.world);
    fillArena(game, entities);
    Profile profile;
    game.world.provide(profile);
    std::vector<double> systems;
    std::vector<double> broad;
    std::vector<double> narrow;
    std::vector<double> render;
    BenchmarkResult result;
    for (int tick = 0; tick < kWarmUp + ticks; ++tick) {
        profile.reset();
        const double start = threadSeconds();
        tickGame(game, InputFrame{});
        const double simulated = threadSeconds();
        if (screen != nullptr) {
            screen->draw(game.world, game.assets, 0.5f);
            result.drawCalls = screen->drawCalls();
        }
        const double drawn = threadSeconds();
        if (screen != nullptr) screen->swap();
        if (tick < kWarmUp) continue;
        result.contacts += game.world.events<ContactBegan>().size();
        broad.push_back(secondsOf(profile, "broad phase"));
        narrow.push_back(secondsOf(profile, "narrow phase"));
        systems.push_back(simulated - start - broad.back() - narrow.back());
        render.push_back(drawn - simulated);
    }
    result.entities = entities;
    result.systemsMs = median(systems) * 1000.0;
    result.broadMs = median(broad) * 1000.0;
    result.narrowMs = median(narrow) * 1000.0;
    result.renderMs = median(render) * 1000.0;
    return result;
}

std::string benchmarkTable(const BenchmarkResult& result) {
    const auto ms = [](double value) { return fixedText(value, 2) + "ms"; };
    std::string table = format("Entities: {}\n", result.entities);
    table += "Systems Update: " + ms(result.systemsMs) + "\n";
    table += "Collision Broad Phase: " + ms(result.broadMs) + "\n";
    table += "Collision Narrow Phase: " + ms(result.narrowMs) + "\n";
    table += "Render: " + ms(result.renderMs) + format(" ({} draw calls)\n", result.drawCalls);
    table += "Total Frame: " + ms(result.totalMs()) +
             format(" ({} FPS theoretical)\n", static_cast<int>(1000.0 / std::max(result.totalMs(), 0.001)));
    return table + format("Contacts begun: {}\n", result.contacts);
}

}  // namespace plumb
