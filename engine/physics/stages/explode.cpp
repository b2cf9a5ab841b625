#include "physics/effects/explosion.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/model/fields.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

void explode(StepContext& step) {
    World& world = step.world;
    for (std::uint32_t i = 0; i < world.fields.all.size(); ++i) {
        const Field& field = world.fields.all[i];
        if (!field.isAlive || field.definition.kind != FieldKind::Explosion) continue;
        for (const std::uint32_t body : world.awake) {
            if (world.bodies.info[body].kind != BodyKind::Dynamic) continue;
            if (actsOn(world, field.definition, body)) pushAway(world, field.definition, body);
        }
        destroyField(world, {i, field.generation});
    }
}

}  // namespace plumb::physics
