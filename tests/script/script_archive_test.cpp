#include "script/script_archive.hpp"

#include "core/text.hpp"
#include "ecs/paused.hpp"
#include "tests/script/script_world.hpp"

namespace plumb {
namespace {

/// Scripts that are saved and loaded again in the same world.
class ScriptArchive : public ScriptWorld {
protected:
    [[nodiscard]] std::string saved() {
        std::string bytes = world.toBytes(problems);
        EXPECT_TRUE(problems.empty()) << problems[0].text();
        return bytes;
    }
    void load(const std::string& bytes) {
        const Result<Snapshot> snapshot = world.snapshotFrom(bytes, problems);
        ASSERT_TRUE(snapshot) << snapshot.error().text();
        ASSERT_TRUE(problems.empty()) << problems[0].text();
        world.restore(*snapshot);
    }
    /// Adds a Thing, saves it after 5 ticks and plays on, then loads it and runs one tick more.
    /// @return its `sum` then
    int sumAfterLoading() {
        EXPECT_TRUE(problems.empty()) << problems[0].text();
        const EntityId entity = add("Thing");
        run(5);
        const std::string bytes = saved();
        run(7);
        load(bytes);
        run();
        EXPECT_EQ(logText(), "");
        return property<int>(entity, "sum");
    }
    EntityId named(const std::string& name) {
        const EntityId entity = world.createEntity().id();
        world.add<Transform>(entity);
        world.add<Name>(entity, Name{world.texts().add(name)});
        return entity;
    }
};

// A chain of `count` nodes with random pairs besides. The table `marks` of a node has nodes as keys, of which
// `marked` is a list, as pairs() refuses such keys, and components of the entities V1 to V8. The test
// destroys V2, V4, V6 and V8.
constexpr const char* kRandomTables = R"(
local Thing = script { seed = integer { 1 }, count = integer { 1 }, same = integer { 0 } }

local function nodesOf(first)
    local nodes, node = {}, first
    while node do
        nodes[#nodes + 1] = node
        node = node.next
        if node == first then break end
    end
    return nodes
end

local function textOf(value)
    if type(value) == "table" then return "node " .. value.id end
    if value == nil then return "nothing" end
    if type(value) == "number" or type(value) == "string" or type(value) == "boolean" then
        return type(value) .. " " .. tostring(value)
    end
    return "handle"
end

local function describe(first)
    local lines, handles = {}, {}
    for which = 1, 7, 2 do handles[#handles + 1] = findEntity("V" .. which).transform end
    for _, node in ipairs(nodesOf(first)) do
        local pairsOf = {}
        for key, value in pairs(node) do
            if key ~= "marks" and key ~= "marked" then
                pairsOf[#pairsOf + 1] = textOf(key) .. " = " .. textOf(value)
            end
        end
        table.sort(pairsOf)
        for _, key in ipairs(node.marked) do
            pairsOf[#pairsOf + 1] = textOf(key) .. " marks " .. textOf(node.marks[key])
        end
        for which, handle in ipairs(handles) do
            pairsOf[#pairsOf + 1] = "V" .. which .. " marks " .. textOf(node.marks[handle])
        end
        lines[#lines + 1] = table.concat(pairsOf, ", ")
    end
    return table.concat(lines, "\n")
end

function Thing:onCreate()
    local state = self.seed
    local function below(limit)
        state = (state * 1103515245 + 12345) % 2147483648
        return state // 65536 % limit + 1
    end
    self.kept = {}  -- an entity that is not referred to has another handle later
    for which = 1, 8 do self.kept[which] = findEntity("V" .. which) end
    local nodes = {}
    for i = 1, self.count do nodes[i] = { id = i, marks = {}, marked = {} } end
    for i = 1, self.count - 1 do nodes[i].next = nodes[i + 1] end
    if below(2) == 1 then nodes[self.count].next = nodes[1] end
    for i = 1, self.count do
        local node, other = nodes[i], nodes[below(self.count)]
        local kind = below(6)
        if kind == 1 then node.other = other
        elseif kind <= 3 then
            node.marked[1] = other
            node.marks[other] = kind == 2 and below(100) or nodes[below(self.count)]
        elseif kind == 4 then node[below(10) / 4] = below(2) == 1
        elseif kind == 5 then
            for which = 1, 8 do node.marks[findEntity("V" .. which).transform] = below(100) end
        end
        node[below(5)] = vec(i, 2)
    end
    self.first = nodes[1]
    self.expected = describe(self.first)
end

function Thing:onLoad()
    self.same = #nodesOf(self.first) == self.count and describe(self.first) == self.expected and 1 or 2
end
return Thing)";

TEST_F(ScriptArchive, keepsRandomTablesOfAnyDepth) {
    use({{"thing", kRandomTables}});
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const TypeInfo& type = *types.find("Thing");
    const auto setProperty = [&](EntityId entity, const char* name, int value) {
        std::memcpy(type.find(name)->in(world.find(type, entity)), &value, sizeof value);
    };
    for (const int count : {1, 2, 3, 10, 99, 100, 101, 300, 1500, 2500}) {
        std::vector<EntityId> entities;
        for (int i = 1; i <= 8; ++i) entities.push_back(named(format("V{}", i)));
        const EntityId entity = add("Thing");
        setProperty(entity, "seed", 7 * count + 1);
        setProperty(entity, "count", count);
        run();
        for (std::size_t i = 1; i < entities.size(); i += 2) world.destroy(entities[i]);
        run();
        const std::string bytes = saved();
        run(3);
        load(bytes);
        run();
        EXPECT_EQ(property<int>(entity, "same"), 1) << count << " nodes";
        EXPECT_EQ(logText(), "");
        entities.push_back(entity);
        for (const EntityId each : entities)
            if (world.alive(each)) world.destroy(each);
        run();
    }
}

TEST_F(ScriptArchive, losesOnlyThePairOfAKeyThatIsGone) {
    const EntityId other = named("V1");
    const EntityId entity = thing(R"(
        local marks = {}
        function Thing:onCreate()
            self.marks = { [findEntity("V1").transform] = { 1, 2 }, a = 10, b = 20, c = 30 }
            for i = 1, 50 do marks["mark" .. i] = i end
            self.after = { 1, 2, 3 }
        end
        function Thing:onLoad()
            self.count = 0
            for _, mark in pairs(marks) do self.count = self.count + mark end
            for _, mark in pairs(self.marks) do self.count = self.count + mark end
            self.count = self.count + #self.after
        end)",
                                  "count = integer { 0 }");
    run();
    world.destroy(other);
    run();
    load(saved());
    run();
    EXPECT_EQ(property<int>(entity, "count"), 50 * 51 / 2 + 60 + 3);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptArchive, keepsScriptsBesideFilesWithoutAComponent) {
    const std::string library = R"(
local library = { count = 0 }
function library.add() library.count = library.count + 1 return library.count end
return library)";
    use({{"before", library},
         {"thing", R"(
local before, later = require "before", require "zlater"
local Thing = script { sum = integer { 0 } }
local own = 0
function Thing:onTick()
    own = own + 1
    self.sum = own * 10000 + before.add() * 100 + later.add()
end
return Thing)"},
         {"unused", library},
         {"zlater", library}});
    EXPECT_EQ(sumAfterLoading(), 60606);
}

// Where functions and variables of scripts are, see docs/shipping.md: each adds to `sum` in a way of its own.
TEST_F(ScriptArchive, keepsVariablesOfFunctionsThatOthersCall) {
    use({{"score", R"(
local total = 0
local score = { points = { each = 1 } }
function score.add() total = total + score.points.each return total end
return score)"},
         {"thing", R"(
local score = require "score"
local Thing = script { sum = integer { 0 } }
local n = 0
local function add() n = n + 1 return n end
local function addDeeper() return add() end
Thing.total = 0
helpers = {}
function helpers.add() calls = (calls or 0) + 1 return calls end
function Thing:onTick()
    Thing.total = Thing.total + 1
    score.points.each = 1
    self.sum = addDeeper() * 1000000 + Thing.total * 10000 + score.add() * 100 + helpers.add()
end
return Thing)"}});
    EXPECT_EQ(sumAfterLoading(), 6060606);
}

constexpr const char* kStates = R"(
local Thing = script { sum = integer { 0 } }
local Ball = { speed = 2 }
Ball.__index = Ball
function Ball:move() self.x = self.x + self.speed end
local states = {
    idle = { enter = function(self) self.sum = self.sum + 1 return "run" end },
    run = { enter = function(self) self.sum = self.sum + 100 return "run" end }
}
local update = nil
local function slow(self) self.sum = self.sum + 10000 end
local function fast(self) self.sum = self.sum + 1000000 end
function Thing:onTick()
    self.state = self.state or states.idle
    self.state = states[self.state.enter(self)]
    self.round = self.round or math.floor
    self.input = self.input or input
    self.ball = self.ball or setmetatable({ x = 0 }, Ball)
    self.ball:move()
    update = update and fast or slow
    update(self)
    assert(self.round(1.5) == 1 and self.input == input and not self.input:isPressed("Jump"))
    assert(self.state == states.run and self.ball.x % 2 == 0 and getmetatable(self.ball) == Ball)
end
return Thing)";

TEST_F(ScriptArchive, keepsFunctionsOfFilesWhereverTheyAre) {
    use({{"thing", kStates}});
    ASSERT_TRUE(problems.empty()) << problems[0].text();
    const EntityId entity = add("Thing");
    for (const int ticks : {1, 2, 5}) {
        run(ticks);
        const int sum = property<int>(entity, "sum");
        const std::string bytes = saved();
        run(3);
        const int after = property<int>(entity, "sum");
        load(bytes);
        ASSERT_EQ(property<int>(entity, "sum"), sum);
        run(3);
        EXPECT_EQ(property<int>(entity, "sum"), after);
        EXPECT_EQ(logText(), "");
    }
}

TEST_F(ScriptArchive, addsFunctionsOfALaterVersionToTablesOfAnEarlierOne) {
    constexpr const char* kText = R"(
local Thing = script { sum = integer { 0 } }
local states = { idle = { enter = function(self) self.sum = self.sum + 1 end }, list = { 1, 2, 3 } NEW }
function Thing:onTick()
    table.remove(states.list)
    states.idle.enter(self)
    if states.run then states.run.enter(self) states.idle.leave(self) end
    self.sum = self.sum + 1000 * #states.list
end
return Thing)";
    const auto with = [&](std::string_view added) {
        std::string text{kText};
        text.replace(text.find("NEW"), 3, added);
        use({{"thing", text}});
        ASSERT_TRUE(problems.empty()) << problems[0].text();
    };
    with("");
    const EntityId entity = add("Thing");
    run();
    EXPECT_EQ(property<int>(entity, "sum"), 2001);
    const std::string bytes = saved();
    with(R"(, run = { enter = function(self) self.sum = self.sum + 10 end } }
            states.idle.leave = function(self) self.sum = self.sum + 100 end
            local other = { 1 )");
    load(bytes);
    run();
    EXPECT_EQ(property<int>(entity, "sum"), 2001 + 111 + 1000);
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptArchive, callsOnLoadOnceWhenTheScriptMayRun) {
    const EntityId paused = thing(R"(
        function Thing:onTick() assert(not self.ticks or self.loads > 0) self.ticks = 1 end
        function Thing:onLoad() self.loads = self.loads + 1 end)",
                                  "loads = integer { 0 }");
    const EntityId free = add("Thing");
    const EntityId destroyed = add("Thing");
    std::string bytes;
    for (const int ticksBefore : {1, 0, 5}) {  // also saved again while onLoad was not called yet
        run(ticksBefore);
        if (bytes.empty()) world.add<Paused>(paused);
        if (bytes.empty()) world.add<Paused>(destroyed);
        bytes = saved();
        load(bytes);
    }
    run(3);
    EXPECT_EQ(property<int>(free, "loads"), 2) << "once for each load that a tick followed";
    EXPECT_EQ(property<int>(paused, "loads"), 0);
    const Snapshot waiting = world.save();
    for (int i = 0; i < 2; ++i) {
        world.remove<Paused>(paused);
        run();
        EXPECT_EQ(property<int>(paused, "loads"), 1) << "also from a snapshot";
        run(3);
        EXPECT_EQ(property<int>(paused, "loads"), 1);
        EXPECT_TRUE(world.resource<ScriptState>().hasLoaded);
        world.destroy(destroyed);
        run(2);
        EXPECT_FALSE(world.resource<ScriptState>().hasLoaded) << "nothing is searched any more";
        if (i == 0) world.restore(waiting);
    }
    EXPECT_EQ(logText(), "");
}

TEST_F(ScriptArchive, namesScriptsThatWaitAndWillNotGoOn) {
    thing(R"(
        function Thing:onCreate() wait(1) end
        function Thing:onTick() waitFor("never") end)");
    add("Thing");
    run();
    static_cast<void>(saved());
    EXPECT_EQ(logText(),
              "saved game: Thing waits, and functions that wait are not saved: it will not go on; add "
              "Thing:onLoad(), which begins again what it needs\n");
}

TEST_F(ScriptArchive, changesNothingWhenItSaves) {
    thing(R"(
        function Thing:onCreate()
            self.list = {}
            for i = 1, 1000 do self.list = { self.list } end
        end)");
    run();
    const std::size_t bytes = world.resource<ScriptState>().memory.bytes();
    for (int i = 0; i < 3; ++i) static_cast<void>(saved());
    EXPECT_EQ(world.resource<ScriptState>().memory.bytes(), bytes);
}

TEST_F(ScriptArchive, saysThatThereIsNoMemoryToSaveIn) {
    const EntityId entity = thing(R"(
        function Thing:onTick()
            for i = 1, 50000 do self.list = { self.list } end
        end)");
    for (int i = 0; i < 100 && !property<bool>(entity, "stopped"); ++i) run();
    ASSERT_TRUE(property<bool>(entity, "stopped"));
    log.clear();
    const std::uint64_t hash = world.hash();
    static_cast<void>(world.toBytes(problems));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_NE(problems[0].where.find("ScriptState"), std::string::npos);
    EXPECT_EQ(logText(),
              "saved game: not enough memory; keep fewer values in scripts: 64 MiB are available\n");
    EXPECT_EQ(world.hash(), hash);
    run();
}

TEST_F(ScriptArchive, refusesDamageAndNeverCrashes) {
    thing(R"(
        function Thing:onCreate()
            self.list = {}
            for i = 1, 20 do self.list = { self.list, [self.list] = i, text = "a", at = vec(1, 2) } end
        end
        function Thing:onTick() self.list = { self.list } end)");
    run();
    ScriptState copy = world.resource<ScriptState>();
    std::string bytes;
    StateArchive writer = StateArchive::writer(bytes);
    copy.archive(writer);
    ASSERT_TRUE(writer.ok());
    const Snapshot before = world.save();
    for (std::size_t at = 8; at < bytes.size(); ++at) {
        std::string wrong = bytes;
        wrong[at] = static_cast<char>(wrong[at] ^ (at % 3 == 0 ? 0xff : 1));
        StateArchive reader = StateArchive::reader(wrong);
        world.resource<ScriptState>().archive(reader);
        run();
        world.restore(before);
    }
}

}  // namespace
}  // namespace plumb
