#include "gameplay/physics_counts.hpp"

#include <utility>

#include "ecs/world.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/scene_stack.hpp"

namespace plumb {

std::optional<std::int64_t> physicsCount(const World& world, std::string_view word) {
    const PhysicsState* state = lowestPhysics(world);
    if (state == nullptr) return {};
    const auto* counts = world.findResource<PhysicsCounts>();
    const physics::DetectionCounts found = counts != nullptr ? counts->detection : physics::DetectionCounts{};
    const std::pair<std::string_view, std::size_t> numbers[] = {
        {"bodies", physics::bodyCount(state->world)},
        {"contacts", state->world.contacts.size()},
        {"joints", state->world.joints.size() - state->world.joints.free.size()},
        {"pairs", found.pairs},
        {"circles", found.apartByCircles},
        {"boxes", found.apartByBounds},
        {"axes", found.apartByAxes},
        {"kept", found.recycled},
        {"touching", found.touching},
    };
    for (const auto& [name, value] : numbers) {
        if (name == word) return static_cast<std::int64_t>(value);
    }
    return {};
}

}  // namespace plumb
