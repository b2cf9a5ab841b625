// A car with two driven wheels on springs, on rough ground.
//
// The ground consists of segments with random slopes s, |s| <= limit. Wheels do not slip, as friction exceeds
// twice the limit. The motors' force is twice the weight's component on the steepest slope, and their torque
// too low to lift the front wheel (half the weight times half the wheelbase). Between the wheels the ground
// rises by at most half a wheelbase times the limit, which is below the axles. At a corner of the ground the
// car takes off with a vertical speed of at most 2 limit v < 1.2 m/s, for a quarter of a second. So it must
// move at 0.6 of its wheels' speed or more, which allows for losses in the air, on slopes and at the start.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

/// Heights of the ground at equal distances.
struct Ground {
    float start = 0.0f;  ///< x of the first height, m
    float pitch = 1.0f;  ///< distance between heights, m
    std::vector<float> heights;

    [[nodiscard]] Vec2 point(std::size_t i) const {
        return {start + pitch * static_cast<float>(i), heights[i]};
    }
    [[nodiscard]] double heightAt(double x) const {
        const double at = (x - static_cast<double>(start)) / static_cast<double>(pitch);
        const double place = std::clamp(at, 0.0, static_cast<double>(heights.size()) - 1.001);
        const auto i = static_cast<std::size_t>(place);
        const double part = place - static_cast<double>(i);
        return (1.0 - part) * static_cast<double>(heights[i]) + part * static_cast<double>(heights[i + 1]);
    }
};

/// Creates random ground, flat where the car starts, with heights of -3 to 3 m.
Ground groundOf(Random& random, float pitch, float limit, float length) {
    Ground ground{.start = -10.0f, .pitch = pitch};
    float height = 0.0f;
    while (ground.start + pitch * static_cast<float>(ground.heights.size()) < length) {
        ground.heights.push_back(height);
        if (ground.start + pitch * static_cast<float>(ground.heights.size()) < 3.0f) continue;
        height = std::clamp(height + pitch * random.between(-limit, limit), -3.0f, 3.0f);
    }
    return ground;
}

void lay(Blueprint& plan, const Ground& ground, const Material& stuff, bool asLoop) {
    BodyPlan made;
    made.setup.motion = Motion::Static;
    const std::size_t count = ground.heights.size();
    if (asLoop) {
        // From right to left, so that the free side of the chain is above.
        std::vector<Vec2> loop;
        for (std::size_t i = count; i > 0; --i) loop.push_back(ground.point(i - 1));
        loop.push_back({ground.point(0).x, -10.0f});
        loop.push_back({ground.point(count - 1).x, -10.0f});
        made.loops.push_back(loop);
        made.loopMaterial = stuff;
    } else {
        for (std::size_t i = 0; i + 1 < count; ++i)
            made.shapes.push_back({scenes::segment(ground.point(i), ground.point(i + 1)), stuff});
    }
    plan.add(made);
}

}  // namespace

Blueprint makeVehicleTerrain(Random& random) {
    Blueprint plan;
    plan.closed = false;
    plan.seconds = 12.0;
    const float radius = random.between(0.3f, 0.6f), base = radius * random.between(4.0f, 6.0f);
    const float hertz = random.between(2.5f, 6.0f), damping = random.between(0.4f, 1.0f);
    const float mass = random.between(5.0f, 500.0f), wheelShare = random.between(0.03f, 0.2f);
    // A spring of f Hz is compressed by g / (2 pi f)^2 at rest, and by up to three times that after a fall.
    const float sag = 3.0f * 10.0f / ((kTau * hertz) * (kTau * hertz));
    const float limit = random.between(0.3f, 1.0f) * std::min(0.3f, (radius - sag) / (0.5f * base));
    const float speed = random.between(0.5f, 1.0f) * std::min(4.0f, 0.6f / limit);
    const float pitch = random.between(0.5f, 2.0f);
    const Material stuff{.friction = random.between(0.7f, 1.0f)};
    const float all = mass * (1.0f + 2.0f * wheelShare);
    const float torque = std::min(2.0f * limit + 0.2f, 0.25f * base / radius) * all * 10.0f * radius;

    const Ground ground =
        groundOf(random, pitch, limit, 10.0f + 1.2f * speed * static_cast<float>(plan.seconds));
    lay(plan, ground, stuff, random.below(2) == 0);
    const float height = 2.0f * radius;
    const std::uint32_t chassis = plan.addDynamic(scenes::box({0.5f * base, 0.4f * radius}),
                                                  {0.0f, radius + 0.4f * radius}, {.friction = 0.1f});
    plan.bodies[chassis].mass = mass;
    std::vector<std::uint32_t> bodies{chassis};
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 at{0.5f * side * base, radius};
        bodies.push_back(plan.addDynamic(scenes::circle(radius), at, stuff));
        plan.bodies[bodies.back()].mass = mass * wheelShare;
        plan.join(chassis, bodies.back(), at,
                  {.kind = scenes::JointKind::Wheel,
                   .axis = {0.0f, 1.0f},
                   .driven = true,
                   .speed = -speed / radius,
                   .maxForce = 0.5f * torque,
                   .sprung = true,
                   .hertz = hertz,
                   .dampingRatio = damping});
    }
    const double minimum = 0.6 * static_cast<double>(speed) * plan.seconds;
    plan.goals.push_back({"gets along",
                          [=](const Stage& stage) {
                              return takesPart(stage, chassis) ? minimum - stage.positionOf(chassis).x : 0.0;
                          },
                          0.0});
    plan.goals.push_back({"stays on the ground",
                          [=](const Stage& stage) {
                              double off = 0.0;
                              for (const std::uint32_t body : bodies) {
                                  if (!takesPart(stage, body)) continue;
                                  const scenes::Point at = stage.positionOf(body);
                                  const double above = at.y - ground.heightAt(at.x);
                                  off +=
                                      above < 0.0 || above > static_cast<double>(2.0f * height) ? 1.0 : 0.0;
                              }
                              return off;
                          },
                          0.0});
    plan.goals.push_back({"keeps upright",
                          [=](const Stage& stage) {
                              return takesPart(stage, chassis) ? std::fabs(stage.turnOf(chassis)) : 0.0;
                          },
                          0.8});
    // Errors of the wheels' joints must be at most 3 % of the wheel radius.
    plan.goals.push_back(keepsJoints(0.03 * static_cast<double>(radius)));
    return plan;
}

}  // namespace plumb::families
