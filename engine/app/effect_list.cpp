#include "app/effect_list.hpp"

#include <algorithm>
#include <string_view>

#include "app/system_order.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "box_physics/simulation.hpp"
#include "box_physics/stage_names.hpp"
#include "reflect/type_registry.hpp"
#include "scene/physics_bridge.hpp"
#include "scene/systems/physics_system.hpp"

namespace plumb {
namespace {

constexpr std::string_view kMoving = "RigidBody, KinematicBody";
constexpr std::string_view kColliders = "BoxCollider, CircleCollider, TileCollider";
constexpr std::size_t kNameWidth = 20;  // "character animation" is the longest

/// A device of the player that is opened only for who needs it.
struct Device {
    std::string_view name;
    std::string_view calledFor;
};
constexpr Device kDevices[] = {
    {"picture", "Sprite, TileLayer, Label"},
    {"sound", "SoundCues, Music"},
    {"keys and pads", "PlayerController, SceneLink, Menu"},
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
            text_.append("nobody has ").append(calledFor);
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

/// The components for which any of these effects runs.
std::string_view callersOfPhysics(unsigned effects) {
    if ((effects & box_physics::kAllEffects) == box_physics::kAllEffects) return kMoving;
    return (effects & (box_physics::kContacts | box_physics::kTriggers)) != 0 ? kColliders : kMoving;
}

void listPhysics(EffectTable& table, unsigned called) {
    table.heading("physics");
    for (const box_physics::StageName& stage : box_physics::stageNames()) {
        const bool moves = (stage.effects & box_physics::kMotion) != 0;
        table.line(stage.name, (stage.effects & called) != 0,
                   moves ? kMoving : callersOfPhysics(stage.effects));
    }
}

void listSystems(EffectTable& table, unsigned called) {
    table.heading("systems");
    for (const SystemRow& system : systemTable()) {
        const bool isPhysics = system.name == PhysicsSystem::kName;
        table.line(system.name, isPhysics ? called != 0 : table.calledFor(system.calledFor),
                   system.calledFor);
    }
}

}  // namespace

std::string effectList(World& world, const TypeRegistry& types) {
    EffectTable table{world, types};
    const unsigned called = effectsOf(world);
    listPhysics(table, called);
    listSystems(table, called);
    table.heading("devices");
    for (const Device& device : kDevices) {
        table.line(device.name, table.calledFor(device.calledFor), device.calledFor);
    }
    return table.take();
}

}  // namespace plumb
