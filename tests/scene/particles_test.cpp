#include "scene/particles.hpp"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "math/angle.hpp"
#include "reflect/type_registry.hpp"
#include "render/recording_device.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/components/scene_physics.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/particle_system.hpp"
#include "tests/support/allocations.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr float kDt = 1.0f / 60.0f;

/// An emitter without random spread: all particles are equal.
ParticleEmitter plain() {
    ParticleEmitter emitter;
    emitter.lifetimeSpread = emitter.spread = emitter.speedSpread = emitter.sizeSpread = 0.0f;
    emitter.drag = 0.0f;
    emitter.gravity = 1.0f;
    return emitter;
}

/// An emitter that emits a single particle at the first tick.
ParticleEmitter single() {
    ParticleEmitter emitter = plain();
    emitter.rate = 0.0f;
    emitter.burst = 1;
    emitter.loop = false;
    emitter.lifetime = 10.0f;
    return emitter;
}

struct ParticleScene : testing::Test {
    TypeRegistry types;
    World world{types};

    ParticleScene() {
        registerSceneComponents(types);
        world.addSystem<ParticleSystem>();
    }

    Entity add(const ParticleEmitter& emitter, Vec2 place = {100.0f, 50.0f}) {
        Entity entity = world.createEntity();
        entity.addComponent<Transform>(place);
        entity.addComponent<ParticleEmitter>(emitter);
        return entity;
    }
    static void run(World& world, int ticks) {
        for (int i = 0; i < ticks; ++i) {
            world.beginTick();
            storePreviousTransforms(world);
            world.update(kDt);
        }
    }
    void run(int ticks) { run(world, ticks); }
    Particles& particles() { return world.resource<Particles>(); }
    [[nodiscard]] Vec2 place(std::size_t i = 0) { return {particles().x[i], particles().y[i]}; }
};

TEST_F(ParticleScene, withoutAnEmitterNothingIsCreatedAndNoBitChanges) {
    World without{types};
    for (World* each : {&world, &without}) each->createEntity().addComponent<Transform>();
    run(world, 10);
    run(without, 10);
    EXPECT_EQ(world.findResource<Particles>(), nullptr);
    EXPECT_EQ(world.hash(), without.hash());

    Entity emitter = add(plain());
    run(30);
    EXPECT_GT(particles().alive(), 0u);
    emitter.destroy();
    run(1);
    EXPECT_EQ(particles().alive(), 0u);
    EXPECT_TRUE(particles().streams.empty());
}

TEST_F(ParticleScene, theNumberAliveIsRateTimesLifetime) {
    ParticleEmitter emitter = plain();
    emitter.rate = 200.0f;
    emitter.lifetime = 1.5f;
    const Entity even = add(emitter);
    emitter.lifetimeSpread = 0.8f;
    const Entity spread = add(emitter);
    run(60);
    EXPECT_NEAR(particles().find(even)->count, 200.0, 1.0) << "no particle has ended yet";
    run(240);
    for (int i = 0; i < 20; ++i) {
        run(7);
        EXPECT_NEAR(particles().find(even)->count, 300.0, 4.0);
        EXPECT_NEAR(particles().find(spread)->count, 300.0, 40.0);
    }
}

TEST_F(ParticleScene, aParticleFollowsTheExactParabola) {
    world.createEntity().addComponent<ScenePhysics>().gravity = {20.0f, 600.0f};
    ParticleEmitter emitter = single();
    emitter.direction = radiansFromDegrees(-60.0f);
    emitter.speed = 300.0f;
    emitter.gravity = 0.5f;
    add(emitter);
    for (int tick = 1; tick <= 240; ++tick) {
        run(1);
        const double t = tick / 60.0;
        ASSERT_NEAR(place().x, 100.0 + 150.0 * t + 0.5 * 10.0 * t * t, 0.02) << tick;
        ASSERT_NEAR(place().y, 50.0 - 300.0 * std::sqrt(0.75) * t + 0.5 * 300.0 * t * t, 0.02) << tick;
    }
}

TEST_F(ParticleScene, dragFollowsItsFormula) {
    for (const double drag : {0.001, 0.5, 3.0, 40.0}) {
        SCOPED_TRACE(drag);
        ParticleEmitter emitter = single();
        emitter.direction = 0.0f;
        emitter.speed = 200.0f;
        emitter.drag = static_cast<float>(drag);
        const Entity entity = add(emitter, {});
        run(90);
        const double t = 1.5;
        const double kept = std::exp(-drag * t);
        EXPECT_NEAR(place().x, 200.0 * (1.0 - kept) / drag, 0.05);
        EXPECT_NEAR(place().y, 980.0 / drag * (t - (1.0 - kept) / drag), 0.2);
        world.destroy(entity);
        run(1);
    }
}

TEST_F(ParticleScene, worldSpaceParticlesStayAndLocalOnesMoveWithTheEmitter) {
    ParticleEmitter emitter = single();
    emitter.speed = emitter.gravity = 0.0f;
    const Entity world0 = add(emitter, {});
    emitter.space = ParticleSpace::Local;
    const Entity local = add(emitter, {});
    run(1);
    for (const Entity entity : {world0, local}) entity.get<Transform>().position = {500.0f, 0.0f};
    run(2);
    const auto first = [&](Entity entity) { return particles().x[particles().find(entity)->first]; };
    EXPECT_EQ(first(world0), 0.0f);
    EXPECT_EQ(first(local), 0.0f) << "local: distance from the emitter, px";
}

TEST_F(ParticleScene, aMovingEmitterLeavesNoGapsBetweenTicks) {
    ParticleEmitter emitter = plain();
    emitter.rate = 600.0f;
    emitter.speed = emitter.gravity = 0.0f;
    const Entity entity = add(emitter, {});
    run(1);
    for (int i = 0; i < 10; ++i) {
        world.beginTick();
        storePreviousTransforms(world);
        entity.get<Transform>().position.x += 100.0f;
        world.update(kDt);
    }
    const ParticleStream& stream = *particles().find(entity);
    for (std::uint32_t i = 12; i < stream.count; ++i)
        EXPECT_NEAR(particles().x[i] - particles().x[i - 1], 10.0f, 0.1f) << i;
}

TEST_F(ParticleScene, particlesStartInsideTheEmissionShape) {
    ParticleEmitter emitter = plain();
    emitter.rate = 6000.0f;
    emitter.speed = emitter.gravity = 0.0f;
    emitter.area = EmitterArea::Box;
    emitter.areaSize = {40.0f, 10.0f};
    const Entity box = add(emitter, {});
    emitter.area = EmitterArea::Circle;
    emitter.areaRadius = 30.0f;
    const Entity circle = add(emitter, {});
    run(8);
    float wide = 0.0f;
    float far = 0.0f;
    const ParticleStream& inBox = *particles().find(box);
    const ParticleStream& inCircle = *particles().find(circle);
    for (std::uint32_t i = 0; i < inBox.count; ++i) {
        const Vec2 at = place(inBox.first + i);
        ASSERT_LE(std::abs(at.x), 20.0f);
        ASSERT_LE(std::abs(at.y), 5.0f);
        wide = std::max(wide, std::abs(at.x));
    }
    for (std::uint32_t i = 0; i < inCircle.count; ++i) {
        ASSERT_LE(length(place(inCircle.first + i)), 30.001f);
        far = std::max(far, length(place(inCircle.first + i)));
    }
    EXPECT_GT(wide, 19.0f);
    EXPECT_GT(far, 29.0f);
}

TEST_F(ParticleScene, burstsOccurAtTheStartOfEachCycleAndAfterRestarting) {
    ParticleEmitter emitter = plain();
    emitter.rate = 0.0f;
    emitter.burst = 50;
    emitter.duration = 0.5f;
    emitter.lifetime = 0.3f;
    emitter.loop = true;
    const Entity loops = add(emitter);
    emitter.loop = false;
    const Entity once = add(emitter);
    run(1);
    EXPECT_EQ(particles().find(loops)->count, 50u);
    EXPECT_EQ(particles().find(once)->count, 50u);
    run(25);
    EXPECT_EQ(particles().find(loops)->count, 0u) << "all particles of the first burst have ended";
    run(6);
    EXPECT_EQ(particles().find(loops)->count, 50u) << "the next cycle emits a burst";
    EXPECT_EQ(particles().find(once)->count, 0u);
    once.get<ParticleEmitter>().playing = false;
    run(1);
    once.get<ParticleEmitter>().playing = true;
    run(1);
    EXPECT_EQ(particles().find(once)->count, 50u);
}

TEST_F(ParticleScene, theNumberOfParticlesIsLimited) {
    ParticleEmitter emitter = plain();
    emitter.rate = 5000.0f;
    emitter.burst = 700;
    emitter.maximum = 400;
    const Entity entity = add(emitter);
    for (int i = 0; i < 100; ++i) {
        run(1);
        ASSERT_LE(particles().alive(), 400u);
    }
    entity.get<ParticleEmitter>().maximum = 100;
    run(1);
    EXPECT_EQ(particles().alive(), 100u);
    entity.get<ParticleEmitter>().maximum = 900;
    run(30);
    EXPECT_EQ(particles().alive(), 900u) << "the limit may be raised later";
}

TEST_F(ParticleScene, aPrewarmedEmitterIsFullFromTheFirstTick) {
    ParticleEmitter emitter = plain();
    emitter.rate = 100.0f;
    emitter.lifetime = 2.0f;
    emitter.prewarm = true;
    const Entity warm = add(emitter);
    emitter.prewarm = false;
    const Entity cold = add(emitter);
    run(1);
    EXPECT_NEAR(particles().find(warm)->count, 200.0, 3.0);
    EXPECT_LE(particles().find(cold)->count, 2u);
    run(200);
    EXPECT_NEAR(particles().find(warm)->count, 200.0, 3.0);
}

TEST_F(ParticleScene, aSnapshotRestoresEveryBitAlsoInAnotherWorld) {
    ParticleEmitter emitter;
    emitter.rate = 300.0f;
    emitter.burst = 20;
    add(emitter);
    emitter.space = ParticleSpace::Local;
    add(emitter, {-40.0f, 7.0f});
    run(100);
    const Snapshot saved = world.save();
    const std::uint64_t then = world.hash();
    run(77);
    const std::uint64_t later = world.hash();
    EXPECT_NE(then, later);

    world.restore(saved);
    EXPECT_EQ(world.hash(), then);
    run(77);
    EXPECT_EQ(world.hash(), later);

    World other{types};
    other.addSystem<ParticleSystem>();
    other.restore(saved);
    run(other, 77);
    EXPECT_EQ(other.hash(), later);
}

TEST_F(ParticleScene, particlesDependOnlyOnThePersistentId) {
    const auto hashOf = [&](std::uint64_t id, int others) {
        World one{types};
        one.addSystem<ParticleSystem>();
        for (int i = 0; i < others; ++i) one.createEntity();
        Entity entity = one.createEntity();
        entity.addComponent<Transform>();
        entity.addComponent<SceneEntity>().id = id;
        entity.addComponent<ParticleEmitter>();
        run(one, 40);
        const Particles& particles = one.resource<Particles>();
        Hasher hasher;
        for (std::uint32_t i = 0; i < particles.streams[0].count; ++i)
            hasher.add(particles.x[i]), hasher.add(particles.velocityY[i]);
        return hasher.value();
    };
    EXPECT_EQ(hashOf(77, 0), hashOf(77, 5)) << "not on the index of the entity";
    EXPECT_NE(hashOf(77, 0), hashOf(78, 0));
}

TEST_F(ParticleScene, addingAndRemovingEmittersDoesNotAffectOthers) {
    Random random{7};
    std::vector<Entity> emitters;
    const auto& particles = world.resource<Particles>();
    const auto placesOf = [&](Entity emitter) {
        std::vector<float> places;
        const ParticleStream* stream = particles.find(emitter);
        if (stream == nullptr) return places;
        for (std::uint32_t i = 0; i < stream->count; ++i) {
            places.push_back(particles.x[stream->first + i]);
            places.push_back(particles.spin[stream->first + i]);
        }
        return places;
    };
    std::size_t compared = 0;
    for (int round = 0; round < 200; ++round) {
        for (std::uint32_t come = random.below(4); come > 0; --come) {
            ParticleEmitter emitter;
            emitter.rate = random.between(0.0f, 300.0f);
            emitter.spinSpread = 1.0f;
            emitters.push_back(add(emitter));
        }
        for (std::uint32_t go = random.below(4); go > 0 && !emitters.empty(); --go) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(emitters.size()));
            emitters[at].destroy();
            emitters.erase(emitters.begin() + static_cast<std::ptrdiff_t>(at));
        }
        run(world, 1);
        if (emitters.empty()) continue;
        std::vector<std::vector<float>> before;
        for (const Entity emitter : emitters) before.push_back(placesOf(emitter));
        Entity added = add(plain());
        world.get<ParticleEmitter>(emitters.front()).maximum += 7;
        std::vector<EntityId> all{added};
        for (const Entity emitter : emitters) all.push_back(emitter);
        followEmitters(world.resource<Particles>(), world, all);
        for (std::size_t i = 0; i < emitters.size(); ++i) {
            ASSERT_EQ(placesOf(emitters[i]), before[i]) << round;
            compared += before[i].size();
        }
        added.destroy();
    }
    EXPECT_GT(compared, 1000u);
}

TEST_F(ParticleScene, allocatesOnlyForANewMaximumOfParticles) {
    std::vector<Entity> emitters;
    for (int i = 0; i < 10; ++i) emitters.push_back(add(plain()));
    run(world, 30);
    auto& particles = world.resource<Particles>();
    const std::vector<EntityId> some{emitters[1], emitters[4], emitters[9]};
    const std::vector<EntityId> all{emitters.begin(), emitters.end()};
    const std::size_t before = test::allocations().made;
    followEmitters(particles, world, some);
    EXPECT_EQ(particles.streams.size(), 3u);
    followEmitters(particles, world, all);
    EXPECT_EQ(particles.streams.size(), 10u);
    EXPECT_EQ(test::allocations().made, before);
}

TEST_F(ParticleScene, aSteadyTickAllocatesNothing) {
    ParticleEmitter emitter;
    emitter.rate = 900.0f;
    emitter.burst = 30;
    for (int i = 0; i < 20; ++i) add(emitter);
    run(200);
    const std::size_t before = test::allocations().made;
    run(120);
    EXPECT_EQ(test::allocations().made, before);
}

/// Draws a scene with emitters and inspects the draw list.
struct ParticlePictures : ParticleScene {
    AssetStore assets{{}, test::sourceFolder() / "assets"};
    RecordingDevice device;
    SceneRenderer renderer{device, assets};
    DrawList list;

    void look(float alpha) {
        SceneView how;
        how.alpha = alpha;
        how.view = {.center = {100.0f, 50.0f}, .size = {4000.0f, 4000.0f}};
        list.begin(how.view);
        renderer.collect(world, how, list);
    }
};

TEST_F(ParticlePictures, particlesAreInterpolatedAlongTheParabola) {
    ParticleEmitter emitter = single();
    emitter.speed = 400.0f;
    add(emitter);
    run(31);
    for (const float alpha : {0.0f, 0.25f, 0.5f, 1.0f}) {
        look(alpha);
        ASSERT_EQ(list.instances().size(), 1u);
        const double t = (30.0 + double{alpha}) / 60.0;
        EXPECT_NEAR(list.instances()[0].center.y, 50.0 - 400.0 * t + 490.0 * t * t, 0.01) << alpha;
    }
}

TEST_F(ParticlePictures, curvesAndColorsFollowTheLife) {
    ParticleEmitter emitter = single();
    emitter.lifetime = 1.0f;
    emitter.size = 10.0f;
    emitter.sizeOverLife = Curve::line(1.0f, 3.0f);
    emitter.opacityOverLife = Curve::line(1.0f, 0.0f);
    emitter.colorStart = {200, 0, 100, 255};
    emitter.colorEnd = {0, 100, 100, 255};
    emitter.blend = ParticleBlend::Normal;
    add(emitter);
    run(30);
    look(1.0f);
    ASSERT_EQ(list.instances().size(), 1u);
    const SpriteInstance& half = list.instances()[0];
    EXPECT_NEAR(half.half.x, 10.0f, 0.1f);
    EXPECT_NEAR(half.tint.r, 100, 2);
    EXPECT_NEAR(half.tint.g, 50, 2);
    EXPECT_EQ(half.tint.b, 100);
    EXPECT_NEAR(half.tint.a, 127, 2);
    EXPECT_EQ(half.slot & kSpriteAdditive, 0u);
    run(31);
    look(1.0f);
    EXPECT_TRUE(list.instances().empty()) << "the particle's lifetime is over";
}

TEST_F(ParticlePictures, localParticlesAreTransformedWithTheirEmitter) {
    ParticleEmitter emitter = single();
    emitter.space = ParticleSpace::Local;
    emitter.gravity = 0.0f;
    emitter.direction = 0.0f;
    emitter.speed = 60.0f;
    const Entity entity = add(emitter, {10.0f, 20.0f});
    Transform& transform = entity.get<Transform>();
    transform.rotation = transform.previousRotation = radiansFromDegrees(90.0f);
    transform.scale = transform.previousScale = {2.0f, 2.0f};
    run(60);
    look(1.0f);
    ASSERT_EQ(list.instances().size(), 1u);
    EXPECT_NEAR(list.instances()[0].center.x, 10.0f, 0.01f);
    EXPECT_NEAR(list.instances()[0].center.y, 20.0f + 2.0f * 60.0f, 0.01f);
    EXPECT_NEAR(list.instances()[0].rotation, radiansFromDegrees(90.0f), 1e-5f);
}

TEST_F(ParticlePictures, particlesWithOneTextureAreOneDrawCall) {
    ParticleEmitter emitter;
    emitter.rate = 400.0f;
    for (int i = 0; i < 5; ++i) add(emitter, {static_cast<float>(i) * 30.0f, 0.0f});
    run(60);
    look(1.0f);
    EXPECT_EQ(list.items().size(), 5u) << "one item for each emitter";
    EXPECT_GT(list.instances().size(), 1000u);
    renderer.renderer().draw(list, {.width = 400, .height = 400});
    ASSERT_EQ(device.spriteDraws.size(), 1u);
    EXPECT_EQ(device.spriteDraws[0].instances.size(), list.instances().size());
    EXPECT_EQ(device.spriteDraws[0].instances[3].center, list.instances()[3].center);
}

TEST_F(ParticlePictures, invisibleParticlesAreNotDrawn) {
    ParticleEmitter emitter = plain();
    emitter.speed = emitter.gravity = 0.0f;
    add(emitter, {100.0f, 50.0f});
    add(emitter, {9000.0f, 50.0f});
    run(30);
    look(1.0f);
    EXPECT_EQ(list.items().size(), 1u);
    EXPECT_GT(list.culledCount(), 10u);
    EXPECT_EQ(list.instances().size() + list.culledCount(), particles().alive());
}

}  // namespace
}  // namespace plumb
