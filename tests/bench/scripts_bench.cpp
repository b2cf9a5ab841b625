// Times of scripts beside plain Lua that does the same with tables. The goals are those of the specification
// of scripts, on the reference machine.

#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/scripts_stage.hpp"
#include "tests/support/temporary_folder.hpp"

namespace plumb::bench {
namespace {

constexpr double kMicrosecond = 1e3;  // ns
constexpr double kMillisecond = 1e6;  // ns

// ---- the table

/// The rows that were asked for.
class Table {
public:
    explicit Table(const Options& options) : options_{options} {
        std::printf("%-40s %8s %10s %10s %10s %7s %10s\n", "", "n", "us", "median", "plain Lua", "ratio",
                    "goal");
    }

    [[nodiscard]] bool wants(std::string_view name) const {
        return options_.rest.empty() || name.find(options_.rest[0]) != std::string_view::npos;
    }
    /// Races a stage with plain Lua, which may be missing, and prints the row.
    /// @param goal  of one run, ns
    void add(const std::string& name, std::size_t n, const Contestant& stage, const Contestant& plain,
             double goal = 0.0) {
        if (!wants(name)) return;
        std::vector<Contestant> contestants{stage};
        if (plain.run) contestants.push_back(plain);
        const std::vector<Timing> timings = race(contestants, options_);
        last_ = {name, n, timings[0].minimum * 1e9, timings[0].median * 1e9, 0.0, goal};
        if (plain.run) last_.limitNs = timings[1].minimum * 1e9;
        lastPlainMedian_ = plain.run ? timings[1].median * 1e9 : 0.0;
        add(last_);
    }
    /// Adds what the last row costs above plain Lua, for each of its n.
    void addDifference(const std::string& name, double goal) {
        if (rows_.empty() || !wants(name)) return;
        const auto n = static_cast<double>(last_.n);
        add(Row{name, 1, (last_.ns - last_.limitNs) / n, (last_.median - lastPlainMedian_) / n, 0.0, goal});
    }
    [[nodiscard]] int finish() const {
        return options_.jsonPath.empty() || writeRows(options_.jsonPath, rows_) ? 0 : 1;
    }

private:
    void add(const Row& row) {
        const auto us = [](double ns) { return ns == 0.0 ? std::string{"-"} : fixedText(ns / 1e3, 2); };
        std::printf("%-40s %8zu %10s %10s %10s %7s %10s  %s\n", row.name.c_str(), row.n, us(row.ns).c_str(),
                    us(row.median).c_str(), us(row.limitNs).c_str(),
                    row.limitNs > 0.0 ? fixedText(row.ns / row.limitNs, 1).c_str() : "-",
                    us(row.target).c_str(),
                    row.target == 0.0 ? ""
                    : row.met()       ? "met"
                                      : "MISSED");
        std::fflush(stdout);
        rows_.push_back(row);
    }

    const Options& options_;
    std::vector<Row> rows_;
    Row last_;
    double lastPlainMedian_ = 0.0;
};

/// "scripts/thing.lua", whose functions are those of the table Thing.
ScriptStage::Texts thing(const std::string& functions, const std::string& properties = "") {
    return {{"thing", "local Thing = script {" + properties + "}\n" + functions + "\nreturn Thing"}};
}

/// Plain Lua with `count` tables whose functions are those of the table Thing, and a function tick().
std::string plainThings(const std::string& functions, std::size_t count, const std::string& properties = "") {
    return format(R"(
        local Thing = { } Thing.__index = Thing
        {}
        local things = { }
        for i = 1, {} do
            things[i] = setmetatable({
                transform = { x = i % 100, y = 0, position = { x = i % 100, y = 0 } }, {} }, Thing)
            if Thing.onCreate then things[i]:onCreate() end
        end
        function tick() for i = 1, #things do things[i]:onTick(1 / 60) end end
    )",
                  functions, count, properties);
}

/// A row for a tick of a stage beside the function tick() of plain Lua.
/// @param goal  of one run, ns; 0: none
void addTicks(Table& table, const std::string& name, std::size_t n, ScriptStage& stage, PlainLua& plain,
              double goal = 0.0) {
    stage.tick();
    table.add(name, n, {{}, [&] { stage.tick(); }}, {{}, [&] { plain.call("tick"); }}, goal);
    if (stage.complaints() != 0) std::printf("    a script failed\n");
}

/// A row for entities with the same script, with the same functions in plain Lua.
void addThings(Table& table, const std::string& name, std::size_t n, std::size_t entities,
               const std::string& functions, const std::string& properties, double goal) {
    if (!table.wants(name)) return;
    ScriptStage stage{thing(functions, properties)};
    stage.add("Thing", entities);
    PlainLua plain{plainThings(functions, entities, properties)};
    addTicks(table, name, n, stage, plain, goal);
}

// ---- handlers and fields

void addTicks(Table& table, std::size_t count) {
    addThings(table, "empty onTick", count, count, "function Thing:onTick() end", "", 0.0);
    if (table.wants("empty onTick")) table.addDifference("empty onTick, above Lua's call", 500.0);
    addThings(table, "move and turn by properties", count, count, R"(
        function Thing:onTick(dt)
            local x = self.transform.x + self.speed * dt
            if x < self.left or x > self.right then self.speed = -self.speed end
            self.transform.x = x
        end
    )",
              "speed = 40, left = 0, right = 100", 2 * kMillisecond);
}

/// One handler that does something many times.
struct Access {
    const char* name;
    const char* before;
    const char* what;
};
constexpr Access kAccesses[] = {
    {"read self.transform.x", "", "sum = sum + self.transform.x"},
    {"write self.transform.x", "", "self.transform.x = i"},
    {"read a property", "", "sum = sum + self.speed"},
    {"write a property", "", "self.speed = i"},
    {"read self.transform.position", "", "p = self.transform.position"},
    {"write self.transform.position", "p = self.transform.position", "self.transform.position = p"},
    {"read x of a local Transform", "local t = self.transform", "sum = sum + t.x"},
    {"write x of a local Transform", "local t = self.transform", "t.x = i"},
};

void addAccesses(Table& table, std::size_t count) {
    for (const Access& access : kAccesses) {
        const std::string handler =
            format("function Thing:onTick() local sum, p = 0 {} for i = 1, {} do {} end end", access.before,
                   count, access.what);
        addThings(table, access.name, count, 1, handler, "speed = 1", kMillisecond);
    }
}

// ---- coroutines and snapshots

constexpr const char* kWaiting = R"(
    function Thing:onCreate()
        local visited = {}
        while true do
            local place = { x = math.random(100), y = math.random(100), name = "place " .. self.count }
            visited[self.count % 4 + 1] = place
            self.count = self.count + 1
            wait(0.1 + math.random() * 0.4)
        end
    end
)";
constexpr const char* kPlainWaiting = R"(
    local Thing, threads, left = { }, { }, { }
    local function wait(seconds) coroutine.yield(math.ceil(seconds * 60)) end
    {}
    for i = 1, {} do threads[i], left[i] = coroutine.create(Thing.onCreate), 1 end
    local things = { }
    for i = 1, #threads do things[i] = { count = 0 } end
    function tick()
        for i = 1, #threads do
            left[i] = left[i] - 1
            if left[i] == 0 then
                local ok, ticks = assert(coroutine.resume(threads[i], things[i]))
                left[i] = ticks
            end
        end
    end
)";

void addCoroutines(Table& table, std::size_t count) {
    if (!table.wants("coroutines that wait")) return;
    ScriptStage stage{thing(kWaiting, "count = 0")};
    stage.add("Thing", count);
    PlainLua plain{format(kPlainWaiting, kWaiting, count)};
    for (int i = 0; i < 600; ++i) stage.tick(), plain.call("tick");
    table.add("coroutines that wait", count, {{}, [&] { stage.tick(); }}, {{}, [&] { plain.call("tick"); }});
    const std::size_t bytes = stage.stateBytes();
    const double goal = 0.1 * kMillisecond * static_cast<double>(bytes) / 500e3;
    // Beside them: a copy of as many bytes.
    std::vector<std::byte> from(bytes);
    std::vector<std::byte> to(bytes);
    const Contestant copy{{}, [&] {
                              std::memcpy(to.data(), from.data(), bytes);
                              keep(to.data());
                          }};
    Snapshot snapshot = stage.world().save();
    std::printf("    Lua state: %zu bytes; plain: a copy of so many bytes\n", bytes);
    table.add("coroutines that wait: save", bytes, {{}, [&] { stage.world().save(snapshot); }}, copy, goal);
    table.add("coroutines that wait: restore", bytes, {{}, [&] { stage.world().restore(snapshot); }}, copy,
              goal);
    if (stage.complaints() != 0) std::printf("    a script failed\n");
}

// ---- functions of the engine

void addEvents(Table& table, std::size_t count) {
    const std::string name = "emit to 10 handlers";
    if (!table.wants(name)) return;
    ScriptStage stage{
        {{"thing",
          "local Thing = script { sum = 0 } function Thing:onEvent_hit(by) self.sum = by end "
          "return Thing"},
         {"source", format("local Source = script { } function Source:onTick() for i = 1, {} do "
                           "emit('hit', i) end end return Source",
                           count)}}};
    stage.add("Thing", 10);
    stage.add("Source", 1);
    PlainLua plain{format(R"(
        local events, things = { }, { }
        for i = 1, 10 do things[i] = { sum = 0, onEvent_hit = function(self, by) self.sum = by end } end
        function tick()
            for i = 1, {} do events[i] = { name = "hit", by = i } end
            for i = 1, #events do
                for j = 1, #things do
                    local handler = things[j]["onEvent_" .. events[i].name]
                    if handler then handler(things[j], events[i].by) end
                end
            end
        end
    )",
                          count)};
    addTicks(table, name, count, stage, plain);
}

void addQuery(Table& table, std::size_t count) {
    const std::string name = "world:query of 1 component";
    if (!table.wants(name)) return;
    ScriptStage stage{{{"thing", "local Thing = script {} return Thing"},
                       {"seeker",
                        "local Seeker = script { found = 0 } function Seeker:onTick() self.found = "
                        "#world:query('Thing') end return Seeker"}}};
    stage.add("Thing", count);
    stage.add("Seeker", 1);
    PlainLua plain{format(R"(
        local all = { }
        for i = 1, {} do all[i] = { Thing = { } } end
        function tick()
            local found = { }
            for i = 1, #all do if all[i].Thing then found[#found + 1] = all[i] end end
            return #found
        end
    )",
                          count)};
    addTicks(table, name, count, stage, plain);
}

void addSpawn(Table& table, std::size_t count) {
    const std::string name = "spawn of entities with scripts";
    if (!table.wants(name)) return;
    ScriptStage stage{
        {{"thing",
          "local Thing = script { age = 0 } function Thing:onCreate() self.age = 1 end return Thing"},
         {"source", format("local Source = script { } function Source:onTick() for i = 1, {} do "
                           "spawn('prefabs/thing', vec(i, 0)) end end return Source",
                           count)}}};
    stage.prefabs().add("prefabs/thing.prefab.json",
                        R"({"format": 1, "entities": [{"id": "0000000000000001", "name": "thing",
                            "components": {"Transform": {}, "Thing": {}}}]})");
    PlainLua plain{format(R"(
        local Thing = { } Thing.__index = Thing
        function Thing:onCreate() self.age = 1 end
        local things
        function clear() things = { } end
        function tick()
            for i = 1, {} do things[i] = setmetatable({ transform = { x = i, y = 0 }, age = 0 }, Thing) end
            for i = 1, #things do things[i]:onCreate() end
        end
    )",
                          count)};
    const auto clear = [&] {
        stage.world().clear();
        stage.tick();
        stage.add("Source", 1);
    };
    // Two ticks: the scripts of spawned entities begin in the next one.
    const auto spawn = [&] {
        stage.tick();
        stage.world().remove(stage.type("Source"), stage.world().entities()[0]);
        stage.tick();
    };
    table.add(name, count, {clear, spawn}, {[&] { plain.call("clear"); }, [&] { plain.call("tick"); }});
    if (stage.complaints() != 0) std::printf("    a script failed\n");
}

// ---- files

/// A script of some 60 lines.
std::string longScript(std::size_t number, std::size_t version) {
    std::string text =
        format("local Actor{} = script { speed = {}, count = 0, target = entity { } }\n", number, version);
    for (int i = 0; i < 8; ++i)
        text += format(R"(
function Actor{}:step{}(dt)
    local best, length = nil, 0
    for j = 1, 10 do
        if j % 2 == 0 and self.speed > j then length = length + j * dt else best = j end
    end
    self.count = self.count + 1
    return best, length
end
)",
                       number, i);
    return text + format("return Actor{}\n", number);
}

void addLoads(Table& table, std::size_t count) {
    if (!table.wants("load script files") && !table.wants("reload one of them")) return;
    const test::TemporaryFolder folder{test::memoryFolder()};
    std::filesystem::create_directories(folder.path / "scripts");
    std::vector<std::string> texts;
    const auto write = [&](std::size_t number, std::size_t version) {
        std::ofstream{folder.path / "scripts" / format("actor{}.lua", number)} << longScript(number, version);
    };
    for (std::size_t i = 0; i < count; ++i) {
        write(i, 1);
        texts.push_back("local function entity() end local function script(t) return t end " +
                        longScript(i, 1));
    }
    PlainLua plain{""};
    std::unique_ptr<ScriptStage> stage;
    const auto load = [&] {
        stage->read(folder.path);
        for (std::size_t i = 0; i < count; ++i) stage->add(format("Actor{}", i), 1);
        stage->tick();
    };
    table.add("load script files", count, {[&] { stage = std::make_unique<ScriptStage>(); }, load},
              {{},
               [&] {
                   for (const std::string& text : texts) plain.run(text);
               }},
              100 * kMillisecond);
    stage = std::make_unique<ScriptStage>();
    load();
    std::size_t version = 1;
    const auto reload = [&] {
        stage->read(folder.path);
        stage->tick();
    };
    table.add("reload one of them", 1, {[&] { write(0, ++version); }, reload},
              {{}, [&] { plain.run(texts[0]); }}, 100 * kMillisecond);
    if (stage->complaints() != 0) std::printf("    a script failed\n");
}

// ---- what never ends

struct Runaway {
    const char* name;
    const char* handler;
};
constexpr Runaway kRunaways[] = {
    {"runaway: empty loop", "while true do end"},
    {"runaway: fields", "while true do self.transform.x = self.transform.x + 1 end"},
    {"runaway: vectors",
     "while true do self.transform.position = (self.transform.position + vec(1, 0)) * 0.5 end"},
    {"runaway: calls", "local function again() return again() end again()"},
    {"runaway: tables", "local t while true do t = { t } if #t > 5 then break end t = {} end"},
    {"runaway: queries", "while true do local a = #world:query('Thing', 'Transform') end"},
    {"runaway: texts", "local s = '' while true do s = ('x'):rep(1000) .. 'y' end"},
    {"runaway: events", "while true do emit('hit', 1) end"},
};

void addRunaways(Table& table) {
    for (const Runaway& runaway : kRunaways) {
        if (!table.wants(runaway.name)) continue;
        ScriptStage stage{thing(format("function Thing:onTick() {} end", runaway.handler))};
        stage.add("Thing", 1);
        const TypeInfo& type = stage.type("Thing");
        const EntityId entity = stage.world().entities()[0];
        const auto goOn = [&] { *static_cast<bool*>(stage.world().find(type, entity)) = false; };
        int stopped = 0;
        const auto run = [&] {
            stage.tick();
            if (*static_cast<const bool*>(stage.world().find(type, entity))) ++stopped;
        };
        table.add(runaway.name, 1, {goOn, run}, {}, 100 * kMillisecond);
        if (stopped == 0) std::printf("    it was not stopped\n");
    }
}

}  // namespace

int runScripts(const Options& options) {
    const std::size_t entities = options.quick ? 100 : 1000;
    Table table{options};
    addTicks(table, entities);
    addAccesses(table, options.quick ? 1000 : 10000);
    addCoroutines(table, options.quick ? 30 : 300);
    addEvents(table, options.quick ? 100 : 1000);
    addQuery(table, entities);
    addSpawn(table, 100);
    addLoads(table, options.quick ? 5 : 50);
    addRunaways(table);
    return table.finish();
}

}  // namespace plumb::bench
