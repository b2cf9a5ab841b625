#include <algorithm>
#include <memory>
#include <utility>

#include "physics/measure/snapshot.hpp"
#include "scene/physics/physics_state.hpp"

// The physics of a saved game.

namespace plumb {
namespace {

/// Writes or reads the physics world. @return false if it was written by another version of the physics
bool archiveWorld(StateArchive& archive, physics::World& world) {
    std::vector<std::uint8_t> bytes;
    if (!archive.reading()) bytes = physics::toBytes(world);
    archive.list(bytes);
    if (!archive.reading()) return true;
    Result<physics::World> read = physics::worldFrom(bytes);
    if (!archive.ok() || !read) return false;
    world = std::move(*read);
    return true;
}

/// Writes or reads a tile layer: its outlines follow from the cells, TileSync makes them again.
void archiveTerrain(StateArchive& archive, TileTerrain& terrain) {
    archive.value(terrain.entity);
    archive.value(terrain.made);
    archive.value(terrain.seen);
    terrain.body.archive(archive);
    std::uint32_t exists = terrain.cells != nullptr ? 1 : 0;
    archive.number(exists);
    if (exists == 0) return;
    TileStore store;
    if (!archive.reading()) static_cast<void>(store.add(*terrain.cells));
    store.archive(archive);
    const TileGrid* const cells = store.find({1});
    if (cells == nullptr) return archive.fail();
    if (archive.reading()) terrain.cells = std::make_shared<TileGrid>(*cells);
}

}  // namespace

void PhysicsState::archive(StateArchive& archive) {
    // Change marks and counters of memberships stay at their first values when it is read: all that was
    // written or joined since counts as new, and finds its body again.
    const bool isSame = archiveWorld(archive, world);
    archive.value(scale);
    archive.list(links);
    archive.list(bodyOf);
    archive.list(carried);
    archive.list(below);
    archive.value(follows);
    archive.list(driven);
    archive.list(stepped);
    archive.list(grounded);
    archive.list(joints);
    archive.list(fields);
    archive.list(characters);
    archive.list(softBodies);
    archive.value(ground);
    archive.list(unplaced);
    archive.value(syncs);
    archive.value(visits);
    std::size_t count = archive.count(terrains.size());
    if (archive.reading()) terrains.assign(count, {});
    for (TileTerrain& terrain : terrains) archiveTerrain(archive, terrain);
    if (!archive.reading()) return;
    const std::size_t bodies = world.bodies.size();
    const bool fits =
        links.size() <= bodies &&
        std::all_of(bodyOf.begin(), bodyOf.end(), [&](std::uint32_t body) { return body <= links.size(); });
    if (!isSame || !fits || !archive.ok()) {
        *this = {};
    } else {
        mark = carriedMark = 0;
        members = {};
    }
}

}  // namespace plumb
