#include "script/script_api.hpp"

#include <cstdlib>
#include <set>

#include <gtest/gtest.h>
#include <lua.hpp>

#include "core/file.hpp"
#include "core/text.hpp"
#include "script/script_functions.hpp"
#include "script/script_library.hpp"
#include "script/script_loader.hpp"
#include "script/script_memory.hpp"
#include "script/script_vector.hpp"
#include "tests/script/script_world.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

using script::ScriptFunction;

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The part of the definitions that describes a class, from its name to the next empty line.
std::string_view classIn(std::string_view definitions, std::string_view name) {
    const std::size_t at = definitions.find(format("---@class {}", name));
    if (at == std::string_view::npos) return {};
    return definitions.substr(at, definitions.find("\n\n", at) - at);
}

/// Names of the global values of a new Lua state. @param open  adds them
std::set<std::string> globalsOf(void (*open)(lua_State* state)) {
    ScriptMemory memory;
    const ScriptAccess access{memory};
    lua_State* state = access.state();
    open(state);
    std::set<std::string> names;
    lua_pushglobaltable(state);
    for (lua_pushnil(state); lua_next(state, -2) != 0; lua_pop(state, 1))
        names.insert(lua_tostring(state, -2));
    lua_pop(state, 1);
    return names;
}

std::string guide() { return *readFile(test::sourceFolder() / "docs/scripting.md"); }
std::string scriptOfTemplate(std::string_view name) {
    return *readFile(test::sourceFolder() / "assets/templates/lua/scripts" / Path{name});
}

class ScriptDefinitions : public ScriptWorld {
protected:
    void expectFunctions(std::string_view prefix, std::span<const ScriptFunction> functions) const {
        for (const ScriptFunction& function : functions) {
            EXPECT_TRUE(contains(text, format("---{}\n", function.doc))) << function.name;
            EXPECT_TRUE(contains(text, format("\nfunction {}{}(", prefix, function.name))) << function.name;
        }
    }

    std::string text = scriptDefinitions(types);
};

TEST_F(ScriptDefinitions, areValidLua) {
    use({{"thing", "return script { doc = 'Two\\nlines.', speed = number { 1, doc = 'a\\nb\\rc' } }"}});
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    text = scriptDefinitions(types);
    EXPECT_TRUE(contains(text, "---Two lines.\n---@class Thing : Script\n"));
    lua_State* state = luaL_newstate();
    EXPECT_EQ(luaL_loadstring(state, text.c_str()), LUA_OK) << lua_tostring(state, -1);
    lua_close(state);
}

TEST_F(ScriptDefinitions, haveAllFunctionsOfTheTables) {
    expectFunctions("", script::timeFunctions());
    expectFunctions("", script::gameFunctions());
    expectFunctions("Entity:", script::entityFunctions());
    expectFunctions("world:", script::worldFunctions());
    expectFunctions("input:", script::inputFunctions());
}

TEST_F(ScriptDefinitions, haveAllGlobalsThatLuaItselfHasNot) {
    const std::set<std::string> known = globalsOf(openScriptLibrary);
    std::size_t count = 0;
    for (const std::string& name : globalsOf(script::openScripts)) {
        if (known.contains(name) || name == "require") continue;
        ++count;
        const bool isTable = contains(text, format("\n{} = {}\n", name, "{}"));
        EXPECT_TRUE(isTable || contains(text, format("\nfunction {}(", name))) << name;
    }
    EXPECT_GT(count, 30u);
}

TEST_F(ScriptDefinitions, haveTheFunctionsOfVectors) {
    ScriptMemory memory;
    const ScriptAccess access{memory};
    script::openScripts(access.state());
    std::size_t count = 0;
    for (std::size_t at = text.find("function Vector:"); at != std::string::npos;
         at = text.find("function Vector:", at + 1)) {
        const std::size_t start = at + std::string_view{"function Vector:"}.size();
        const std::string name = text.substr(start, text.find('(', start) - start);
        script::pushVector(access.state(), {3.0f, 4.0f});
        EXPECT_EQ(lua_getfield(access.state(), -1, name.c_str()), LUA_TFUNCTION) << name;
        lua_pop(access.state(), 2);
        ++count;
    }
    EXPECT_EQ(count, 7u);
}

TEST_F(ScriptDefinitions, haveAllFieldsOfAllComponents) {
    for (const TypeInfo& type : types.all()) {
        const std::string_view described = classIn(text, format("{} : Component", type.name));
        EXPECT_FALSE(described.empty()) << type.name;
        for (const FieldInfo& field : type.fields) {
            const std::size_t at = described.find(format("\n---@field {} ", field.name));
            ASSERT_NE(at, std::string_view::npos) << type.name << "." << field.name;
            const std::string_view line = described.substr(at + 1, described.find('\n', at + 1) - at - 1);
            EXPECT_TRUE(contains(line, field.doc)) << line;
        }
    }
}

TEST_F(ScriptDefinitions, showTypesUnitsAndRanges) {
    const std::string_view entity = classIn(text, "Entity");
    EXPECT_TRUE(contains(entity, "\n---@field rigidBody RigidBody A dynamic body"));
    EXPECT_FALSE(contains(entity, "---@field name ")) << "entity:name() is a function";
    const std::string_view body = classIn(text, "RigidBody");
    EXPECT_TRUE(contains(body, "\n---@field velocity vec (px/s)"));
    EXPECT_TRUE(contains(body,
                         "\n---@field friction number Friction coefficient; 0 is frictionless. "
                         "(ratio, 0 to 10)"));
    const std::string_view transform = classIn(text, "Transform");
    EXPECT_TRUE(contains(transform, "\n---@field x number "));
    EXPECT_TRUE(contains(transform, "(in scripts rad, not degrees)"));
    EXPECT_TRUE(contains(classIn(text, "Label"), "\n---@field align \"left\"|\"center\"|\"right\""));
    EXPECT_TRUE(contains(classIn(text, "Sprite"), "\n---@field texture string? Image file to draw."));
    EXPECT_TRUE(contains(text, "---@param seconds? number\nfunction wait(seconds) end\n"));
    EXPECT_TRUE(contains(text, "---@param condition fun(): boolean\nfunction waitUntil(condition) end\n"));
}

TEST_F(ScriptDefinitions, haveTheScriptsOfTheProject) {
    use({{"slime",
          "return script { speed = number { 40, min = 0, unit = 'px/s', doc = 'Walks so fast.' } }"}});
    text = scriptDefinitions(types);
    EXPECT_TRUE(contains(classIn(text, "Entity"), "\n---@field slime Slime"));
    const std::string_view slime = classIn(text, "Slime");
    EXPECT_TRUE(contains(slime, "Slime : Script\n"));
    EXPECT_TRUE(contains(slime, "\n---@field speed number Walks so fast. (px/s, at least 0)"));
}

TEST_F(ScriptDefinitions, haveTheHandlers) {
    const std::string_view described = classIn(text, "Script");
    for (const char* name : {"onCreate", "onTick", "onReload", "onCollisionEnter", "onCollisionStay",
                             "onCollisionExit", "onTriggerEnter", "onTriggerStay", "onTriggerExit"})
        EXPECT_TRUE(contains(described, format("\n---@field {}? fun(self: Script", name))) << name;
}

/// UPDATE_GOLDEN=1 writes the reference into the guide.
TEST(ScriptGuide, containsTheReference) {
    std::string text = guide();
    const std::string_view begin = "<!-- reference: made by scriptReference(), a test compares it -->\n\n";
    const std::size_t from = text.find(begin);
    ASSERT_NE(from, std::string::npos);
    const std::size_t start = from + begin.size();
    const std::size_t end = text.find("<!-- end of the reference -->", start);
    ASSERT_NE(end, std::string::npos);
    if (std::getenv("UPDATE_GOLDEN") != nullptr) {
        text.replace(start, end - start, scriptReference());
        ASSERT_TRUE(writeFile(test::sourceFolder() / "docs/scripting.md", text).ok());
        return;
    }
    EXPECT_EQ(text.substr(start, end - start), scriptReference()) << "run this test with UPDATE_GOLDEN=1";
}

TEST(ScriptGuide, showsTheScriptsOfTheTemplate) {
    const std::string text = guide();
    for (const char* name : {"player.lua", "coin.lua", "score.lua"}) {
        const std::string code = scriptOfTemplate(name);
        EXPECT_GT(code.size(), 300u);
        EXPECT_TRUE(contains(text, "```lua\n" + code + "```"))
            << "copy assets/templates/lua/scripts/" << name << " into docs/scripting.md";
    }
}

/// All blocks of code in the guide, as one script each.
TEST_F(ScriptDefinitions, ofTheGuideAreScriptsWithoutErrors) {
    const std::string shown = guide();
    std::size_t count = 0;
    for (std::size_t at = shown.find("```lua\n"); at != std::string::npos;
         at = shown.find("```lua\n", at + 1)) {
        const std::size_t start = at + std::string_view{"```lua\n"}.size();
        const std::string code = shown.substr(start, shown.find("```", start) - start);
        use({{"example", code}, {"steps", "return {}"}});
        EXPECT_TRUE(problems.empty()) << code << problems[0].text();
        ++count;
    }
    EXPECT_GT(count, 5u);
}

}  // namespace
}  // namespace plumb
