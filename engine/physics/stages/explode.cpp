#include "physics/effects/explosion.hpp"
#include "physics/effects/field_search.hpp"
#include "physics/effects/field_types.hpp"
#include "physics/model/fields.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

void explode(StepContext& step) {
    World& world = step.world;
    updateFieldBoxes(world, step.work);
    const auto explosionAt = [&](std::uint32_t f) {
        const Field& field = world.fields.all[f];
        const bool explodes = field.isAlive && field.definition.kind == FieldKind::Explosion;
        return explodes ? &field.definition : nullptr;
    };
    for (const std::uint32_t body : world.awake) {
        if (world.bodies.info[body].kind != BodyKind::Dynamic) continue;
        for (const std::uint32_t f :
             fieldsNear(world, step.work, body, 1u << static_cast<unsigned>(FieldKind::Explosion))) {
            const FieldDefinition* explosion = explosionAt(f);
            if (explosion != nullptr && actsOn(world, *explosion, body)) pushAway(world, *explosion, body);
        }
    }
    for (std::uint32_t f = 0; f < world.fields.all.size(); ++f) {
        if (explosionAt(f) != nullptr) destroyField(world, {f, world.fields.all[f].generation});
    }
}

}  // namespace plumb::physics
