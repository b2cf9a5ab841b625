#include <gtest/gtest.h>

#include "ecs/hierarchy.hpp"
#include "gameplay/game_functions.hpp"
#include "scene/components/name.hpp"
#include "scene/components/tags.hpp"

namespace plumb {
namespace {

class FindEntities : public ::testing::Test {
protected:
    Entity make(std::string_view name, Entity parent = {}) {
        const Entity entity = world.createEntity();
        entity.addComponent<Name>(Name{world.texts().add(name)});
        if (parent) setParent(world, entity, parent);
        return entity;
    }
    static void tag(Entity entity, std::initializer_list<std::string_view> words) {
        Tags& tags = entity.addComponent<Tags>();
        for (const std::string_view word : words) tags.words.push(textId(word));
    }

    World world;
};

TEST_F(FindEntities, byAPathOfNames) {
    const Entity boss = make("Boss");
    const Entity left = make("Arm", boss);
    const Entity right = make("Arm", make("Other"));
    const Entity hand = make("Hand", left);
    make("Hand", right);
    EXPECT_EQ(findEntity(world, "Boss/Arm/Hand"), hand);
    EXPECT_EQ(findEntity(world, "Boss/Arm"), left);
    EXPECT_EQ(findEntity(world, "Other/Arm"), right);
    EXPECT_FALSE(findEntity(world, "Boss/Hand")) << "not a direct child";
    EXPECT_FALSE(findEntity(world, "None/Arm"));
}

TEST_F(FindEntities, byATagInTheOrderOfCreation) {
    const Entity a = make("a");
    const Entity b = make("b");
    const Entity c = make("c");
    tag(c, {"enemy"});
    tag(a, {"flying", "enemy"});
    tag(b, {"flying"});
    EXPECT_EQ(findEntities(world, "enemy"), (std::vector<Entity>{a, c}));
    EXPECT_EQ(findEntities(world, "flying"), (std::vector<Entity>{a, b}));
    EXPECT_TRUE(findEntities(world, "swimming").empty());
    EXPECT_TRUE(hasTag(world, a, "flying"));
    EXPECT_FALSE(hasTag(world, c, "flying"));
    EXPECT_FALSE(hasTag(world, make("d"), "enemy"));
}

}  // namespace
}  // namespace plumb
