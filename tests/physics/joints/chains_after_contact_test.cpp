#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "physics/workspace.hpp"
#include "tests/physics/support/joint_world.hpp"

// While a chain has contacts, the iterative solver stretches its joints by its load. When the contacts have
// ended, the direct solver closes them: for any load, without adding energy.

namespace plumb::physics {
namespace {

constexpr float kLink = 1.0f;  // m
constexpr Vec2 kBottom{0.0f, -0.5f * kLink};

/// A chain of 2 to 40 links with a load of 1 to 1000 links at its end, in any direction.
struct LoadedChain {
    JointWorld scene;
    std::vector<BodyId> bodies;
    std::vector<JointId> joints;
    BodyId load;
    float length = 0.0f;  ///< m

    /// @param held  the load is attached to the ground too
    LoadedChain(Random& random, bool held) {
        const int links = 2 + static_cast<int>(random.below(39));
        const float ratio = std::pow(10.0f, random.between(0.0f, 3.0f)), angle = random.between(-1.4f, 1.4f);
        const Vec2 along{std::sin(angle), -std::cos(angle)};
        length = kLink * static_cast<float>(links);
        BodyId above = scene.ground;
        for (int i = 0; i < links; ++i) {
            const WorldPosition middle{(static_cast<float>(i) + 0.5f) * kLink * along};
            const BodyId link = *createBody(scene.world, {.position = middle, .angle = angle});
            (void)createShape(scene.world, link, box({0.05f, 0.5f * kLink}), {.density = 10.0f, .mask = 0});
            join(above, i == 0 ? Vec2{} : kBottom, link, -kBottom);
            bodies.push_back(above = link);
        }
        load = *createBody(scene.world, {.position = WorldPosition{length * along}});
        (void)createShape(scene.world, load, circle(0.5f), {.density = ratio / (0.25f * kPi)});
        join(above, kBottom, load, {});
        bodies.push_back(load);
        if (held) join(scene.ground, length * along, load, {});
    }

    void join(BodyId a, Vec2 anchorA, BodyId b, Vec2 anchorB) {
        joints.push_back(scene.join({.a = a, .b = b, .anchorA = anchorA, .anchorB = anchorB}));
    }
    /// Adds a crate that hits the load, or a wall in its path.
    BodyId obstruct(Random& random) {
        const Vec2 speed = velocityOf(scene.world, load), at = scene.place(load);
        const float weight = random.between(0.1f, 1.0f) * massOf(scene.world, load);
        const bool isWall = random.below(3) == 0 && plumb::length(speed) > 0.1f;
        const Vec2 apart =
            isWall ? 1.2f / plumb::length(speed) * speed : Vec2{random.between(-0.3f, 0.3f), 1.3f};
        const BodyId obstacle =
            *createBody(scene.world, {.kind = isWall ? BodyKind::Static : BodyKind::Dynamic,
                                      .position = WorldPosition{at + apart},
                                      .velocity = speed + Vec2{0.0f, -random.between(1.0f, 10.0f)}});
        (void)createShape(scene.world, obstacle, box({0.5f, 0.5f}), {.density = weight});
        return obstacle;
    }
    /// Lets it touch an obstacle for a random time. @return true if the iterative solver solved it meanwhile
    bool touch(Random& random) {
        scene.run(0.5f);
        const BodyId obstacle = obstruct(random);
        bool touched = false;
        for (std::uint32_t left = 30 + random.below(60); left-- > 0;) {
            scene.run(JointWorld::kDt);
            touched = touched || !scene.world.work.get().joints.trees.some;
        }
        destroyBody(scene.world, obstacle);
        return touched;
    }
    struct Gaps {
        float widest = 0.0f;  ///< m
        float sum = 0.0f;     ///< m
    };
    Gaps gaps() const {
        Gaps gaps;
        for (const JointId joint : joints) {
            const float gap = plumb::length(scene.gapOf(joint));
            gaps = {std::max(gaps.widest, gap), gaps.sum + gap};
        }
        return gaps;
    }
    double energy() const {
        double sum = 0.0;
        for (const BodyId body : bodies) sum += scene.energyOf(body);
        return sum;
    }
    /// Energy that lifts it by a height, J.
    double liftBy(float height) const {
        double mass = 0.0;
        for (const BodyId body : bodies) mass += static_cast<double>(massOf(scene.world, body));
        return mass * static_cast<double>(JointWorld::kGravity * height);
    }
};

TEST(ChainsAfterContact, closeTheirJointsWithoutAddingEnergy) {
    int touched = 0, opened = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random = Random::seeded(seed);
        const bool held = seed % 4 == 0;
        LoadedChain chain{random, held};
        touched += chain.touch(random) ? 1 : 0;
        const Settings& settings = chain.scene.world.settings;
        const LoadedChain::Gaps gaps = chain.gaps();
        opened += gaps.widest > settings.slop ? 1 : 0;
        // Gaps move no body faster than pushSpeed, and the load of a bent chain more slowly than its links.
        const float longest = 0.5f + 2.0f * gaps.sum / settings.pushSpeed;
        const double maximum = chain.energy() + chain.liftBy(gaps.sum + 0.02f * chain.length);
        float closed = gaps.widest > settings.slop ? 1.0e9f : 0.0f;
        double energy = chain.energy();
        for (float time = JointWorld::kDt; time < longest + 1.0f; time += JointWorld::kDt) {
            chain.scene.run(JointWorld::kDt);
            if (chain.gaps().widest <= settings.slop) closed = std::min(closed, time);
            energy = std::max(energy, chain.energy());
        }
        EXPECT_LE(closed, longest) << gaps.widest;
        EXPECT_LT(energy, maximum) << held;
    }
    EXPECT_GE(touched, 190);
    EXPECT_GE(opened, 60);
}

}  // namespace
}  // namespace plumb::physics
