#include "editor/model/cost/what_if.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/clock.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/workspace.hpp"
#include "scene/components/scene_entity.hpp"
#include "scene/physics/entity_bodies.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb::editor {
namespace {

constexpr float kTick = 1.0f / 60.0f;  // s
/// Numbers of ticks before the end at which a start is stored; expensive scenes use a later start.
constexpr std::array<std::int64_t, 4> kStarts{200, 120, 60, 30};

/// System that records the game's changes right before the physics system. It already copies components to
/// bodies, so the physics system's own copying finds no changes.
struct TapeSystem {
    static constexpr std::string_view kName = "physics tape";

    void update(World& world, float dt) {
        auto* recorder = world.service<TapeRecorder>();
        if (recorder == nullptr || !recorder->on) return;
        syncBodies(world, dt);
        recorder->beforeStep(world.resource<PhysicsState>().world);
    }
};

void install(World& world, TapeRecorder& recorder) {
    world.provide(recorder);
    if (world.hasSystem<TapeSystem>()) return;
    std::vector<std::string_view> names = world.systemNames();
    names.insert(std::find(names.begin(), names.end(), PhysicsSystem::kName), TapeSystem::kName);
    static_cast<void>(world.addSystem<TapeSystem>());
    world.setSystemOrder(names);
}

/// Creates the bodies of a scene, which do not exist before its first tick.
void makeBodies(World& world) {
    if (world.resource<PhysicsState>().syncs == 0) syncBodies(world, kTick);
}

}  // namespace

WhatIf::WhatIf() = default;
WhatIf::~WhatIf() { cancel(); }

void WhatIf::refuse(std::string why) {
    cancel();
    refusal_ = std::move(why);
}

void WhatIf::cancel() {
    recording_ = recorder_.on = false;
    session_ = nullptr;
    if (busy()) run_.reset();
}

void WhatIf::forget() {
    cancel();
    run_.reset();
    tape_.reset();
    refusal_.clear();
}

void WhatIf::begin(Workspace& workspace) {
    forget();
    const PlayMode& play = workspace.play;
    playing_ = play.running();
    if (!playing_ && editsPrefab(workspace)) return refuse("A prefab is open; leave it first.");
    last_ = playing_ ? play.ticks() : kTicks;
    first_ = playing_ ? std::max(play.oldest(), last_ - kTicks) : 0;
    if (last_ - first_ < kMinTicks) return refuse("Let the game run for half a second first.");
    session_ = playing_ ? ghost_.at(workspace, first_) : ghost_.now(workspace);
    if (session_ == nullptr) return refuse("This scene cannot be played; see the console for the reason.");
    World& world = session_->world();
    install(world, recorder_);
    makeBodies(world);
    const PhysicsState& state = world.resource<PhysicsState>();
    recorder_.begin(state.world, state.scale);
    if (recorder_.tape.watched.empty())
        return refuse("This scene has no dynamic bodies, so physics quality has no effect.");
    tick_ = first_;
    recording_ = true;
}

bool WhatIf::stillThere(const Workspace& workspace) const {
    const PlayMode& play = workspace.play;
    if (playing_ != play.running()) return false;
    return !playing_ || (tick_ >= play.oldest() && last_ <= play.newest());
}

void WhatIf::recordTick(const Workspace& workspace) {
    const physics::World& bodies = session_->world().resource<PhysicsState>().world;
    const bool starts =
        tick_ == first_ || std::find(kStarts.begin(), kStarts.end(), last_ - tick_) != kStarts.end();
    if (starts) recorder_.keepStart(bodies);
    playing_ ? ghost_.playRecorded(workspace, tick_) : session_->tick(InputFrame{});
    recorder_.afterTick(session_->world().resource<PhysicsState>().world);
    ++tick_;
}

void WhatIf::finishTape() {
    recording_ = recorder_.on = false;
    PhysicsTape& tape = recorder_.tape;
    // A menu or another scene may have paused the physics, so that fewer ticks were recorded.
    std::erase_if(tape.starts, [&](const PhysicsTape::Start& start) {
        return start.tick + static_cast<std::size_t>(kMinTicks) > tape.ticks.size();
    });
    if (tape.starts.empty()) return refuse("The physics was paused during the measured time.");
    const World& world = session_->world();
    const auto* state = world.findResource<PhysicsState>();
    for (WatchedBody& watched : tape.watched) {
        if (!alive(state->world, watched.body)) continue;
        const auto* part = world.find<SceneEntity>(ownerOf(*state, watched.body));
        if (part != nullptr) watched.object = ObjectId{part->id};
    }
    tape_ = std::make_shared<const PhysicsTape>(std::move(tape));
    recorder_.tape = {};
    run_ = std::make_unique<WhatIfRun>(tape_);
}

void WhatIf::update(Workspace& workspace) {
    if (!recording_) return;
    if (!stillThere(workspace)) return refuse("The game was started, stopped or rewound; measure again.");
    const double start = threadSeconds();
    while (tick_ < last_ && threadSeconds() - start < kBudget) recordTick(workspace);
    if (tick_ >= last_) finishTape();
}

float WhatIf::progress() const {
    constexpr float kOfTape = 0.25f;  // part of the progress that is the recording
    if (recording_ && last_ > first_)
        return kOfTape * static_cast<float>(tick_ - first_) / static_cast<float>(last_ - first_);
    return run_ == nullptr ? 0.0f : kOfTape + (1.0f - kOfTape) * run_->progress();
}

}  // namespace plumb::editor
