#include <algorithm>
#include <span>
#include <string>

#include <lua.hpp>

#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/paused.hpp"
#include "ecs/world.hpp"
#include "scene/physics/contact_events.hpp"
#include "script/script_entity.hpp"
#include "script/script_handlers.hpp"
#include "script/script_runner.hpp"
#include "script/script_values.hpp"
#include "script/script_vector.hpp"

// The part of ScriptRunner that calls the handlers of contacts, triggers and events.

namespace plumb {
namespace {

/// Events of one tick that scripts handle: those that handlers of events emit are handled in the same tick,
/// so this bounds events that cause one another.
constexpr std::size_t kMaxEvents = 10'000;

}  // namespace

void ScriptRunner::wakeFor(const ScriptEvent& event) {
    const std::size_t count = scripts_.waits.size();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Wait wait = scripts_.waits[i];
        const bool isMeant = wait.event == event.name && (!event.target || event.target == wait.entity);
        if (wait.event.empty() || !isMeant || isStopped(wait.type, wait.entity) ||
            world_.has<Paused>(wait.entity)) {
            scripts_.waits[kept++] = wait;
            continue;
        }
        for (std::size_t value = 0; value < event.count; ++value)
            script::pushValue(threadOf(wait.thread), world_, event.value(value));
        resumeWait(wait, event.count);
    }
    scripts_.waits.erase(scripts_.waits.begin() + static_cast<std::ptrdiff_t>(kept),
                         scripts_.waits.begin() + static_cast<std::ptrdiff_t>(count));
}

void ScriptRunner::handle(const ScriptEvent& event) {
    const std::string handler = format("onEvent_{}", world_.texts().find(event.name));
    for (std::size_t i = 0; i < scripts_.loaded.size(); ++i) {
        Loaded& script = scripts_.loaded[i];
        if (script.instances.empty()) continue;
        lua_rawgeti(state_, LUA_REGISTRYINDEX, script.table);
        const bool handles = lua_getfield(state_, -1, handler.c_str()) == LUA_TFUNCTION;
        lua_pop(state_, 2);
        if (!handles) continue;
        for (Instance& instance : script.instances) {
            if (event.target && instance.entity != event.target) continue;
            if (!mayRun(script, instance)) continue;
            for (std::size_t value = 0; value < event.count; ++value)
                script::pushValue(state_, world_, event.value(value));
            call(script, instance, handler, event.count);
        }
    }
}

namespace {

void pushContact(lua_State* state, const Contact& contact, bool isA) {
    lua_createtable(state, 0, 3);
    script::pushVector(state, isA ? contact.normal : -contact.normal);
    lua_setfield(state, -2, "normal");
    script::pushVector(state, contact.point);
    lua_setfield(state, -2, "point");
    lua_pushnumber(state, contact.impulse);
    lua_setfield(state, -2, "impulse");
}

}  // namespace

template <class Event>
void ScriptRunner::handleContacts(std::uint32_t handler, bool withContact) {
    for (std::size_t s = 0; s < scripts_.loaded.size(); ++s) {
        Loaded& script = scripts_.loaded[s];
        if ((script.handlers & handler) == 0 || script.instances.empty()) continue;
        for (std::size_t i = 0; i < world_.events<Event>().size(); ++i) {
            const Event event = world_.events<Event>()[i];
            for (const bool isA : {true, false}) {
                Instance* instance = script.find(isA ? event.a : event.b);
                if (instance == nullptr || !mayRun(script, *instance)) continue;
                script::pushEntity(state_, isA ? event.b : event.a);
                if (withContact) pushContact(state_, event, isA);
                call(script, *instance, nameOf(handler), withContact ? 2 : 1);
            }
        }
    }
}

namespace {

template <class Event>
bool hasOverlap(std::span<const Event> events, EntityId trigger, EntityId other) {
    return std::any_of(events.begin(), events.end(),
                       [&](const Event& event) { return event.trigger == trigger && event.other == other; });
}

}  // namespace

template <class Event>
void ScriptRunner::handleTriggers(std::uint32_t handler) {
    for (std::size_t s = 0; s < scripts_.loaded.size(); ++s) {
        Loaded& script = scripts_.loaded[s];
        if ((script.handlers & handler) == 0 || script.instances.empty()) continue;
        for (std::size_t i = 0; i < world_.events<Event>().size(); ++i) {
            const Event event = world_.events<Event>()[i];
            for (const bool isTrigger : {true, false}) {
                Instance* instance = script.find(isTrigger ? event.trigger : event.other);
                if (instance == nullptr || !mayRun(script, *instance)) continue;
                // Of two triggers each has an event of its own.
                if (!isTrigger && hasOverlap(world_.events<Event>(), event.other, event.trigger)) continue;
                script::pushEntity(state_, isTrigger ? event.other : event.trigger);
                call(script, *instance, nameOf(handler), 1);
            }
        }
    }
}

void ScriptRunner::handleEvents() {
    protect([&] {
        handleContacts<ContactBegan>(kOnCollisionEnter, true);
        handleContacts<ContactStayed>(kOnCollisionStay, true);
        handleContacts<ContactEnded>(kOnCollisionExit, false);
        handleTriggers<TriggerEntered>(kOnTriggerEnter);
        handleTriggers<TriggerStayed>(kOnTriggerStay);
        handleTriggers<TriggerLeft>(kOnTriggerExit);
        for (Loaded& script : scripts_.loaded) {
            if ((script.handlers & kOnDestroy) != 0) endInstances(script);
        }
        // By index, as handlers emit events too.
        std::size_t i = 0;
        for (; i < world_.events<ScriptEvent>().size() && i < kMaxEvents; ++i) {
            const ScriptEvent event = world_.events<ScriptEvent>()[i];
            wakeFor(event);
            handle(event);
        }
        if (i == kMaxEvents)
            logError(
                "Script",
                Error{format("event \"{}\"", world_.texts().find(world_.events<ScriptEvent>()[i - 1].name)),
                      "more than 10,000 events in a tick: handlers of events emit events without end",
                      "use emitAfter(0, ...), which emits in the next tick"});
    });
    failures_.logOthers();
}

}  // namespace plumb
