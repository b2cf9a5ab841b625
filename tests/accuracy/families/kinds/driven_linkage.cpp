// Linkages with one degree of freedom that form loops with the ground and are driven by a motor at the crank.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"
#include "tests/accuracy/families/mechanism.hpp"

namespace plumb::families {

namespace {

struct Builder {
    Blueprint plan;
    float density = 1.0f;  // density of the rods, kg/m2
    std::uint32_t ground = 0;

    std::uint32_t rod(Vec2 from, Vec2 to) { return addRod(plan, from, to, 0.1f, density); }
    void drive(std::uint32_t crank, Vec2 at, float speed, float torque) {
        plan.join(ground, crank, at, {.driven = true, .speed = speed, .maxForce = torque});
    }
};

/// Adds a four-bar linkage whose crank can rotate fully (Grashof's condition, 1883), with a margin.
std::uint32_t fourBar(Builder& builder, Random& random, float speed, float torque) {
    const float crank = random.between(0.3f, 1.0f), base = crank * random.between(2.0f, 4.0f);
    const float coupler = crank * random.between(2.0f, 4.0f);
    // Grashof: shortest + longest < sum of the other two: the linkage then closes at every crank angle.
    const float low = std::max(std::fabs(base - coupler) + 1.15f * crank, 1.2f * crank);
    const float high = base + coupler - 1.15f * crank;
    const float rocker = low + (high - low) * random.between(0.05f, 0.6f);
    const float angle = random.between(0.0f, kTau);
    const Vec2 end{base, 0.0f}, pin{crank * std::cos(angle), crank * std::sin(angle)};
    const Vec2 joint = knee(pin, coupler, end, rocker);
    const std::uint32_t first = builder.rod({}, pin), second = builder.rod(pin, joint),
                        third = builder.rod(joint, end);
    builder.drive(first, {}, speed, torque);
    builder.plan.join(first, second, pin);
    builder.plan.join(second, third, joint);
    builder.plan.join(third, builder.ground, end);
    return first;
}

/// Adds two equal cranks with a coupler; both are driven,
/// as the loop could change its branch when folded flat.
std::uint32_t parallelogram(Builder& builder, Random& random, float speed, float torque) {
    const float crank = random.between(0.3f, 1.0f), base = random.between(1.5f, 4.0f);
    const float angle = random.between(0.3f, 2.8f);
    const Vec2 arm{crank * std::cos(angle), crank * std::sin(angle)}, end{base, 0.0f};
    const std::uint32_t first = builder.rod({}, arm), second = builder.rod(arm, end + arm),
                        third = builder.rod(end, end + arm);
    builder.drive(first, {}, speed, torque);
    builder.drive(third, end, speed, torque);
    builder.plan.join(first, second, arm);
    builder.plan.join(second, third, end + arm);
    return first;
}

std::uint32_t sliderCrank(Builder& builder, Random& random, float speed, float torque) {
    const float crank = random.between(0.3f, 1.0f), link = crank * random.between(1.5f, 4.0f);
    const float angle = random.between(0.0f, kTau), offset = crank * random.between(-0.3f, 0.3f);
    const Vec2 pin{crank * std::cos(angle), crank * std::sin(angle)};
    const float rise = offset - pin.y;
    const Vec2 end{pin.x + std::sqrt(link * link - rise * rise), offset};
    const std::uint32_t first = builder.rod({}, pin), second = builder.rod(pin, end);
    const std::uint32_t piston =
        builder.plan.addDynamic(scenes::box({0.2f, 0.15f}), end, {.density = builder.density, .mask = 0});
    builder.drive(first, {}, speed, torque);
    builder.plan.join(first, second, pin);
    builder.plan.join(second, piston, end);
    builder.plan.join(builder.ground, piston, end, {.kind = scenes::JointKind::Slider});
    return first;
}

/// Adds a four-bar linkage whose rocker drives a second loop.
std::uint32_t twoLoops(Builder& builder, Random& random, float speed, float torque) {
    const std::uint32_t crank = fourBar(builder, random, speed, torque);
    const std::uint32_t rocker = crank + 2;
    const Blueprint& plan = builder.plan;
    const scenes::BodySetup& body = plan.bodies[rocker].setup;
    const Vec2 middle = body.position;
    // A rod from the rocker's center to a slider; it is longer than the rocker's swing.
    const float link = 2.5f * plan.bodies[rocker].shapes[0].outline.half.x + 1.0f;
    const Vec2 end{middle.x + std::sqrt(link * link - middle.y * middle.y), 0.0f};
    if (!(link > std::fabs(middle.y))) return crank;
    const std::uint32_t second = builder.rod(middle, end);
    const std::uint32_t piston =
        builder.plan.addDynamic(scenes::box({0.2f, 0.15f}), end, {.density = builder.density, .mask = 0});
    builder.plan.join(rocker, second, middle);
    builder.plan.join(second, piston, end);
    builder.plan.join(builder.ground, piston, end, {.kind = scenes::JointKind::Slider});
    return crank;
}

}  // namespace

Blueprint makeDrivenLinkage(Random& random) {
    Builder builder;
    builder.plan.closed = false;
    builder.density = random.between(1.0f, 50.0f);
    builder.ground = builder.plan.addAnchor({});
    const float speed = 0.5f * std::pow(16.0f, random.unit()) * (random.below(2) == 0 ? 1.0f : -1.0f);
    // A hundred times the torque that holds the heaviest rods (4 m long, 0.1 m wide) horizontal, N m.
    const float torque = 100.0f * builder.density * 4.0f * 0.1f * 2.0f * 10.0f;
    std::uint32_t crank = 0;
    switch (random.below(4)) {
        case 0: crank = fourBar(builder, random, speed, torque); break;
        case 1: crank = parallelogram(builder, random, speed, torque); break;
        case 2: crank = sliderCrank(builder, random, speed, torque); break;
        default: crank = twoLoops(builder, random, speed, torque);
    }
    Blueprint& plan = builder.plan;
    // Sums the crank's rotation over all steps, as its angle alone does not contain full turns.
    struct Count {
        double turned = 0.0;
        Rot last;
    };
    auto count = std::make_shared<Count>();
    plan.drive = [count, crank](Stage& stage, int step) {
        if (!stage.has(crank)) return;
        const Rot now = stage.rotationOf(crank);
        if (step == 0) count->turned = 0.0;
        if (step > 0) count->turned += static_cast<double>(angleOf(between(count->last, now)));
        count->last = now;
    };
    const double wanted = static_cast<double>(speed) * (plan.seconds - static_cast<double>(kStep));
    plan.goals.push_back({"turns as driven",
                          [count, wanted](const Stage&) { return std::fabs(count->turned / wanted - 1.0); },
                          0.01});
    plan.goals.push_back(keepsJoints(0.1));
    return plan;
}

}  // namespace plumb::families
