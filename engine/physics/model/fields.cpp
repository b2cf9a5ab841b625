#include "physics/model/fields.hpp"

#include "physics/effects/field_types.hpp"
#include "physics/islands/sleeping.hpp"
#include "physics/model/bodies.hpp"
#include "physics/model/checks.hpp"

namespace plumb::physics {

namespace {

Result<Done> checkKinds(const FieldDefinition& d) {
    if (d.kind < FieldKind::Count && d.region < RegionKind::Count) return Done{};
    return usageError("FieldDefinition.kind",
                      "expected a valid FieldKind and RegionKind, found another number",
                      "use the constants of these enums");
}

Result<Done> checkEnds(const World& world, const FieldDefinition& d) {
    if (d.kind == FieldKind::Attractor && d.a) return checkAlive("FieldDefinition.a", world, d.a);
    if (d.kind != FieldKind::Spring) return Done{};
    const auto checked = checkAlive("FieldDefinition.a", world, d.a);
    if (!checked || !d.b) return checked;
    if (d.a == d.b) {
        return usageError("FieldDefinition.b", "expected a body other than a, found the same one",
                          "pass two bodies, or omit b to attach a to a fixed point");
    }
    return checkAlive("FieldDefinition.b", world, d.b);
}

Result<Done> check(const World& world, const FieldDefinition& d) {
    return firstOf(checkOutside("FieldDefinition", world), checkKinds(d),
                   checkPosition("FieldDefinition.place", d.place),
                   checkNumber("FieldDefinition.half.x", d.half.x, 0.0, kFarthest),
                   checkNumber("FieldDefinition.half.y", d.half.y, 0.0, kFarthest),
                   checkNumber("FieldDefinition.radius", d.radius, 0.0, kFarthest),
                   checkVector("FieldDefinition.acceleration", d.acceleration, kFastest),
                   checkVector("FieldDefinition.velocity", d.velocity, kFastest),
                   checkNumber("FieldDefinition.strength", d.strength, -1.0e12, 1.0e12),
                   checkNumber("FieldDefinition.damping", d.damping, 0.0, 1.0e12),
                   checkNumber("FieldDefinition.length", d.length, 0.0, kFarthest),
                   checkNumber("FieldDefinition.density", d.density, 0.0, 1.0e9),
                   checkNumber("FieldDefinition.linearDrag", d.linearDrag, 0.0, kFastest),
                   checkNumber("FieldDefinition.angularDrag", d.angularDrag, 0.0, kFastest),
                   checkNumber("FieldDefinition.gust", d.gust, 0.0, kFastest),
                   checkNumber("FieldDefinition.gustSteps", d.gustSteps, 1.0, 1.0e9),
                   checkVector("FieldDefinition.anchorA", d.anchorA, kLargest),
                   checkVector("FieldDefinition.anchorB", d.anchorB, kLargest), checkEnds(world, d));
}

void wakeThoseIn(World& world, const FieldDefinition& field) {
    if (world.sleepers.islands.size() == world.sleepers.freeIslands.size()) return;  // no body is asleep
    for (std::uint32_t body = 0; body < world.bodies.size(); ++body) {
        if (isDynamic(world, body) && !isUp(world, body) && actsOn(world, field, body)) wake(world, body);
    }
}

}  // namespace

Result<FieldId> createField(World& world, const FieldDefinition& definition) {
    if (const auto checked = check(world, definition); !checked) return checked.error();
    const std::uint32_t index = takeIndex(world.fields.free, world.fields.all);
    Field& field = world.fields.all[index];
    field.definition = definition;
    field.isAlive = true;
    ++field.generation;
    world.manifest.call(fieldTypeOf(definition.kind).effect, true);
    wakeThoseIn(world, definition);
    return FieldId{index, field.generation};
}

void destroyField(World& world, FieldId field) {
    if (!mayChange(world, field)) return;
    Field& gone = world.fields.all[field.index];
    if (gone.definition.kind != FieldKind::Explosion) wakeThoseIn(world, gone.definition);
    world.manifest.call(fieldTypeOf(gone.definition.kind).effect, true, -1);
    gone.isAlive = false;
    world.fields.free.push_back(field.index);
}

Result<Done> setField(World& world, FieldId field, const FieldDefinition& definition) {
    if (const auto checked = check(world, definition); !checked) return checked;
    if (!alive(world, field) || definitionOf(world, field).kind != definition.kind) {
        return usageError("setField", "expected an existing field of the same kind",
                          "destroy the field and create one of the other kind");
    }
    wakeThoseIn(world, definitionOf(world, field));
    world.fields.all[field.index].definition = definition;
    wakeThoseIn(world, definition);
    return Done{};
}

}  // namespace plumb::physics
