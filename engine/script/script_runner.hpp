#pragma once

#include <functional>
#include <string_view>

#include "core/text_store.hpp"
#include "script/script_context.hpp"
#include "script/script_errors.hpp"
#include "script/script_library.hpp"
#include "script/script_state.hpp"

namespace plumb {

struct ComponentType;
class ScriptObserver;

/// Runs the scripts of a world. Handlers run as coroutines: one that waits goes on in a later tick, or when
/// the event comes that it waits for. A handler that fails stops its script: the Bool `stopped` of the
/// component.
class ScriptRunner final : private ScriptHost {
public:
    /// The world must have the service ScriptSet.
    explicit ScriptRunner(World& world);

    /// False if scripts could not have the values of a saved game, from ScriptState::saved, again.
    [[nodiscard]] bool tookSaved() const { return tookSaved_; }

    /// Loads new and changed files, ends the scripts of components that are gone and begins those of new ones
    /// (onCreate), goes on with what has waited long enough, and calls onTick.
    void tick(float dt);
    /// Calls the handlers of contacts, triggers and events of this tick.
    void handleEvents();

private:
    using Loaded = ScriptState::Loaded;
    using Instance = ScriptState::Instance;
    using Wait = ScriptState::Wait;

    Random& random() override;
    void print(std::string_view text) override;

    void protect(const std::function<void()>& body);

    void load();
    void takeSaved();
    void callOnLoad();
    void loadFile(std::size_t index);
    void reset(Loaded& script);

    void endInstances(Loaded& script);
    void callOnDestroy(Loaded& script, std::vector<Instance>& gone);
    void endWaits();
    void beginInstances();
    void begin(Loaded& script, EntityId entity);
    void resumeWaits();
    void resumeWait(const Wait& wait, int values);
    void callTicks(float dt);

    template <class Event>
    void handleContacts(std::uint32_t handler, bool withContact);
    template <class Event>
    void handleTriggers(std::uint32_t handler);
    void handle(const ScriptEvent& event);
    void wakeFor(const ScriptEvent& event);

    /// Starts a handler; its `values` arguments are on top of the stack.
    void call(Loaded& script, Instance& instance, std::string_view handler, int values, bool isTick = false);
    void resume(int thread, lua_State* coroutine, int values, const Wait& wait);
    [[nodiscard]] const ComponentType* typeOf(TypeKey key) const;
    [[nodiscard]] bool isStopped(TypeKey type, EntityId entity) const;
    [[nodiscard]] bool isOver(std::uint32_t scene) const;
    [[nodiscard]] bool mayRun(const Loaded& script, const Instance& instance) const;
    int takeThread();
    lua_State* threadOf(int ref);
    void report(lua_State* coroutine, int status, const Wait& wait);

    World& world_;
    const ScriptSet& set_;
    ScriptState& scripts_;
    ScriptObserver* observer_;  // null: scripts run without a hook
    ScriptAccess access_;
    lua_State* state_;
    script::FailureLog failures_;
    bool tookSaved_ = true;
    script::Context context_;
    script::ContextScope contextScope_;
    ScriptHostScope hostScope_;
    mutable const ComponentType* lastType_ = nullptr;  // found by typeOf()
};

}  // namespace plumb
