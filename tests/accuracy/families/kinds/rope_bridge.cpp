// Ropes, nets and bridges between two banks, with loads that drop on them, hang from them or drive over them.
//
// The links start on a circular arc of about 1 rad, so they have slack and forces are limited: a load P in
// the middle causes a tension of P span / (4 sag). Joint errors may be up to 5 % of a link, which is visible.
//
// An arc of radius r swings at w = sqrt(g / r); a drag d below 2 w reduces its speed at a rate of d / 2.
// Bridges with r < 10 m (w > 1/s) have d = 1.2 to 1.8 w and keep less than 1/1000 of the speed after 12 s.
// Other bridges have no drag, and their goals do not include that they come to rest.

#include <algorithm>
#include <cmath>

#include "tests/accuracy/families/family.hpp"
#include "tests/accuracy/families/goals.hpp"

namespace plumb::families {

namespace {

constexpr std::uint32_t kBanks = 1, kLinks = 2, kLoads = 4;

struct Builder {
    Blueprint plan;
    float link = 0.5f;       ///< length of a link, m
    float thickness = 0.1f;  ///< thickness of a link, m
    float drag = 0.0f;       ///< drag of all dynamic bodies, 1/s
    float linkMass = 1.0f;   ///< mass of a link, kg
    float friction = 0.6f;
    std::vector<Vec2> knots;  ///< positions of the hinges, from bank to bank; the banks' edges are at y = 0
    std::vector<std::uint32_t> banks;
    std::vector<std::uint32_t> hanging;  ///< bodies of the bridge: links, or nodes of the net
    std::vector<std::uint32_t> loads;

    [[nodiscard]] float halfSpan() const { return knots.back().x; }
    [[nodiscard]] Material material(std::uint32_t layers, std::uint32_t mask) const {
        return {.friction = friction, .layers = layers, .mask = mask};
    }
    std::uint32_t body(Vec2 at, float angle, const Outline& outline, const Material& material, float mass) {
        BodyPlan made;
        made.setup.position = at;
        made.setup.angle = angle;
        made.setup.drag = drag;
        made.shapes.push_back({outline, material});
        made.mass = mass;
        return plan.add(made);
    }
    std::uint32_t load(Vec2 at, const Outline& outline, float mass) {
        loads.push_back(body(at, 0.0f, outline, material(kLoads, ~0u), mass));
        return loads.back();
    }
    /// Adds a rod between two points, without hinges.
    std::uint32_t rod(Vec2 from, Vec2 to) {
        const Vec2 span = to - from;
        return body(from + 0.5f * span, arcTangent(span.y, span.x),
                    scenes::box({0.5f * length(span), 0.5f * thickness}), material(kLinks, kLoads), linkMass);
    }
};

/// Places the knots for links of equal length along the lowest part of a circle, an arc of `angle` rad.
/// @return the radius of the circle, m
float hang(Builder& builder, int links, float angle) {
    const float each = angle / static_cast<float>(links), radius = 0.5f * builder.link / sine(0.5f * each);
    for (int i = 0; i <= links; ++i) {
        const float at = each * static_cast<float>(i) - 0.5f * angle;
        builder.knots.push_back({radius * sine(at), radius * (cosine(0.5f * angle) - cosine(at))});
    }
    for (const float side : {-1.0f, 1.0f})
        builder.banks.push_back(builder.plan.addStatic(scenes::box({15.0f, 5.0f}),
                                                       {side * (builder.halfSpan() + 15.0f), -5.0f},
                                                       builder.material(kBanks, kLoads)));
    return radius;
}

/// Adds links from bank to bank with hinges at the knots.
void bridge(Builder& builder) {
    for (std::size_t i = 0; i + 1 < builder.knots.size(); ++i) {
        builder.hanging.push_back(builder.rod(builder.knots[i], builder.knots[i + 1]));
        builder.plan.join(i == 0 ? builder.banks[0] : builder.hanging[i - 1], builder.hanging[i],
                          builder.knots[i]);
    }
    builder.plan.join(builder.hanging.back(), builder.banks[1], builder.knots.back());
}

/// Returns the height of the bridge at x in its initial shape, m.
float heightAt(const Builder& builder, float x) {
    for (std::size_t i = 1; i < builder.knots.size(); ++i) {
        const Vec2 a = builder.knots[i - 1], b = builder.knots[i];
        if (x <= b.x) return lerp(a.y, b.y, (x - a.x) / (b.x - a.x));
    }
    return 0.0f;
}

void dropLoads(Builder& builder, Random& random, float mass, int count) {
    float ground = 0.0f;
    for (int i = 0; i < count; ++i) {
        const float size = builder.link * random.between(0.5f, 1.2f);
        const float x = 0.5f * builder.halfSpan() * random.between(-1.0f, 1.0f);
        // The load starts above the bridge below it, and above the previous load.
        const float low = std::max(heightAt(builder, x - size), heightAt(builder, x + size));
        const float y = std::max(low, ground) + builder.thickness + size + random.between(0.0f, 0.5f);
        ground = y + size;
        builder.load({x, y}, random.below(3) == 0 ? scenes::circle(size) : scenes::box({size, 0.6f * size}),
                     mass);
    }
}

/// Adds weights on short ropes below the bridge.
void hangLoads(Builder& builder, Random& random, float mass, int count) {
    const auto links = static_cast<std::uint32_t>(builder.hanging.size());
    for (int i = 0; i < count; ++i) {
        const std::uint32_t place = 1 + random.below(links - 1);
        Vec2 from = builder.knots[place];
        std::uint32_t above = builder.hanging[place];
        for (int part = 0; part < 2; ++part) {
            const Vec2 to = from + Vec2{0.0f, -builder.link};
            const std::uint32_t rope = builder.rod(from, to);
            builder.plan.join(above, rope, from);
            builder.hanging.push_back(rope);
            above = rope;
            from = to;
        }
        const float size = 0.4f * builder.link;
        // Attached at its center: attached at an edge it would rock, and drag does not damp rotation.
        const std::uint32_t weight =
            builder.body(from, 0.0f, scenes::box({size, size}), builder.material(kLoads, 0), mass);
        builder.plan.join(above, weight, from);
    }
}

/// Adds a net: nodes in rows and columns, connected by massless rods.
void net(Builder& builder, int rows) {
    const std::size_t columns = builder.knots.size();
    const auto tie = [&](std::uint32_t a, std::uint32_t b) {
        JointSetup rod{.kind = scenes::JointKind::Rod, .a = handleOf(a), .b = handleOf(b)};
        rod.length = distance(builder.plan.bodies[a].setup.position, builder.plan.bodies[b].setup.position);
        builder.plan.joints.push_back(rod);
    };
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const Vec2 at = builder.knots[column] + Vec2{0.0f, -builder.link * static_cast<float>(row)};
            builder.hanging.push_back(builder.body(at, 0.0f, scenes::circle(0.5f * builder.thickness),
                                                   builder.material(kLinks, kLoads), builder.linkMass));
            const std::uint32_t node = builder.hanging.back();
            if (row == 0 && (column == 0 || column + 1 == columns))
                builder.plan.join(builder.banks[column == 0 ? 0 : 1], node, at);
            if (column > 0) tie(builder.hanging[builder.hanging.size() - 2], node);
            if (row > 0) tie(builder.hanging[builder.hanging.size() - 1 - columns], node);
        }
    }
}

/// Adds a cart that drives from one bank to the other.
void drive(Builder& builder, Random& random, float mass) {
    const float radius = random.between(0.35f, 0.5f), base = random.between(1.6f, 2.4f);
    const float speed = random.between(1.5f, 3.0f);
    const Vec2 start{-builder.halfSpan() - base, radius + 0.5f * builder.thickness};
    const std::uint32_t chassis =
        builder.load(start + Vec2{0.0f, 0.1f}, scenes::box({0.5f * base, 0.15f}), 0.6f * mass);
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 at = start + Vec2{0.5f * side * base, 0.0f};
        const std::uint32_t wheel = builder.load(at, scenes::circle(radius), 0.2f * mass);
        // The traction of both wheels together suffices for a slope of 40 degrees.
        builder.plan.join(
            chassis, wheel, at,
            {.driven = true, .speed = -speed / radius, .maxForce = 0.35f * mass * 10.0f * radius});
    }
    builder.plan.closed = false;
    const auto far = static_cast<double>(builder.halfSpan());
    builder.plan.seconds =
        3.0 + 1.3 * (2.0 * far + 2.0 * static_cast<double>(base)) / static_cast<double>(speed);
    builder.plan.goals.push_back({"crosses",
                                  [chassis, far](const Stage& stage) {
                                      return takesPart(stage, chassis) ? far - stage.positionOf(chassis).x
                                                                       : 0.0;
                                  },
                                  0.0});
}

/// Goal: no load is below the lowest body of the bridge.
Goal nothingFallsThrough(const Builder& builder) {
    return {"nothing falls through",
            [hanging = builder.hanging, loads = builder.loads](const Stage& stage) {
                double low = 0.0, below = 0.0;
                for (const std::uint32_t body : hanging)
                    if (takesPart(stage, body)) low = std::min(low, stage.positionOf(body).y);
                for (const std::uint32_t body : loads)
                    below += takesPart(stage, body) && stage.positionOf(body).y < low ? 1.0 : 0.0;
                return below;
            },
            0.0};
}

}  // namespace

Blueprint makeRopeBridge(Random& random) {
    Builder builder;
    const auto kind = random.below(4);
    const bool isNet = kind == 2, isRoad = kind == 3;
    builder.link = random.between(0.4f, 1.0f);
    builder.thickness = builder.link * random.between(0.15f, 0.3f);
    builder.friction = random.between(0.6f, 0.9f);
    builder.linkMass = 0.5f * std::pow(40.0f, random.unit());  // 0.5 to 20 kg
    const int links = isNet ? 4 + static_cast<int>(random.below(5)) : 8 + static_cast<int>(random.below(17));
    const float mass = builder.linkMass * std::pow(isRoad ? 20.0f : 100.0f, random.unit());
    builder.plan.seconds = 12.0;
    const float radius =
        hang(builder, links, isRoad ? random.between(0.3f, 0.5f) : random.between(0.6f, 2.2f));
    constexpr float kGravity = 10.0f;
    if (radius < kGravity) builder.drag = std::sqrt(kGravity / radius) * random.between(1.2f, 1.8f);
    const int loads = 1 + static_cast<int>(random.below(3));
    if (isNet) {
        net(builder, 2 + static_cast<int>(random.below(3)));
        const float x = 0.25f * builder.halfSpan() * random.between(-1.0f, 1.0f);
        const float size = builder.link * random.between(0.8f, 1.4f);
        builder.load({x, size + random.between(0.1f, 0.5f)}, scenes::circle(size), mass);
    } else {
        bridge(builder);
        if (kind == 0) dropLoads(builder, random, mass, loads);
        if (kind == 1) hangLoads(builder, random, mass, loads);
        if (isRoad) drive(builder, random, mass);
    }
    Blueprint& plan = builder.plan;
    plan.goals.push_back(nothingFallsThrough(builder));
    plan.goals.push_back(keepsJoints(0.05 * static_cast<double>(builder.link)));
    if (builder.drag > 0.0f) {
        plan.goals.push_back(rests(builder.hanging, 0.05));
        plan.goals.push_back(rests(builder.loads, 0.05));
    }
    return std::move(builder.plan);
}

}  // namespace plumb::families
