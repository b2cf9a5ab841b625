#include "physics/simulation.hpp"

namespace plumb::physics {

namespace {

template <class... T>
std::size_t bytesOf(const std::vector<T>&... arrays) {
    return ((arrays.size() * sizeof(T)) + ...);
}

}  // namespace

std::size_t stateBytes(const World& world) {
    const Bodies& bodies = world.bodies;
    const Shapes& shapes = world.shapes;
    const Joints& joints = world.joints;
    const Sleepers& sleepers = world.sleepers;
    std::size_t bytes =
        sizeof(World) +
        bytesOf(bodies.pose, bodies.motion, bodies.mass, bodies.info, bodies.substepControllers,
                bodies.energies, bodies.drives.rows, bodies.drives.free, bodies.free, bodies.dying) +
        bytesOf(shapes.geometry, shapes.bounds, shapes.filter, shapes.motion, shapes.info, shapes.extras.rows,
                shapes.extras.free, shapes.free, shapes.dying, shapes.corners) +
        bytesOf(joints.hot, joints.definition, joints.awake, joints.free) +
        bytesOf(world.fields.all, world.fields.free, world.softBodies.all, world.softBodies.free) +
        bytesOf(world.awake, world.moved, world.contacts, world.initialOverlaps, world.events,
                world.brokenJoints, world.quarantined) +
        bytesOf(sleepers.islands, sleepers.freeIslands, sleepers.contacts, sleepers.nextContact,
                sleepers.freeContacts, sleepers.nextBody, sleepers.islandOf);
    for (const std::vector<std::uint32_t>& free : shapes.freeCorners) bytes += bytesOf(free);
    for (const SoftBody& soft : world.softBodies.all)
        bytes += bytesOf(soft.particles, soft.links, soft.ring, soft.touches);
    return bytes;
}

}  // namespace plumb::physics
