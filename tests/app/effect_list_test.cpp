#include "app/effect_list.hpp"

#include <string>

#include <gtest/gtest.h>

#include "app/engine_types.hpp"
#include "ecs/world.hpp"
#include "gameplay/components/music.hpp"
#include "scene/components/box_collider.hpp"
#include "scene/components/particle_emitter.hpp"
#include "scene/components/rigid_body.hpp"
#include "scene/components/sprite.hpp"
#include "scene/components/transform.hpp"

namespace plumb {
namespace {

/// The line of the table that begins with this name.
std::string lineOf(const std::string& table, const std::string& name) {
    const std::size_t at = table.find("\n  " + name + "  ");
    return at == std::string::npos ? "" : table.substr(at + 1, table.find('\n', at + 1) - at - 1);
}

bool works(const std::string& table, const std::string& name) {
    const std::string line = lineOf(table, name);
    EXPECT_FALSE(line.empty()) << name;
    return line.find("yes") != std::string::npos;
}

TEST(EffectList, particlesWorkOnlyForAnEmitter) {
    const TypeRegistry types = engineTypes();
    World world{types};
    const std::string none = effectList(world, types);
    EXPECT_EQ(lineOf(none, "particles"), "  particles           no     nobody has ParticleEmitter");
    EXPECT_FALSE(works(none, "picture"));
    world.createEntity().addComponent<ParticleEmitter>();
    const std::string one = effectList(world, types);
    EXPECT_EQ(lineOf(one, "particles"), "  particles           yes    ParticleEmitter (1)");
    EXPECT_TRUE(works(one, "picture"));
}

TEST(EffectList, saysWhatWorksAndForWhom) {
    const TypeRegistry types = engineTypes();
    World world{types};
    Entity wall = world.createEntity();
    wall.addComponent<Transform>();
    wall.addComponent<BoxCollider>(8, 8);
    wall.addComponent<Sprite>();

    const std::string still = effectList(world, types);
    for (const char* stage : {"broad phase", "narrow phase", "solve", "finish bodies", "events"})
        EXPECT_FALSE(works(still, stage)) << stage;
    EXPECT_EQ(lineOf(still, "broad phase"),
              "  broad phase         no     BoxCollider (1), but nothing of it moves");
    EXPECT_EQ(lineOf(still, "solve"), "  solve               no     nobody has RigidBody, KinematicBody");
    EXPECT_TRUE(works(still, "picture"));
    EXPECT_FALSE(works(still, "sound"));
    EXPECT_FALSE(works(still, "spring"));

    wall.addComponent<RigidBody>();
    world.createEntity().addComponent<Music>();
    const std::string moving = effectList(world, types);
    EXPECT_EQ(lineOf(moving, "narrow phase"), "  narrow phase        yes    BoxCollider (1)");
    EXPECT_EQ(lineOf(moving, "solve"), "  solve               yes    RigidBody (1)");
    EXPECT_TRUE(works(moving, "physics"));
    EXPECT_EQ(lineOf(moving, "sound"), "  sound               yes    Music (1)");
}

}  // namespace
}  // namespace plumb
