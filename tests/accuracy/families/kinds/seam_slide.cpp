// A body that slides or rolls over a floor of adjacent boxes.
//
// The floor is flat, so the body must move as on a single box: sliding decelerates it by friction * g;
// rolling, or sliding without friction, keeps the speed. Sliding shapes tip over if the friction exceeds
// width / height; the smallest width / height here is 0.73, of the pentagon.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

enum class Slider : std::uint8_t { Box, Ball, Pentagon, Capsule, Count };

Outline outlineOf(Slider kind, float half) {
    switch (kind) {
        case Slider::Box: return scenes::box({half, 0.8f * half});
        case Slider::Ball: return scenes::circle(half);
        case Slider::Capsule: return scenes::capsule({-0.5f * half, 0.0f}, {0.5f * half, 0.0f}, 0.5f * half);
        case Slider::Pentagon:
        case Slider::Count: break;
    }
    std::array<Vec2, 5> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float angle = kTau * (static_cast<float>(i) + 0.25f) / 5.0f;
        corners[i] = half * Vec2{std::cos(angle), std::sin(angle)};
    }
    return scenes::polygon(corners);
}

/// Height of the center above the floor, m.
float heightOf(Slider kind, float half) {
    switch (kind) {
        case Slider::Box: return 0.8f * half;
        case Slider::Ball: return half;
        case Slider::Capsule: return 0.5f * half;
        case Slider::Pentagon:
        case Slider::Count: break;
    }
    return half * std::cos(0.1f * kTau);
}

struct Ride {
    double start = 0.0;  // height of the body at rest, m
    double hop = 0.0;    // maximum deviation from `start`, m
};

}  // namespace

Blueprint makeSeamSlide(Random& random) {
    constexpr int kRests = 30;  // steps at rest before the body is set in motion
    constexpr int kTiles = 55;  // maximum number of boxes of the floor
    constexpr float kGravity = 10.0f;
    Blueprint plan;
    plan.closed = false;  // the body is set in motion by the test
    const auto kind = static_cast<Slider>(random.below(static_cast<std::uint32_t>(Slider::Count)));
    const float half = 0.02f * std::pow(50.0f, random.unit());  // half size of the body, m
    const float speed = 0.5f * std::pow(40.0f, random.unit());  // initial speed, m/s
    const bool rolls = kind == Slider::Ball;
    const float friction = random.below(2) == 0 ? 0.0f : random.between(0.05f, 0.5f);
    const float width = half * std::pow(10.0f, random.between(-0.3f, 1.0f));  // mean width of a tile, m
    const float unlike = random.between(0.0f, 0.8f);
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = friction};
    const float slows = rolls ? 0.0f : friction * kGravity;  // deceleration, m/s2

    // The run ends when the body has half its speed, after 2 s, or at the last boxes of the floor.
    float seconds = 2.0f;
    if (slows > 0.0f) seconds = std::min(seconds, 0.5f * speed / slows);
    seconds = std::min(seconds, static_cast<float>(kTiles - 3) * width * (1.0f - 0.5f * unlike) / speed);
    const int steps = std::max(static_cast<int>(seconds / kStep), 2);
    plan.seconds = static_cast<double>(kStep) * static_cast<double>(kRests + steps);

    const float depth = std::max(half, 0.1f);
    float edge = 2.0f * half + 0.5f;
    plan.addStatic(scenes::box({edge, depth}), {0.0f, -depth}, stuff);
    for (int i = 0; i < kTiles; ++i) {
        const float own = 0.5f * width * (1.0f - unlike * random.unit());
        plan.addStatic(scenes::box({own, depth}), {edge + own, -depth}, stuff);
        edge += 2.0f * own;
    }
    const float last = 2.0f * half + speed * 3.0f;
    plan.addStatic(scenes::box({last, depth}), {edge + last, -depth}, stuff);
    const std::uint32_t body = plan.addDynamic(outlineOf(kind, half), {0.0f, heightOf(kind, half)}, stuff);

    auto ride = std::make_shared<Ride>();
    const float spin = rolls && friction > 0.0f ? -speed / half : 0.0f;
    plan.drive = [=](Stage& stage, int step) {
        if (step == 0) *ride = {};
        if (!stage.has(body) || step < kRests) return;
        const double height = stage.positionOf(body).y;
        if (step == kRests) {
            ride->start = height;
            stage.setVelocity(body, {speed, 0.0f});
            stage.setSpin(body, spin);
        }
        ride->hop = std::max(ride->hop, std::fabs(height - ride->start));
    };
    const double wanted = static_cast<double>(speed - slows * static_cast<float>(steps) * kStep);
    plan.goals.push_back({"keeps the speed of a single floor",
                          [=](const Stage& stage) {
                              if (!stage.has(body)) return 0.0;
                              return std::fabs(static_cast<double>(stage.velocityOf(body).x) - wanted) /
                                     static_cast<double>(speed);
                          },
                          0.01});
    plan.goals.push_back({"hops over no seam", [=](const Stage&) { return ride->hop; }, 0.001});
    return plan;
}

}  // namespace plumb::families
