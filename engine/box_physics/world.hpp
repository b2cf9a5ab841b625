#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/result.hpp"
#include "box_physics/body.hpp"
#include "box_physics/contact_event.hpp"
#include "box_physics/tile_field.hpp"
#include "box_physics/workspace.hpp"

namespace plumb {
class Hasher;
}

namespace plumb::box_physics {

/// The bodies as one array per property, all indexed by `BodyId::index`.
struct Bodies {
    std::vector<std::uint32_t> generation;
    std::vector<BodyKind> kind;
    std::vector<std::uint8_t> flags;  ///< bits of BodyFlag
    std::vector<Shape> shape;
    std::vector<Vec2> position;      ///< m
    std::vector<Vec2> velocity;      ///< m/s
    std::vector<Vec2> acceleration;  ///< m/s2, added to gravity
    std::vector<Vec2> target;        ///< m: where a kinematic body with HasTarget is moved this step
    std::vector<float> inverseMass;  ///< 1/kg; 0 for what contacts cannot move
    std::vector<float> gravityScale;
    std::vector<float> friction;
    std::vector<float> bounciness;
    std::vector<std::uint32_t> layers;
    std::vector<std::uint32_t> mask;
    std::vector<std::uint64_t> user;

    [[nodiscard]] std::size_t size() const { return kind.size(); }
};

enum BodyFlag : std::uint8_t {
    kTrigger = 1,
    kOneWay = 2,
    kHasTarget = 4,
    kGrounded = 8,  ///< something below holds it up since the last step
    kMoved = 16,    ///< its position changed in the last step
};

/// Everything that is simulated, as plain data: copy = snapshot. Ids, no addresses; what is shared
/// (tile fields) never changes while it is in use.
struct World {
    Bodies bodies;
    std::vector<std::uint32_t> freePlaces;                 ///< of `bodies`, last freed last
    std::vector<std::shared_ptr<const TileField>> fields;  ///< Shape::field is an index here
    std::vector<ContactEvent> touching;                    ///< pairs that touch, sorted by a, then b
    std::vector<ContactEvent> events;                      ///< of the last step, sorted by a, then b
    std::uint64_t steps = 0;
    Workspace work;  ///< not copied, not hashed
};

[[nodiscard]] bool alive(const World& world, BodyId body);
[[nodiscard]] std::size_t bodyCount(const World& world);

/// Adds a body.
/// @error a number that is not finite, a size or mass that is not positive
Result<BodyId> createBody(World& world, const BodyDefinition& definition);

/// Removes a body; its contacts end in the next step. A stale id does nothing.
void destroyBody(World& world, BodyId body);

/// Adds a tile field for shapes of kind Tiles. Replacing it by none frees its number.
std::uint32_t addField(World& world, std::shared_ptr<const TileField> field);
void replaceField(World& world, std::uint32_t number, std::shared_ptr<const TileField> field);
/// The shape of a whole tile field whose top-left corner is the body's position.
Shape shapeOfField(const World& world, std::uint32_t number);

// Setters refuse what is not finite, with a message, and change nothing then. All need a living body.

Result<Done> setPosition(World& world, BodyId body, Vec2 position);  ///< m; a jump, nothing is swept
Result<Done> setVelocity(World& world, BodyId body, Vec2 velocity);  ///< m/s
Result<Done> setAcceleration(World& world, BodyId body, Vec2 acceleration);
/// Moves a kinematic body there within the next step, pushing what is in the way.
Result<Done> moveTo(World& world, BodyId body, Vec2 target);
Result<Done> setShape(World& world, BodyId body, const Shape& shape);
Result<Done> setMass(World& world, BodyId body, float mass);
/// Friction, bounciness and gravity scale.
Result<Done> setSurface(World& world, BodyId body, float friction, float bounciness, float gravityScale);
void setFilter(World& world, BodyId body, std::uint32_t layers, std::uint32_t mask);
void setFlags(World& world, BodyId body, bool isTrigger, bool oneWay);

[[nodiscard]] inline bool grounded(const World& world, BodyId body) {
    return (world.bodies.flags[body.index] & kGrounded) != 0;
}

/// Folds the whole state into a hash; equal states give equal numbers on every machine.
void addTo(Hasher& hasher, const World& world);
[[nodiscard]] std::uint64_t hashOf(const World& world);

}  // namespace plumb::box_physics
