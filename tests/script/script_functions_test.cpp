#include "ecs/hierarchy.hpp"
#include "gameplay/game_requests.hpp"
#include "gameplay/label_values.hpp"
#include "input/input.hpp"
#include "scene/components/bodies/rigid_body.hpp"
#include "scene/components/colliders/box_collider.hpp"
#include "scene/components/drawing/camera.hpp"
#include "scene/components/tags.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

using ScriptFunctions = ScriptWorld;

TEST_F(ScriptFunctions, findEntitiesByTagAndPath) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            assert(#findEntities("enemy") == 2 and findEntities("enemy")[1]:hasTag("enemy"))
            assert(#findEntities("friend") == 0 and not self.entity:hasTag("enemy"))
            assert(findEntity("Anna/Bob") == findEntities("enemy")[1])
            assert(findEntity("Anna/Bob"):parent() == self.entity)
            self.done = true
        end
    )",
                                  "done = false");
    for (const char* name : {"Bob", "Carl"}) {
        const EntityId enemy = world.createEntity().id();
        world.add<Name>(enemy, Name{world.texts().add(name)});
        world.add<Tags>(enemy).words.push(textId("enemy"));
        setParent(world, enemy, entity);
    }
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "done"));
}

TEST_F(ScriptFunctions, emitToOneEntity) {
    const EntityId first = thing(R"(
        function Thing:onCreate() if self.target then self.target:emit("hit", 3) end end
        function Thing:onEvent_hit(by) self.hits = self.hits + by end
    )",
                                 "target = entity {}, hits = 0");
    const EntityId second = add("Thing");
    const EntityId third = add("Thing");
    std::memcpy(types.find("Thing")->find("target")->in(world.find(*types.find("Thing"), first)), &second,
                sizeof second);
    run(2);
    EXPECT_EQ(property<float>(second, "hits"), 3.0f);
    EXPECT_EQ(property<float>(first, "hits") + property<float>(third, "hits"), 0.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptFunctions, pushBodiesAndShakeTheCamera) {
    const EntityId entity = thing(R"(
        function Thing:onCreate() applyImpulse(self, vec(10, -4)) shakeCamera(8, 0.5) end
    )");
    RigidBody& body = world.add<RigidBody>(entity, 2.0f);
    body.gravityScale = 0.0f;
    body.linearDrag = 0.0f;
    const EntityId camera = world.createEntity().id();
    world.add<Camera>(camera);
    run();
    EXPECT_EQ(world.get<RigidBody>(entity).velocity, (Vec2{5.0f, -2.0f}));
    EXPECT_EQ(world.get<Camera>(camera).shakeStrength, 8.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptFunctions, refuseSlotsThatDoNotExistWhateverTheirSize) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            for _, slot in ipairs { 0, -1, 33, 4294967297, 4294967295, -4294967295, math.mininteger,
                                    math.maxinteger } do
                saveGame(slot)
                loadGame(slot)
                assert(not hasSave(slot))
            end
            assert(hasSave(1) and hasSave() and hasSave(32))
            self.done = true
        end
    )",
                                  "done = false");
    InputFrame frame;
    frame.saves = 0xffffffff;
    world.resource<Input>().advance(frame);
    run();
    EXPECT_TRUE(property<bool>(entity, "done")) << logText();
    EXPECT_EQ(world.resource<GameRequests>().save, 0);
    EXPECT_EQ(world.resource<GameRequests>().load, 0);
    EXPECT_NE(logText().find("saveGame(33): saved games have the slots 1 to 32"), std::string::npos)
        << logText();
}

TEST_F(ScriptFunctions, castRaysWithFilters) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            local function hit(filter) return castRay(vec(0, 0), vec(100, 0), filter) end
            if not hit() then return end
            local wall = findEntity("wall")
            assert(hit().entity == wall and hit().normal == vec(-1, 0))
            assert(hit(wall) == nil and hit({ except = wall }) == nil)
            assert(hit({ mask = 1 }).entity == wall and hit({ mask = 2 }) == nil)
            assert(hit({ triggers = true }).entity == findEntity("trigger"))
            self.done = true
        end
    )",
                                  "done = false");
    const auto box = [&](const char* name, float x, bool isTrigger) {
        const EntityId made = world.createEntity().id();
        world.add<Name>(made, Name{world.texts().add(name)});
        world.add<Transform>(made, x, -5.0f);
        world.add<BoxCollider>(made, 10.0f, 10.0f).isTrigger = isTrigger;
    };
    box("trigger", 20.0f, true);
    box("wall", 40.0f, false);
    run(3);
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "done"));
}

TEST_F(ScriptFunctions, showWholeNumbersWithoutAFraction) {
    thing(R"(function Thing:onCreate() showText("a", 3.0) showText("b", 2.5) showText("c", "x") end)");
    run();
    const LabelValues& values = world.resource<LabelValues>();
    ASSERT_NE(values.find("a"), nullptr);
    EXPECT_EQ(*values.find("a"), "3");
    EXPECT_EQ(*values.find("b"), "2.5");
    EXPECT_EQ(*values.find("c"), "x");
}

TEST_F(ScriptFunctions, tweenPropertiesOfTheScriptItself) {
    const EntityId entity = thing(R"(
        function Thing:onCreate() tween(self, { speed = 10 }, 0.5, "linear") end
    )",
                                  "speed = 0");
    run(40);
    EXPECT_EQ(property<float>(entity, "speed"), 10.0f);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptFunctions, knowPositionsInTheWorld) {
    const EntityId entity = thing(R"(
        function Thing:onTick() self.at = worldPosition(self) end
    )",
                                  "at = vec(0, 0)");
    const EntityId parent = world.createEntity().id();
    world.add<Transform>(parent, 100.0f, 50.0f);
    world.get<Transform>(entity).position = {1.0f, 2.0f};
    setParent(world, entity, parent);
    run();
    EXPECT_EQ(property<Vec2>(entity, "at"), (Vec2{101.0f, 52.0f}));
}

TEST_F(ScriptFunctions, changeFieldsGradually) {
    const EntityId entity = thing(R"(
        function Thing:onCreate() tween(self.transform, { position = vec(60, 0) }, 1, "linear") end
    )");
    run(31);
    EXPECT_NEAR(x(entity), 30.0f, 1.1f);
    run(31);
    EXPECT_EQ(x(entity), 60.0f);
}

TEST_F(ScriptFunctions, refuseUnknownActionsAndAxes) {
    thing(R"(
        function Thing:onTick()
            local ok, message = pcall(input.isHeld, input, "Shoot")
            assert(message:find('there is no action "Shoot"; project.json and the defaults have Jump', 1, true), message)
            ok, message = pcall(input.getAxis, input, "horizontal")
            assert(message:find('there is no axis "horizontal"', 1, true), message)
            assert(input:getAxis("Horizontal") == 0 and not input:isPressed("Jump"))
        end
    )");
    run();
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptFunctions, mayAskWhatADestroyedEntityHas) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            local made = world:createEntity(vec(0, 0))
            made:destroy()
            assert(not made:isAlive() and not made:has("Transform") and made:get("Transform") == nil)
            assert(made.transform == nil)
            self.done = true
        end
    )",
                                  "done = false");
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "done"));
}

}  // namespace
}  // namespace plumb
