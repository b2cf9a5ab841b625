#include "script/script_memory.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/random.hpp"
#include "ecs/world.hpp"
#include "script/script_arena.hpp"

namespace plumb {
namespace {

constexpr const char* kScript = R"(
entities = {}
local function behave(e)
  return coroutine.create(function()
    while true do
      for i = 1, e.id % 7 + 3 do e.x = e.x + e.speed; coroutine.yield() end
      e.speed = -e.speed
      e.log[#e.log + 1] = string.format("%d:%d", e.id, e.count)
      if #e.log > 20 then e.log = {} end
      e.count = e.count + 1
      local t = {}
      for k = 1, 5 do t["k" .. k] = e.x * k end
      e.t = t
    end
  end)
end
function start(count)
  for i = 1, count do
    local e = {id = i, x = i * 1.5, speed = 0.25 * (i % 5 + 1), count = 0, log = {}}
    e.run = behave(e)
    entities[i] = e
  end
end
function tick() for i = 1, #entities do assert(coroutine.resume(entities[i].run)) end end
function digest()
  local sum = 0
  for i = 1, #entities do
    local e = entities[i]
    sum = (sum * 31 + e.x * 8 + e.count + #e.log) % 2147483647
  end
  return sum
end
)";

class ScriptMemoryTest : public ::testing::Test {
protected:
    static void begin(ScriptMemory& memory, int count) {
        const ScriptAccess access{memory};
        ASSERT_TRUE(access.isNew());
        luaL_openlibs(access.state());
        ASSERT_EQ(luaL_dostring(access.state(), kScript), LUA_OK) << lua_tostring(access.state(), -1);
        lua_getglobal(access.state(), "start");
        lua_pushinteger(access.state(), count);
        ASSERT_EQ(lua_pcall(access.state(), 1, 0, 0), LUA_OK);
    }
    static void run(ScriptMemory& memory, int ticks) {
        const ScriptAccess access{memory};
        for (int i = 0; i < ticks; ++i) {
            lua_getglobal(access.state(), "tick");
            ASSERT_EQ(lua_pcall(access.state(), 0, 0, 0), LUA_OK) << lua_tostring(access.state(), -1);
        }
    }
    static double digest(ScriptMemory& memory) {
        const ScriptAccess access{memory};
        lua_getglobal(access.state(), "digest");
        EXPECT_EQ(lua_pcall(access.state(), 0, 1, 0), LUA_OK);
        const double result = lua_tonumber(access.state(), -1);
        lua_pop(access.state(), 1);
        return result;
    }
};

TEST_F(ScriptMemoryTest, aCopyBringsBackLocalsAndCoroutines) {
    ScriptMemory memory;
    begin(memory, 300);
    run(memory, 100);
    Random random = Random::seeded(1);
    for (int i = 0; i < 200; ++i) {
        const ScriptMemory saved = memory;
        const double before = digest(memory);
        const int ticks = 1 + static_cast<int>(random.below(12));
        run(memory, ticks);
        const double after = digest(memory);
        EXPECT_NE(before, after);
        memory = saved;
        EXPECT_EQ(digest(memory), before);
        run(memory, ticks);
        ASSERT_EQ(digest(memory), after) << "rollback " << i;
    }
}

TEST_F(ScriptMemoryTest, statesOfSeveralWorldsTakeTurns) {
    ScriptMemory first, second;
    begin(first, 20);
    begin(second, 30);
    ScriptMemory alone;
    begin(alone, 20);
    for (int i = 0; i < 50; ++i) run(alone, 1);
    const double expected = digest(alone);
    for (int i = 0; i < 50; ++i) {
        run(first, 1);
        run(second, 2);
    }
    EXPECT_EQ(digest(first), expected);
    EXPECT_NE(digest(second), expected);
    {
        const ScriptMemory copy = first;
        EXPECT_EQ(copy.bytes(), first.bytes());
    }
    second = first;
    EXPECT_EQ(digest(second), expected);
}

TEST_F(ScriptMemoryTest, isPartOfSnapshotsOfAWorld) {
    World world;
    begin(world.resource<ScriptMemory>(), 50);
    run(world.resource<ScriptMemory>(), 10);
    const Snapshot snapshot = world.save();
    const double then = digest(world.resource<ScriptMemory>());
    run(world.resource<ScriptMemory>(), 10);
    world.restore(snapshot);
    EXPECT_EQ(digest(world.resource<ScriptMemory>()), then);

    World other;
    other.restore(snapshot);
    run(other.resource<ScriptMemory>(), 10);
    EXPECT_NE(digest(other.resource<ScriptMemory>()), then);
    EXPECT_EQ(digest(world.resource<ScriptMemory>()), then);
}

TEST_F(ScriptMemoryTest, aStateThatFillsItsMemoryGetsAnError) {
    ScriptMemory memory;
    const ScriptAccess access{memory};
    luaL_openlibs(access.state());
    EXPECT_TRUE(luaL_dostring(access.state(), "local t = {} for i = 1, 1e9 do t[i] = {i} end"));
    EXPECT_STREQ(lua_tostring(access.state(), -1), "not enough memory");
    lua_settop(access.state(), 0);
    lua_gc(access.state(), LUA_GCCOLLECT);
    EXPECT_FALSE(luaL_dostring(access.state(), "return string.rep('x', 1 << 20)")) << "it goes on";
}

TEST(ScriptArenaTest, neverGivesMemoryTwiceAndKeepsItsContent) {
    ScriptArena& arena = ScriptArena::instance();
    arena.clear();
    Random random = Random::seeded(3);
    struct Block {
        std::byte* at;
        std::size_t size;
        std::byte value;
    };
    std::vector<Block> blocks;
    const auto check = [](const Block& block) {
        return std::all_of(block.at, block.at + block.size, [&](std::byte b) { return b == block.value; });
    };
    for (int i = 0; i < 20'000; ++i) {
        const std::uint32_t what = random.below(3);
        if (what == 0 || blocks.empty()) {
            const std::size_t size = 1 + random.below(random.below(20) == 0 ? 9000 : 300);
            auto* at = static_cast<std::byte*>(arena.allocate(nullptr, 0, size));
            ASSERT_NE(at, nullptr);
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(at) % 16, 0u);
            blocks.push_back({at, size, static_cast<std::byte>(i)});
            std::fill(at, at + size, blocks.back().value);
            continue;
        }
        Block& block = blocks[random.below(static_cast<std::uint32_t>(blocks.size()))];
        ASSERT_TRUE(check(block)) << "block " << i;
        if (what == 1) {
            arena.allocate(block.at, block.size, 0);
            block = blocks.back();
            blocks.pop_back();
        } else {
            const std::size_t size = 1 + random.below(3000);
            auto* moved = static_cast<std::byte*>(arena.allocate(block.at, block.size, size));
            ASSERT_NE(moved, nullptr);
            block.at = moved;
            block.size = std::min(block.size, size);
            ASSERT_TRUE(check(block));
            block.size = size;
            std::fill(moved, moved + size, block.value);
        }
    }
    EXPECT_TRUE(std::all_of(blocks.begin(), blocks.end(), check));
    EXPECT_EQ(arena.allocate(nullptr, 0, ScriptArena::kBytes), nullptr);
    EXPECT_EQ(arena.allocate(nullptr, 0, ScriptArena::kBytes * 4), nullptr);
    arena.clear();
}

}  // namespace
}  // namespace plumb
