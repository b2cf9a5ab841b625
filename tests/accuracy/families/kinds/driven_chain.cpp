// Arms, cranes and grabs on a fixed base: chains of rods with a motor and limits at each hinge. Some have a
// telescopic boom, fingers at the tip, or a load that is fixed to the tip or hangs from it by a rope.
//
// Each motor has at least 3 times the static torque of the horizontal chain beyond it. The motors' speed is
// limited to 1.2 rad/s divided by the number of rods, so that accelerations need less than a tenth of this
// torque (at 2 rad/s the tip of a 9 m arm would have 36 m/s2). So each joint must reach the limit towards
// which its motor drives it, and stay there.

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"
#include "tests/accuracy/families/mechanism.hpp"

namespace plumb::families {

namespace {

constexpr float kGravity = 10.0f;  // m/s2

struct Driven {           // a joint with a motor
    std::uint32_t a, b;   ///< indices of the bodies
    bool slides = false;  ///< true: slider joint (boom)
    float target = 0.0f;  ///< displacement from the start to the limit, rad or m
};

struct Builder {
    Random& random;
    Blueprint plan;
    float density = 1.0f;  ///< density of the rods, kg/m2
    float width = 0.1f;    ///< width of the rods, m
    float excess = 3.0f;   ///< ratio of a motor's maximum torque to the static torque
    float fastest = 1.0f;  ///< speed of the motors, rad/s
    std::vector<Driven> driven;
    std::vector<float> lengths;  ///< lengths of the rods, m, including the travel of a boom
    std::vector<float> masses;   ///< masses of the rods, kg
    float tipMass = 0.0f;        ///< mass of fingers and load, kg

    /// Motor torque at the hinge of a rod, N m: `excess` times the
    /// static torque of the horizontal chain from this rod on.
    [[nodiscard]] float torqueAt(std::size_t rod) const {
        float reach = 0.0f, sum = 0.0f;
        for (std::size_t i = rod; i < lengths.size(); ++i) {
            sum += masses[i] * (reach + lengths[i]);
            reach += lengths[i];
        }
        return excess * kGravity * (sum + tipMass * (reach + 1.0f));
    }
    [[nodiscard]] float forceAt(std::size_t rod) const {
        float sum = tipMass;
        for (std::size_t i = rod; i < masses.size(); ++i) sum += masses[i];
        return excess * kGravity * sum;
    }
    void hinge(std::uint32_t a, std::uint32_t b, Vec2 at, float torque) {
        const float side = random.below(2) == 0 ? 1.0f : -1.0f, range = random.between(0.2f, 1.5f);
        const float speed = fastest * random.between(0.5f, 1.0f);
        plan.join(a, b, at,
                  {.limited = true,
                   .lower = side > 0.0f ? -0.2f : -range,
                   .upper = side > 0.0f ? range : 0.2f,
                   .driven = true,
                   .speed = side * speed,
                   .maxForce = torque});
        driven.push_back({a, b, false, side * range});
    }
    void boom(std::uint32_t a, std::uint32_t b, Vec2 at, Vec2 along, float range, float force) {
        plan.join(a, b, at,
                  {.kind = scenes::JointKind::Slider,
                   .axis = along,
                   .limited = true,
                   .lower = 0.0f,
                   .upper = range,
                   .driven = true,
                   .speed = random.between(0.2f, 0.5f),
                   .maxForce = force});
        driven.push_back({a, b, true, range});
    }
};

double errorOf(const Stage& stage, const Driven& joint) {
    if (!takesPart(stage, joint.b) || !stage.has(joint.a)) return 0.0;
    if (!joint.slides) {
        const double turn = stage.turnOf(joint.b) - stage.turnOf(joint.a) - static_cast<double>(joint.target);
        return std::fabs(std::remainder(turn, static_cast<double>(kTau)));
    }
    const scenes::Point a = stage.positionOf(joint.a), b = stage.positionOf(joint.b);
    const double now = std::hypot(b.x - a.x, b.y - a.y);
    const auto planned = static_cast<double>(distance(stage.startOf(joint.a), stage.startOf(joint.b)));
    return std::fabs(now - planned - static_cast<double>(joint.target));
}

/// Adds a load that is fixed to the tip, or hangs from it by a rope.
void addLoad(Builder& builder, std::uint32_t tip, Vec2 at, float mass, int rope) {
    std::uint32_t above = tip;
    for (int i = 0; i < rope; ++i) {
        const Vec2 below = at + Vec2{0.0f, -0.4f};
        const std::uint32_t link = addRod(builder.plan, at, below, 0.05f, builder.density);
        builder.plan.join(above, link, at);
        above = link;
        at = below;
    }
    BodyPlan load;
    load.setup.position = at + Vec2{0.0f, -0.25f};
    load.shapes.push_back({scenes::box({0.3f, 0.25f}), {.mask = 0}});
    load.mass = mass;
    const std::uint32_t body = builder.plan.add(load);
    builder.plan.join(above, body, at,
                      {.kind = rope > 0 ? scenes::JointKind::Hinge : scenes::JointKind::Weld});
}

}  // namespace

Blueprint makeDrivenChain(Random& random) {
    Builder builder{.random = random};
    Blueprint& plan = builder.plan;
    plan.closed = false;
    plan.seconds = 12.0;
    const std::uint32_t base = plan.addAnchor({});
    const std::size_t rods = 2 + random.below(5);
    builder.density = random.between(1.0f, 100.0f);
    builder.width = random.between(0.05f, 0.2f);
    builder.excess = 3.0f * std::pow(10.0f, random.unit());
    builder.fastest = 1.2f / static_cast<float>(rods) + 0.2f;
    const bool hasBoom = random.below(3) == 0, hasFingers = random.below(3) == 0;
    const int rope = static_cast<int>(random.below(5));
    const float angle = random.between(0.0f, kPi);
    const Vec2 along{cosine(angle), sine(angle)};
    for (std::size_t i = 0; i < rods; ++i) {
        builder.lengths.push_back(random.between(0.4f, 1.5f));
        builder.masses.push_back(builder.density * builder.width * builder.lengths.back());
    }
    const float slide = 0.7f * builder.lengths.back();
    if (hasBoom) {
        builder.lengths.push_back(slide);
        builder.masses.push_back(builder.density * builder.width * builder.lengths[rods - 1]);
    }
    const float load = builder.masses[0] * std::pow(50.0f, random.unit());
    const float finger = builder.density * builder.width * 0.4f;
    builder.tipMass = load + 2.0f * finger + static_cast<float>(rope) * builder.density * 0.02f;

    std::uint32_t last = base;
    Vec2 at{};
    for (std::size_t i = 0; i < rods; ++i) {
        const Vec2 end = at + builder.lengths[i] * along;
        const std::uint32_t rod = addRod(plan, at, end, builder.width, builder.density);
        builder.hinge(last, rod, at, builder.torqueAt(i));
        last = rod;
        at = end;
    }
    if (hasBoom) {
        // The boom starts fully retracted, inside the last rod.
        const std::uint32_t rod =
            addRod(plan, at - builder.lengths[rods - 1] * along, at, builder.width, builder.density);
        builder.boom(last, rod, at, along, slide, builder.forceAt(rods));
        last = rod;
    }
    if (hasFingers) {
        for (const float side : {-0.4f, 0.4f}) {
            const Vec2 direction{cosine(angle + side), sine(angle + side)};
            const std::uint32_t rod = addRod(plan, at, at + 0.4f * direction, builder.width, builder.density);
            builder.hinge(last, rod, at, builder.excess * kGravity * finger * 0.4f);
        }
    }
    addLoad(builder, last, at, load, rope);
    plan.goals.push_back({"reaches its limits",
                          [driven = builder.driven](const Stage& stage) {
                              double error = 0.0;
                              for (const Driven& joint : driven)
                                  error = std::max(error, errorOf(stage, joint));
                              return error;
                          },
                          0.03});
    plan.goals.push_back(keepsJoints(0.02));
    return std::move(builder.plan);
}

}  // namespace plumb::families
