#include "physics/debug/picture.hpp"
#include "physics/model/bodies.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

constexpr float kVelocityLength = 0.1f;  // s: meters drawn for 1 m/s
constexpr float kPathTime = 1.0f;        // s
constexpr int kPathLines = 20;

}  // namespace

void drawVelocities(const Picture& picture) {
    picture.forBodies([&](std::uint32_t body) {
        const Vec2 velocity = picture.world.bodies.motion[body].velocity;
        if (velocity == Vec2{}) return;
        const Vec2 from = picture.centre(body);
        picture.canvas.arrow(from, from + kVelocityLength * velocity, DebugRole::Velocity);
    });
}

// As predictTransform(), but relative to the view's origin, so that it is exact far from the world's origin
// too.
void drawPaths(const Picture& picture) {
    const World& world = picture.world;
    picture.forBodies([&](std::uint32_t body) {
        const Vec2 velocity = world.bodies.motion[body].velocity;
        if (!isDynamic(world, body) || length(velocity) < world.bodies.info[body].sleepSpeed) return;
        const Vec2 start = picture.centre(body);
        Vec2 from = start;
        for (int i = 1; i <= kPathLines; ++i) {
            const float time = kPathTime * static_cast<float>(i) / static_cast<float>(kPathLines);
            const Vec2 to = start + freeMotionOf(world, body, time).displacement;
            picture.canvas.line(from, to, DebugRole::Path);
            from = to;
        }
    });
}

void drawCentres(const Picture& picture) {
    picture.forBodies([&](std::uint32_t body) {
        if (isDynamic(picture.world, body))
            picture.canvas.circle(picture.centre(body), kPointRadius, DebugRole::Centre);
    });
}

void drawSweeps(const Picture& picture) {
    const World& world = picture.world;
    const Workspace* work = picture.choice.lastStep;
    if (work == nullptr || world.awake.empty()) return;
    for (const SweptBody& swept : work->swept) {
        const std::uint32_t body = swept.body;
        if (!isDynamic(world, body) || !picture.shows(body)) continue;
        const BodyPose from = swept.sweep.at(swept.sweep.begin);
        forShapesOf(world, body, [&](std::uint32_t s) {
            drawOutline(picture.canvas, picture.outline(s), picture.frame(from), DebugRole::Sweep);
        });
        const Vec2 start = picture.seen(from.centre);
        picture.canvas.line(start, picture.seen(swept.sweep.at(1.0f).centre), DebugRole::Sweep);
        if (swept.hits > 0) picture.canvas.circle(start, kPointRadius, DebugRole::Impact);
    }
}

}  // namespace plumb::physics
