#include "app/benchmark.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/game.hpp"
#include "app/game_content.hpp"
#include "core/clock.hpp"
#include "core/profile.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "scene/components.hpp"
#include "scene/physics/contact_events.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb {
namespace {

constexpr float kRoomPerEntity = 16.0f;  ///< px, side of an entity's square: a quarter of the arena is filled
constexpr int kWarmUp = 30;              ///< ticks before measuring
constexpr int kTexels = 16;              ///< side of a texture
constexpr float kWide = 640.0f;          ///< px, width of the game image
constexpr float kHigh = 360.0f;          ///< px, height of the game image
constexpr std::array kSides{4, 6, 8, 10, 12};  ///< px, sides of the entities

/// Returns the texture of a crate or a ball with a dark rim, in grey, to be tinted.
Image shadedPicture(bool round) {
    Image image{kTexels, kTexels, {}};
    constexpr float kMiddle = 0.5f * kTexels;
    for (int y = 0; y < kTexels; ++y) {
        for (int x = 0; x < kTexels; ++x) {
            const Vec2 out{static_cast<float>(x) + 0.5f - kMiddle, static_cast<float>(y) + 0.5f - kMiddle};
            const float reach = round ? length(out) : std::max(std::abs(out.x), std::abs(out.y));
            const bool rim = reach > kMiddle - 2.0f;
            const auto shade = static_cast<std::uint8_t>(rim ? 120 : 255 - y * 4);
            const auto opacity = static_cast<std::uint8_t>(reach <= kMiddle ? 255 : 0);
            image.rgba.insert(image.rgba.end(), {shade, shade, shade, opacity});
        }
    }
    return image;
}

void addWall(World& world, Vec2 corner, Vec2 size) {
    Entity wall = world.createEntity();
    wall.addComponent<Transform>(corner.x, corner.y);
    wall.addComponent<BoxCollider>(size.x, size.y);
    wall.addComponent<StaticBody>();
}

void addWalls(World& world, Vec2 room) {
    constexpr float kThick = 32.0f;
    addWall(world, {-kThick, -kThick}, {room.x + 2.0f * kThick, kThick});
    addWall(world, {-kThick, room.y}, {room.x + 2.0f * kThick, kThick});
    addWall(world, {-kThick, 0.0f}, {kThick, room.y});
    addWall(world, {room.x, 0.0f}, {kThick, room.y});
}

/// Adds a body without friction and with full restitution. @param round  true: a ball, false: a crate
void addBouncer(World& world, Vec2 corner, int side, TextureId picture, bool round, Random& random) {
    Entity entity = world.createEntity();
    entity.addComponent<Transform>(corner.x, corner.y);
    Sprite& sprite = entity.addComponent<Sprite>(picture, side, side);
    sprite.source = {0.0f, 0.0f, kTexels, kTexels};
    const auto shade = static_cast<std::uint8_t>(random.below(160) + 80);
    sprite.tint = {shade, static_cast<std::uint8_t>(255 - shade / 2), 220, 255};
    sprite.layer = static_cast<int>(random.below(4));
    RigidBody& body = entity.addComponent<RigidBody>(1.0f);
    body.velocity = {random.between(-120.0f, 120.0f), random.between(-120.0f, 120.0f)};
    body.friction = 0.0f;
    body.bounciness = 1.0f;
    const auto size = static_cast<float>(side);
    if (round) {
        entity.addComponent<CircleCollider>(size * 0.5f);
    } else {
        entity.addComponent<BoxCollider>(size, size);
    }
}

/// Adds crates and balls of five sizes in a closed room with the window's aspect ratio, all in view.
void fillArena(Game& game, int entities) {
    World& world = game.world;
    world.resource<PhysicsSettings>().gravity = {};
    const TextureId crate = game.assets.addTexture("benchmark crate", shadedPicture(false));
    const TextureId ball = game.assets.addTexture("benchmark ball", shadedPicture(true));
    const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<float>(entities) * kWide / kHigh)));
    const int rows = (entities + columns - 1) / columns;
    const Vec2 room = Vec2{static_cast<float>(columns), static_cast<float>(rows)} * kRoomPerEntity;
    addWalls(world, room);
    Random random = Random::seeded(1);
    for (int i = 0; i < entities; ++i) {
        const Vec2 place{static_cast<float>(i % columns), static_cast<float>(i / columns)};
        const bool round = i % 2 == 1;
        addBouncer(world, place * kRoomPerEntity + Vec2{2.0f, 2.0f},
                   kSides[random.below(static_cast<std::uint32_t>(kSides.size()))], round ? ball : crate,
                   round, random);
    }
    Entity camera = world.createEntity();
    camera.addComponent<Transform>(room.x * 0.5f, room.y * 0.5f);
    camera.addComponent<Camera>().zoom = std::min(kWide / room.x, kHigh / room.y);
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

/// CPU times of each stage, s, one value per frame.
class StageTimes {
public:
    void add(const Profile& profile, double simulation, double drawing) {
        broad_.push_back(secondsOf(profile, "broad phase"));
        narrow_.push_back(secondsOf(profile, "narrow phase"));
        systems_.push_back(simulation - broad_.back() - narrow_.back());
        render_.push_back(drawing);
    }
    void write(BenchmarkResult& result) {
        result.systemsMs = median(systems_) * 1000.0;
        result.broadMs = median(broad_) * 1000.0;
        result.narrowMs = median(narrow_) * 1000.0;
        result.renderMs = median(render_) * 1000.0;
    }

private:
    std::vector<double> systems_;
    std::vector<double> broad_;
    std::vector<double> narrow_;
    std::vector<double> render_;
};

}  // namespace

BenchmarkResult runBenchmark(const BenchmarkSettings& settings, Screen* screen) {
    Game game;
    game.content.addSystems(game.world);
    fillArena(game, settings.entities);
    Profile profile;
    game.world.provide(profile);
    StageTimes stages;
    std::vector<double> frames;
    std::vector<Event> events;
    BenchmarkResult result;
    double before = wallSeconds();
    for (int frame = 0; frame < kWarmUp + settings.frames; ++frame) {
        profile.reset();
        const double start = threadSeconds();
        tickGame(game, InputFrame{});
        const double simulated = threadSeconds();
        if (screen != nullptr) screen->draw(game.world, game.assets, 1.0f);
        const double drawn = threadSeconds();
        if (screen != nullptr) {
            screen->swap();
            screen->window().pollEvents(events);
            events.clear();
        }
        const double now = wallSeconds();
        if (frame >= kWarmUp) {
            stages.add(profile, simulated - start, drawn - simulated);
            frames.push_back(now - before);
            result.contacts += game.world.events<ContactBegan>().size();
        }
        before = now;
    }
    result.entities = settings.entities;
    stages.write(result);
    if (screen != nullptr) {
        result.drawCalls = screen->drawCalls();
        result.window = screen->window().drawableSize();
        result.frameTimes = frameTimesOf(frames);
    }
    return result;
}

std::string benchmarkTable(const BenchmarkResult& result) {
    const auto ms = [](double value) { return fixedText(value, 2) + "ms\n"; };
    std::string table = format("Entities: {}\n", result.entities);
    table += "Systems Update: " + ms(result.systemsMs);
    table += "Collision Broad Phase: " + ms(result.broadMs);
    table += "Collision Narrow Phase: " + ms(result.narrowMs);
    table += "Render: " + ms(result.renderMs);
    table += format("Total Frame: {}ms ({} FPS theoretical)\n", fixedText(result.totalMs(), 2),
                    static_cast<int>(1000.0 / std::max(result.totalMs(), 0.001)));
    table += format("\nContacts Begun: {}\n", result.contacts);
    if (result.frameTimes.frames == 0) return table;
    table += format("Draw Calls: {}\nWindow: {}x{}\n", result.drawCalls, result.window.width,
                    result.window.height);
    return table + frameTimesText(result.frameTimes);
}

}  // namespace plumb
