#include "script/script_list.hpp"

#include "scene/components/drawing/sprite.hpp"
#include "tests/script/script_world.hpp"

// Lists, rectangles and curves of fields, as scripts see them.

namespace plumb {
namespace {

using ScriptLists = ScriptWorld;

TEST_F(ScriptLists, areReadLikeTables) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            assert(#self.ways == 0 and self.ways[1] == nil)
            self.ways = { 10, 20, 30 }
            local ways, sum, keys = self.ways, 0, ""
            assert(#ways == 3 and ways[2] == 20 and type(ways) == "table")
            for i, way in ipairs(ways) do sum = sum + i * way end
            for i in pairs(ways) do keys = keys .. i end
            assert(sum == 140 and keys == "123")
            assert(table.concat(ways, " ") == "10.0 20.0 30.0")
            assert(select("#", table.unpack(ways)) == 3)
            self.done = true
        end
    )",
                                  "ways = list(number {}, 8), done = false");
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "done"));
}

TEST_F(ScriptLists, canBeAssignedWholeAlsoToAnotherField) {
    const EntityId entity = thing(R"(
        function Thing:onCreate()
            self.ways = { 1, 2 }
            local items = { table.unpack(self.ways) }
            table.insert(items, 3)
            self.ways = items
            self.others = self.ways
            assert(#self.others == 3 and self.others[3] == 3)
            self.ways = {}
            assert(#self.ways == 0 and #self.others == 3)
            self.sprite.source = { 1, 2, 3, 4 }
            self.sprite.source = self.sprite.source
            assert(self.sprite.source[3] == 3)
            self.done = true
        end
    )",
                                  "ways = list(number {}, 8), others = list(number {}, 8), done = false");
    world.add<Sprite>(entity);
    run();
    EXPECT_EQ(logText(), "");
    EXPECT_TRUE(property<bool>(entity, "done"));
}

TEST_F(ScriptLists, refuseChangesThatWouldBeLost) {
    thing(R"(
        function Thing:onCreate()
            self.ways = { 3, 1, 2 }
            local function refused(change)
                local ok, message = pcall(change)
                assert(not ok, "a change was accepted")
                return message
            end
            local message = refused(function() self.ways[1] = 5 end)
            local remedy = 'the value of the field "ways" is read-only; assign a whole table: ' ..
                "local items = { table.unpack(self.ways) }, change items, self.ways = items"
            assert(message == "scripts/thing.lua:10: " .. remedy, message)
            assert(refused(function() self.ways[4] = 5 end):find(remedy, 1, true))
            assert(refused(function() table.insert(self.ways, 5) end):find(remedy, 1, true))
            assert(refused(function() table.remove(self.ways) end):find(remedy, 1, true))
            assert(refused(function() table.sort(self.ways) end):find(remedy, 1, true))
            assert(refused(function() self.sprite.source[1] = 5 end):find('"source" is read-only', 1, true))
            assert(refused(function() setmetatable(self.ways, nil) end):find("protected metatable", 1, true))
            assert(self.ways[1] == 3 and #self.ways == 3)
        end
    )",
          "ways = list(number {}, 8)");
    for (auto [entity, transform] : world.query<Transform>()) entity.addComponent<Sprite>();
    run();
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptLists, ofQueriesArePlainTables) {
    thing(R"(
        function Thing:onCreate()
            local found = world:query("Transform")
            found[#found + 1] = self.entity
            table.remove(found, 1)
            assert(#found == 1)
        end
    )");
    run();
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptLists, areShownInErrors) {
    thing("function Thing:onCreate() self.ways = { 1, 2 } local ways = self.ways error('oh') end",
          "ways = list(number {}, 8)");
    run();
    ASSERT_EQ(log.size(), 1u);
    EXPECT_NE(log[0].find("ways = {1, 2}"), std::string::npos) << log[0];
}

}  // namespace
}  // namespace plumb
