#include "physics/soft/softbody.hpp"

#include <bit>

#include "physics/islands/sleeping.hpp"
#include "physics/model/checks.hpp"
#include "physics/soft/soft_contacts.hpp"

namespace plumb::physics {

namespace {

Result<Done> check(const SoftMaterial& material) {
    return firstOf(checkNumber("SoftMaterial.mass", material.mass, 1.0e-6, 1.0e9),
                   checkNumber("SoftMaterial.radius", material.radius, 0.0, kLargest),
                   checkNumber("SoftMaterial.stretchCompliance", material.stretchCompliance, 0.0, 1.0e9),
                   checkNumber("SoftMaterial.bendCompliance", material.bendCompliance, -1.0, 1.0e9),
                   checkNumber("SoftMaterial.areaCompliance", material.areaCompliance, 0.0, 1.0e9),
                   checkNumber("SoftMaterial.damping", material.damping, 0.0, kFastest),
                   checkNumber("SoftMaterial.friction", material.friction, 0.0, kRoughest),
                   checkNumber("SoftMaterial.substeps", material.substeps, 1.0, 64.0));
}

SoftBody bodyOf(const SoftMaterial& material) {
    return {.areaCompliance = material.areaCompliance,
            .radius = material.radius,
            .damping = material.damping,
            .friction = material.friction,
            .layers = material.layers,
            .mask = material.mask,
            .substeps = material.substeps};
}

void addParticle(SoftBody& body, WorldPosition place, float mass) {
    body.particles.push_back({place, place, {}, 1.0f / mass, mass});
}

void link(SoftBody& body, int a, int b, float compliance, bool isEdge = false) {
    if (compliance < 0.0f) return;
    const auto i = static_cast<std::uint32_t>(a), j = static_cast<std::uint32_t>(b);
    body.links.push_back(
        {i, j, length(body.particles[j].place - body.particles[i].place), compliance, isEdge});
}

/// Adds a link with which other soft bodies collide.
void edge(SoftBody& body, int a, int b, float compliance) { link(body, a, b, compliance, true); }

/// Sorts links by color, so that adjacent links in the list share no particle. In the order of a chain, each
/// link would pass its correction to the next, and the error would run around a ring, which oscillates. A
/// particle of a cloth has up to 12 links, so that 23 colors suffice.
void sortByColor(SoftBody& body) {
    std::vector<std::uint32_t> used(body.particles.size(), 0);  // colors
    std::vector<SoftLink> byColor[32];
    for (const SoftLink& link : body.links) {
        const int color = std::countr_one(used[link.a] | used[link.b]);
        for (const std::uint32_t end : {link.a, link.b}) used[end] |= 1u << color;
        byColor[color].push_back(link);
    }
    body.links.clear();
    for (const auto& links : byColor) body.links.insert(body.links.end(), links.begin(), links.end());
}

SoftBodyId take(World& world, SoftBody&& body) {
    sortByColor(body);
    Slots<SoftBody>& soft = world.softBodies;
    const std::uint32_t index = takeIndex(soft.free, soft.all);
    body.generation = soft.all[index].generation + 1;
    body.isAlive = true;
    soft.all[index] = std::move(body);
    world.manifest.call(Effect::SoftBodies, true);
    return {index, soft.all[index].generation};
}

/// Wakes the bodies near a soft body; otherwise bodies that sleep on it would hang in the air.
void wakeNeighbours(World& world, const SoftBody& body) {
    const AABB bounds = grown(rounded(boxOf(body, 0.0f)), 2.0f * body.radius);
    for (std::size_t s = 0; s < world.shapes.size(); ++s) {
        if (world.shapes.motion[s] == ProxyMotion::Asleep && intersects(world.shapes.bounds[s], bounds))
            wake(world, world.shapes.info[s].body);
    }
}

Result<Done> checkParticle(const char* where, const World& world, SoftBodyId body, int particle) {
    return firstOf(
        checkAlive(where, world, body),
        checkNumber(where, particle, 0.0, static_cast<double>(particlesOf(world, body).size()) - 1.0));
}

}  // namespace

Result<SoftBodyId> createRope(World& world, WorldPosition from, WorldPosition to, int count,
                              const SoftMaterial& material) {
    const auto checked =
        firstOf(checkOutside("createRope", world), check(material), checkPosition("createRope from", from),
                checkPosition("createRope to", to), checkNumber("createRope count", count, 2.0, 10000.0));
    if (!checked) return checked.error();
    if (from.x == to.x && from.y == to.y)
        return usageError("createRope", "expected two different ends, found equal positions",
                          "pass different positions");
    SoftBody body = bodyOf(material);
    const double parts = count - 1;
    for (int i = 0; i < count; ++i) {
        const double t = i / parts;
        addParticle(body, {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)},
                    material.mass / static_cast<float>(count));
    }
    for (int i = 0; i + 1 < count; ++i) edge(body, i, i + 1, material.stretchCompliance);
    for (int i = 0; i + 2 < count; ++i) link(body, i, i + 2, material.bendCompliance);
    return take(world, std::move(body));
}

Result<SoftBodyId> createCloth(World& world, WorldPosition corner, Vec2 size, int columns, int rows,
                               const SoftMaterial& material) {
    const auto checked =
        firstOf(checkOutside("createCloth", world), check(material),
                checkPosition("createCloth corner", corner), checkVector("createCloth size", size, kLargest),
                checkNumber("createCloth columns", columns, 2.0, 200.0),
                checkNumber("createCloth rows", rows, 2.0, 200.0));
    if (!checked) return checked.error();
    SoftBody body = bodyOf(material);
    const Vec2 cell{size.x / static_cast<float>(columns - 1), size.y / static_cast<float>(rows - 1)};
    const auto number = [&](int column, int row) { return row * columns + column; };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Vec2 displacement{cell.x * static_cast<float>(column), cell.y * static_cast<float>(row)};
            addParticle(body, corner + displacement, material.mass / static_cast<float>(columns * rows));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int here = number(column, row);
            const bool right = column + 1 < columns, down = row + 1 < rows;
            if (right) edge(body, here, number(column + 1, row), material.stretchCompliance);
            if (down) edge(body, here, number(column, row + 1), material.stretchCompliance);
            if (right && down) {
                link(body, here, number(column + 1, row + 1), material.bendCompliance);
                link(body, number(column + 1, row), number(column, row + 1), material.bendCompliance);
            }
        }
    }
    return take(world, std::move(body));
}

Result<SoftBodyId> createJelly(World& world, WorldPosition place, std::span<const Vec2> outline,
                               const SoftMaterial& material) {
    auto checked = firstOf(
        checkOutside("createJelly", world), check(material), checkPosition("createJelly place", place),
        checkNumber("createJelly points", static_cast<double>(outline.size()), 3.0, 500.0));
    for (const Vec2 point : outline) {
        if (checked) checked = checkVector("createJelly point", point, kLargest);
    }
    if (!checked) return checked.error();
    SoftBody body = bodyOf(material);
    const auto count = static_cast<int>(outline.size());
    for (const Vec2 point : outline)
        addParticle(body, place + point, material.mass / static_cast<float>(count));
    for (std::size_t i = 0; i < outline.size(); ++i) {
        body.ring.push_back(static_cast<std::uint32_t>(i));
        body.area += 0.5f * cross(outline[i], outline[(i + 1) % outline.size()]);
    }
    if (!(body.area > kSmallest * kSmallest || body.area < -kSmallest * kSmallest)) {
        return usageError("createJelly", "expected an outline with a nonzero area",
                          "pass the points in the order of the outline");
    }
    for (int i = 0; i < count; ++i) edge(body, i, (i + 1) % count, material.stretchCompliance);
    for (int i = 0; i < count && count > 4; ++i) link(body, i, (i + 2) % count, material.bendCompliance);
    return take(world, std::move(body));
}

void destroySoftBody(World& world, SoftBodyId body) {
    if (!mayChange(world, body)) return;
    wakeNeighbours(world, world.softBodies.all[body.index]);
    const std::uint32_t generation = body.generation;
    world.softBodies.all[body.index] = {};
    world.softBodies.all[body.index].generation = generation;
    world.softBodies.free.push_back(body.index);
    world.manifest.call(Effect::SoftBodies, true, -1);
}

Result<Done> pinParticle(World& world, SoftBodyId body, int particle, bool pinned) {
    if (const auto checked = checkParticle("pinParticle", world, body, particle); !checked) return checked;
    SoftParticle& held = world.softBodies.all[body.index].particles[static_cast<std::size_t>(particle)];
    held.inverseMass = pinned ? 0.0f : 1.0f / held.mass;
    held.velocity = {};
    return Done{};
}

Result<Done> moveParticle(World& world, SoftBodyId body, int particle, WorldPosition place) {
    const auto checked = firstOf(checkParticle("moveParticle", world, body, particle),
                                 checkPosition("moveParticle place", place));
    if (!checked) return checked;
    world.softBodies.all[body.index].particles[static_cast<std::size_t>(particle)].place = place;
    return Done{};
}

Result<Done> setParticleVelocity(World& world, SoftBodyId body, int particle, Vec2 velocity) {
    const auto checked = firstOf(checkParticle("setParticleVelocity", world, body, particle),
                                 checkVector("setParticleVelocity velocity", velocity, kFastest));
    if (!checked) return checked;
    SoftParticle& pushed = world.softBodies.all[body.index].particles[static_cast<std::size_t>(particle)];
    if (pushed.inverseMass > 0.0f) pushed.velocity = velocity;
    return Done{};
}

}  // namespace plumb::physics
