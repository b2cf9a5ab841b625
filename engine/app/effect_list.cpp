#include "app/effect_list.hpp"

#include <algorithm>
#include <string_view>

#include "app/system_order.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "physics/simulation.hpp"
#include "reflect/type_registry.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/physics_state.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb {
namespace {

constexpr std::string_view kMoving = "RigidBody, KinematicBody";
constexpr std::string_view kColliders =
    "BoxCollider, CircleCollider, CapsuleCollider, PolygonCollider, ChainCollider, TileCollider";
constexpr std::string_view kJoints =
    "RevoluteJoint, DistanceJoint, PrismaticJoint, WeldJoint, WheelJoint, MouseJoint, MotorJoint, "
    "PulleyJoint, GearJoint";
constexpr std::string_view kFields = "GravityField, WindField, BuoyancyField, Attractor";
constexpr std::size_t kNameWidth = 20;  // "character animation" is the longest

/// A device of the player that is opened only for who needs it.
struct Device {
    std::string_view name;
    std::string_view calledFor;
};
constexpr Device kDevices[] = {
    {"picture", "Sprite, TileLayer, ParticleEmitter, Label"},
    {"sound", "SoundCues, Music"},
    {"keys and pads",
     "PlayerController, PushControl, MouseDrag, SceneLink, Menu, SceneKey, ToggleKey, Detonator"},
};

/// Calls `f` for each name of "A, B, C".
template <class F>
void forEachName(std::string_view names, F&& f) {
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(','), names.size());
        f(names.substr(0, end));
        names.remove_prefix(std::min(end + 2, names.size()));
    }
}

class EffectTable {
public:
    EffectTable(World& world, const TypeRegistry& types) : world_{world}, types_{types} {}

    void heading(std::string_view name) {
        if (!text_.empty()) text_ += '\n';
        text_.append(name).append(kNameWidth + 2 - name.size(), ' ').append("works  for whom\n");
    }
    void line(std::string_view name, bool works, std::string_view calledFor) {
        text_.append("  ").append(name);
        text_.append(kNameWidth - std::min(name.size(), kNameWidth - 1), ' ');
        const std::string callers = callersOf(calledFor);
        text_.append(works ? "yes    " : "no     ");
        if (callers.empty()) {
            text_.append(calledFor.empty() ? "no component calls for it yet" : "nobody has ")
                .append(calledFor);
        } else {
            text_.append(callers).append(works ? "" : ", but nothing of it moves");
        }
        text_ += '\n';
    }
    [[nodiscard]] bool calledFor(std::string_view names) const { return !callersOf(names).empty(); }
    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    /// "RigidBody (3), Patrol (2)"; empty when nobody has any of them.
    [[nodiscard]] std::string callersOf(std::string_view names) const {
        std::string callers;
        forEachName(names, [&](std::string_view name) {
            std::size_t count = 0;
            if (const TypeInfo* type = types_.find(name))
                world_.eachOf(*type, [&count](EntityId, const void*) { ++count; });
            if (count == 0) return;
            if (!callers.empty()) callers += ", ";
            callers.append(name).append(format(" ({})", count));
        });
        return callers;
    }

    World& world_;
    const TypeRegistry& types_;
    std::string text_;
};

/// The components for which a stage runs, by one of its effects.
struct Caller {
    physics::Effect effect;
    std::string_view components;
};
constexpr Caller kCallers[] = {
    {physics::Effect::OneWay, kColliders},
    {physics::Effect::Triggers, kColliders},
    {physics::Effect::Contacts, kColliders},
    {physics::Effect::Joints, kJoints},
    {physics::Effect::Explosion, "Explosion"},
    {physics::Effect::AreaGravity, kFields},
    {physics::Effect::SoftBodies, "Rope, Cloth, Jelly"},
};

std::string_view callersOf(const physics::StageInfo& stage) {
    for (const Caller& caller : kCallers) {
        if ((stage.effects & physics::Manifest::bit(caller.effect)) != 0) return caller.components;
    }
    return kMoving;
}

bool works(const physics::StageInfo& stage, const physics::World& world) {
    if (world.awake.empty()) return false;
    if (stage.effects == 0) return true;
    for (std::size_t i = 0; i < physics::kEffects; ++i) {
        const auto effect = static_cast<physics::Effect>(i);
        if ((stage.effects & physics::Manifest::bit(effect)) != 0 && world.manifest.runs(effect)) return true;
    }
    return false;
}

void listPhysics(EffectTable& table, const physics::World& world) {
    table.heading("physics");
    for (const physics::StageInfo& stage : physics::stages())
        table.line(stage.name, works(stage, world), callersOf(stage));
}

void listSystems(EffectTable& table, bool physicsWorks) {
    table.heading("systems");
    for (const SystemRow& system : systemTable()) {
        const bool isPhysics = system.name == PhysicsSystem::kName;
        table.line(system.name, isPhysics ? physicsWorks : table.calledFor(system.calledFor),
                   system.calledFor);
    }
}

}  // namespace

std::string effectList(World& world, const TypeRegistry& types) {
    EffectTable table{world, types};
    syncBodies(world, 1.0f / 60.0f);
    const physics::World& physics = world.resource<PhysicsState>().world;
    listPhysics(table, physics);
    listSystems(table, physics::bodyCount(physics) > 0 && !physics.awake.empty());
    table.heading("devices");
    for (const Device& device : kDevices) {
        table.line(device.name, table.calledFor(device.calledFor), device.calledFor);
    }
    return table.take();
}

}  // namespace plumb
