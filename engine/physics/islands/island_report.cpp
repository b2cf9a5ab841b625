#include "physics/islands/island_report.hpp"

#include <algorithm>
#include <numeric>

#include "physics/islands/sleeping.hpp"
#include "physics/measure/measures.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Returns, by body, the body with the lowest index in its island. Recomputed from scratch, because the
/// islands stored in the world may be larger than necessary, and lookups modify them.
std::vector<std::uint32_t> firstBodies(const World& world) {
    std::vector<std::uint32_t> firsts(world.bodies.size());
    std::iota(firsts.begin(), firsts.end(), 0u);
    const auto parent = [&](std::uint32_t body) -> std::uint32_t& { return firsts[body]; };
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        if (isUp(world, a) && isUp(world, b)) joinTrees(parent, a, b);
    };
    for (const Contact& contact : world.contacts) {
        if ((contact.flags & (kTouching | kTriggered)) == kTouching) join(contact.bodyA, contact.bodyB);
    }
    for (const std::uint32_t j : world.joints.awake)
        join(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
    for (std::uint32_t& first : firsts) first = rootOf(parent, first);
    return firsts;
}

/// Returns the quality of a body in the last step.
Quality qualityOf(const World& world, std::uint32_t body) {
    const std::vector<SubstepController>& substepControllers = world.bodies.substepControllers;
    if (body < substepControllers.size() && substepControllers[body].quality != kQualityOfWorld)
        return substepControllers[body].quality;
    const Workspace* work = world.work.lastStep();
    if (work == nullptr || work->groups.empty() || body >= work->slots.size() || work->slots[body] < 0)
        return std::max(world.bodies.info[body].quality, world.settings.quality);
    const auto solvedIn = [&](const SolveGroup& group) { return work->slots[body] < group.end; };
    return std::find_if(work->groups.begin(), work->groups.end(), solvedIn)->quality;
}

std::vector<std::uint32_t> indicesOf(const World& world, std::vector<IslandReport>& islands) {
    const std::vector<std::uint32_t> firsts = firstBodies(world);
    std::vector<std::uint32_t> indices(world.bodies.size(), kNone);
    for (std::uint32_t body = 0; body < indices.size(); ++body) {
        if (!isUp(world, body)) continue;
        std::uint32_t& index = indices[firsts[body]];
        if (index == kNone) {  // this is the first body of its island
            index = static_cast<std::uint32_t>(islands.size());
            islands.emplace_back().first = idOfBody(world, body);
        }
        indices[body] = index;
    }
    return indices;
}

}  // namespace

std::vector<IslandReport> reportIslands(const World& world) {
    std::vector<IslandReport> islands;
    const std::vector<std::uint32_t> indices = indicesOf(world, islands);
    for (std::uint32_t body = 0; body < indices.size(); ++body) {
        if (indices[body] == kNone) continue;
        IslandReport& island = islands[indices[body]];
        ++island.bodies;
        island.quality = std::max(island.quality, qualityOf(world, body));
        island.speed = std::max(island.speed, length(world.bodies.motion[body].velocity));
    }
    // Returns the island of B, or of A if B is not dynamic.
    const auto islandFor = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t index = indices[b] != kNone ? indices[b] : indices[a];
        return index != kNone ? &islands[index] : nullptr;
    };
    for (const Contact& contact : world.contacts) {
        IslandReport* const island = islandFor(contact.bodyA, contact.bodyB);
        if (island == nullptr || (contact.flags & (kTouching | kTriggered | kDisabled)) != kTouching)
            continue;
        ++island->contacts;
        island->overlap = std::max(island->overlap, overlapOf(contact));
    }
    for (const std::uint32_t j : world.joints.awake) {
        IslandReport* const island = islandFor(world.joints.hot[j].bodyA, world.joints.hot[j].bodyB);
        if (island == nullptr) continue;
        ++island->joints;
        island->jointError = std::max(island->jointError, openingOf(world, j));
    }
    return islands;
}

std::vector<std::uint32_t> islandIndices(const World& world) {
    std::vector<IslandReport> islands;
    return indicesOf(world, islands);
}

}  // namespace plumb::physics
