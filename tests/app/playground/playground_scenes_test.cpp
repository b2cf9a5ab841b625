#include <cmath>
#include <cstdlib>
#include <map>

#include "core/text.hpp"
#include "tests/app/playground/playground.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

constexpr int kTicks = 600;

/// Scripted input of a tick: pushes to the right, jumps, drags a body with the mouse, triggers an explosion.
InputFrame handsAt(int tick) {
    InputFrame frame;
    frame.set(Key::Right, tick % 150 > 60);
    frame.set(Key::Space, tick % 90 == 45);
    if (tick % 200 > 140) {
        frame.mouseButtons = 1;
        frame.mouseX = static_cast<std::int16_t>(640 + tick % 97);
        frame.mouseY = static_cast<std::int16_t>(420 - tick % 53);
    }
    return frame;
}

void expectFinite(Playground& play) {
    for (auto [entity, transform, body] :
         std::as_const(play.game.world).query<const Transform, const RigidBody>()) {
        ASSERT_TRUE(isFinite(transform.position) && std::isfinite(transform.rotation));
        ASSERT_TRUE(isFinite(body.velocity) && std::isfinite(body.angularVelocity));
    }
    const physics::World& world = play.physics().world;
    for (const SoftLinkage& soft : play.physics().softBodies) {
        for (const physics::SoftParticle& particle : physics::particlesOf(world, soft.body))
            ASSERT_TRUE(isFinite(positionInPixels(particle.place, play.physics().scale)));
    }
    ASSERT_TRUE(world.quarantined.empty());
}

bool touchesAnything(Playground& play) {
    const physics::World& world = play.physics().world;
    if (world.contacts.size() > 0 || world.joints.size() > world.joints.free.size()) return true;
    for (auto [entity, body] : std::as_const(play.game.world).query<const RigidBody>()) {
        if (body.grounded) return true;  // bodies asleep have no contacts
    }
    return false;
}

TEST(PlaygroundScenes, tenSecondsOfEachStayFiniteWithContacts) {
    for (const std::string& scene : galleryScenes()) {
        SCOPED_TRACE(scene);
        Playground play{scene};
        int inTouch = 0;
        for (int tick = 0; tick < kTicks; ++tick) {
            play.frame = handsAt(tick);
            play.run(1);
            inTouch += touchesAnything(play) ? 1 : 0;
            ASSERT_NO_FATAL_FAILURE(expectFinite(play)) << "tick " << tick;
        }
        EXPECT_GT(inTouch, kTicks / 2) << "too few ticks with a contact or joint";
        EXPECT_EQ(play.game.world.reports().count(), 0u);
    }
}

TEST(PlaygroundScenes, restoringEverySeventhTickChangesNothing) {
    for (const std::string& scene : galleryScenes()) {
        SCOPED_TRACE(scene);
        Playground play{scene};
        Snapshot snapshot;
        for (int tick = 0; tick < kTicks; ++tick) {
            const bool goesBack = tick % 7 == 6;
            if (goesBack) play.game.world.save(snapshot);
            play.frame = handsAt(tick);
            play.run(1);
            if (!goesBack) continue;
            const std::uint64_t first = play.game.world.hash();
            play.game.world.restore(snapshot);
            play.run(1);
            ASSERT_EQ(play.game.world.hash(), first) << "tick " << tick;
        }
    }
}

/// tests/replay/playground.hashes has a line "scene hash" for each scene, as printed by plumb-player --frames
/// 600 --hash. UPDATE_GOLDEN=1 writes the file; the commit must name the change of the scenes or of the
/// simulation that caused it.
TEST(PlaygroundScenes, goldenHashesAreThoseOfEveryMachine) {
    const Path file = test::sourceFolder() / "tests/replay/playground.hashes";
    std::string text;
    for (const std::string& scene : galleryScenes()) {
        Playground play{scene};
        play.run(kTicks);
        text += scene + " " + hexText(play.game.world.hash()) + "\n";
    }
    if (std::getenv("UPDATE_GOLDEN") != nullptr) {
        ASSERT_TRUE(writeFile(file, text));
        return;
    }
    const Result<std::string> golden = readFile(file);
    ASSERT_TRUE(golden.ok());
    EXPECT_EQ(text, *golden);
}

/// Bodies on jellies rock and roll for a while and then come to rest: contacts must not add energy.
TEST(PlaygroundScenes, bodiesOnSoftBodiesComeToRest) {
    constexpr float kSlow = 1.0f;      // px/s
    constexpr float kTurning = 0.05f;  // rad/s
    Playground play{"softbodies"};
    play.run(1200);
    for (int tick = 0; tick < 300; ++tick) {
        play.run(1);
        for (auto [entity, body] : std::as_const(play.game.world).query<const RigidBody>()) {
            ASSERT_LT(length(body.velocity), kSlow) << tick;
            ASSERT_LT(std::fabs(body.angularVelocity), kTurning) << tick;
        }
    }
}

TEST(PlaygroundScenes, everySceneIsReachableByMenuAndKeys) {
    const auto current = [](Playground& play) {
        const std::string path = play.game.world.resource<LoadedScenes>().scenes.front().path;
        return path.substr(7, path.find('.') - 7);
    };
    const auto press = [](Playground& play, Key key) {
        play.hold(key, 1);
        play.run(1);
    };
    const std::vector<std::string> scenes = galleryScenes();
    std::map<std::string, int> reached;
    for (std::size_t item = 0; item < scenes.size(); ++item) {
        Playground play{""};
        play.run(2);
        for (std::size_t i = 0; i < item; ++i) press(play, Key::Down);
        press(play, Key::Enter);
        ++reached[current(play)];
        press(play, Key::Escape);
        EXPECT_EQ(current(play), "menu");
    }
    EXPECT_EQ(reached.size(), scenes.size());

    Playground play{scenes.front()};
    reached.clear();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        ++reached[current(play)];
        press(play, Key::N);
    }
    EXPECT_EQ(reached.size(), scenes.size());
    EXPECT_EQ(current(play), scenes.front());
    press(play, Key::B);
    press(play, Key::N);
    EXPECT_EQ(current(play), scenes.front());
}

TEST(PlaygroundScenes, pauseStopsTheSceneAndResetRestartsIt) {
    Playground play{"pyramid"};
    const Vec2 start = play.at("your ball");
    play.run(10);
    EXPECT_GT(play.at("your ball").y, start.y + 10.0f);
    play.hold(Key::P, 1);
    play.run(1);
    EXPECT_EQ(play.game.world.resource<LoadedScenes>().scenes.size(), 2u);
    const Vec2 paused = play.at("your ball");
    play.run(60);
    EXPECT_EQ(play.at("your ball"), paused);
    play.hold(Key::P, 1);
    play.run(5);
    EXPECT_GT(play.at("your ball").y, paused.y);
    play.hold(Key::R, 1);
    EXPECT_LT(length(play.at("your ball") - start), 2.0f);
}

}  // namespace
}  // namespace plumb
