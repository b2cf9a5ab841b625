// Bodies in a rotating drum. The drum is kinematic, or on a hinge with a motor.
//
// The drum is a closed ring of boxes that overlap at the corners of the ring.
// It is at most 45 % full, so that no body is forced out or crushed.

#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

BodyPlan drumOf(float radius, int sides, float thickness, int baffles, const Material& material) {
    BodyPlan drum;
    const float corner = kPi / static_cast<float>(sides);  // half the angle that a side covers, rad
    for (int i = 0; i < sides; ++i) {
        const float angle = 2.0f * corner * static_cast<float>(i);
        const Vec2 out{std::cos(angle), std::sin(angle)}, along{-out.y, out.x};
        const float reach = (radius + 2.0f * thickness) * std::tan(corner);
        const auto at = [&](float x, float y) { return x * out + y * along; };
        const Vec2 corners[] = {at(radius, -reach), at(radius + 2.0f * thickness, -reach),
                                at(radius + 2.0f * thickness, reach), at(radius, reach)};
        drum.shapes.push_back({scenes::polygon(corners), material});
        if (i >= baffles) continue;
        const Vec2 fin[] = {at(0.75f * radius, -0.5f * thickness), at(radius + thickness, -0.5f * thickness),
                            at(radius + thickness, 0.5f * thickness), at(0.75f * radius, 0.5f * thickness)};
        drum.shapes.push_back({scenes::polygon(fin), material});
    }
    return drum;
}

Outline itemOf(Random& random, float size) {
    switch (random.below(3)) {
        case 0: return scenes::circle(size);
        case 1: return scenes::box({0.8f * size, random.between(0.3f, 0.6f) * size});
        default: {
            const float lean = random.between(0.0f, 1.0f);
            const Vec2 corners[] = {size * Vec2{std::cos(lean), std::sin(lean)},
                                    size * Vec2{std::cos(lean + 2.0f), std::sin(lean + 2.0f)},
                                    size * Vec2{std::cos(lean + 4.0f), std::sin(lean + 4.0f)}};
            return scenes::polygon(corners);
        }
    }
}

}  // namespace

Blueprint makeTumbler(Random& random) {
    Blueprint plan;
    plan.closed = false;
    plan.seconds = 5.0;
    const float radius = random.between(1.5f, 5.0f);
    const int sides = 4 + static_cast<int>(random.below(9)), baffles = static_cast<int>(random.below(5));
    const float thickness = random.between(0.05f, 0.3f);
    const float spin =
        (random.below(2) == 0 ? 1.0f : -1.0f) * 0.2f * std::pow(30.0f, random.unit());  // rad/s
    const bool driven = random.below(2) == 0;
    const int count = 10 + static_cast<int>(random.below(41));
    const float full = random.between(0.1f, 0.45f), unlike = random.between(0.0f, 0.7f);
    const Material stuff{.density = random.between(0.5f, 10.0f), .friction = random.between(0.0f, 1.0f)};

    Material steel = stuff;
    steel.density = 10.0f;
    BodyPlan drum = drumOf(radius, sides, thickness, baffles, steel);
    drum.setup.motion = driven ? Motion::Dynamic : Motion::Kinematic;
    drum.setup.spin = driven ? 0.0f : spin;
    const std::uint32_t ring = plan.add(drum);
    if (driven) {
        // A hundred times the torque of the contents' weight at the rim, N m.
        const float torque = 100.0f * stuff.density * kPi * radius * radius * 10.0f * radius;
        plan.join(plan.addAnchor({}), ring, {}, {.driven = true, .speed = spin, .maxForce = torque});
    }
    // Bodies start in a grid inside the drum; `full` is the
    // ratio of their bounding circles' area to the drum's.
    const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<float>(count))));
    const float cell = 1.2f * radius / static_cast<float>(columns);
    const float size = std::min(radius * std::sqrt(full / static_cast<float>(count)), 0.48f * cell);
    std::vector<std::uint32_t> crowd;
    for (int i = 0; i < count; ++i) {
        const Vec2 at{(static_cast<float>(i % columns) + 0.5f) * cell - 0.6f * radius,
                      (static_cast<float>(i / columns) + 0.5f) * cell - 0.6f * radius};
        crowd.push_back(plan.addDynamic(itemOf(random, size * (1.0f - unlike * random.unit())), at, stuff));
    }
    plan.goals.push_back({"nothing gets out",
                          [=](const Stage& stage) {
                              double furthest = 0.0;
                              for (const std::uint32_t body : crowd) {
                                  if (!stage.has(body)) continue;
                                  const scenes::Point at = stage.positionOf(body);
                                  furthest = std::max(furthest, std::hypot(at.x, at.y));
                              }
                              return furthest;
                          },
                          // The distance of the ring's corners from its center.
                          static_cast<double>(radius / std::cos(kPi / static_cast<float>(sides)))});
    // Bodies that collide at the rim's speed may overlap by a quarter of the rim's path in a step.
    plan.goals.push_back(overlapsAtMost(0.05 + 0.25 * static_cast<double>(std::fabs(spin) * radius * kStep)));
    plan.goals.push_back(keepsJoints(0.05));
    return plan;
}

}  // namespace plumb::families
