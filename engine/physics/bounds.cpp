#include "physics/bounds.hpp"

#include <algorithm>

#include "physics/contacts/contacts.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"
#include "physics/workspace.hpp"

namespace plumb::physics {

namespace {

/// Returns a margin (m) for the rounding of float coordinates far from the origin.
float roundingAt(const AABB& box) {
    return 0.5f * std::max(largestOf(box.min), largestOf(box.max)) * kRounding;
}

float marginOf(const AABB& tight, const Settings& settings) {
    const Vec2 size = tight.size();
    // std::min() returns its first argument if the second is NaN, so a NaN setting is ignored.
    return std::max(std::min(0.125f * std::max(size.x, size.y), settings.boundsMargin), 0.0f);
}

Proxies proxiesOf(const World& world) {
    return {world.shapes.bounds, world.shapes.filter, world.shapes.motion};
}

/// Updates contacts for which is() is true, except those of altered or destroyed shapes, which will end.
template <class Is>
void refreshThose(World& world, Is&& is) {
    const std::vector<ShapeInfo>& info = world.shapes.info;
    const auto refresh = [&](Contact& contact) {
        const auto ends = [&](std::uint32_t shape) {
            return (info[shape].flags & kAltered) != 0 || world.shapes.motion[shape] == ProxyMotion::Gone;
        };
        if (is(contact) && !ends(contact.shapeA) && !ends(contact.shapeB)) copyMaterials(world, contact);
    };
    for (Contact& contact : world.contacts) refresh(contact);
    for (Contact& contact : world.sleepers.contacts) refresh(contact);
}

}  // namespace

ProxyMotion motionOf(const World& world, std::uint32_t shape) {
    const ShapeInfo& outline = world.shapes.info[shape];
    const BodyInfo& info = world.bodies.info[outline.body];
    if ((outline.flags & kShapeOff) != 0) return ProxyMotion::Gone;
    // A trigger of a body that is not dynamic pairs with all shapes: it detects kinematic bodies too.
    if (info.kind != BodyKind::Dynamic && (outline.flags & kTrigger) != 0) return ProxyMotion::Awake;
    if (info.kind == BodyKind::Static) return ProxyMotion::Static;
    if (info.kind == BodyKind::Kinematic) return ProxyMotion::Kinematic;
    return info.awakeIndex == kNone ? ProxyMotion::Asleep : ProxyMotion::Awake;
}

AABB tightBounds(const World& world, std::uint32_t shape) {
    const Shapes& shapes = world.shapes;
    return boundsOf(shapes.geometry[shape], shapes.corners,
                    frameOf(world.bodies.pose[shapes.info[shape].body]));
}

void setBounds(World& world, std::uint32_t shape) {
    ShapeInfo& info = world.shapes.info[shape];
    const AABB tight = tightBounds(world, shape);
    // A static shape needs no margin, because the shapes that approach it have one.
    const bool moves = world.bodies.info[info.body].kind != BodyKind::Static;
    info.margin = moves ? marginOf(tight, world.settings) : 0.0f;
    world.shapes.bounds[shape] = grown(tight, info.margin + roundingAt(tight));
    noteChanged(world, shape);
    noteMoved(world, shape);
}

void refreshBounds(World& world, std::uint32_t body) {
    forShapesOf(world, body, [&](std::uint32_t s) { setBounds(world, s); });
}

void alter(World& world, std::uint32_t shape) {
    world.shapes.motion[shape] = motionOf(world, shape);
    setBounds(world, shape);
    std::uint8_t& flags = world.shapes.info[shape].flags;
    if ((flags & kAltered) != 0) return;
    flags |= kAltered;
    world.altered.push_back(shape);
}

void noteChanged(World& world, std::uint32_t shape) {
    if (world.work.stale()) return;  // the broad phase will be rebuilt
    Workspace& work = world.work.get();
    if (work.isChanged.size() < world.shapes.size()) work.isChanged.resize(world.shapes.size());
    if (work.isChanged[shape] != 0) return;
    work.isChanged[shape] = 1;
    work.changedProxies.push_back(shape);
}

void noteMoved(World& world, std::uint32_t shape) {
    ShapeInfo& info = world.shapes.info[shape];
    if ((info.flags & kLeftBounds) != 0) return;
    info.flags |= kLeftBounds;
    world.moved.push_back(shape);
}

void updateBroadPhase(World& world, Workspace& work) {
    refreshColours(world, work);  // first: takeStale() resets a flag that this reads
    const bool stale = world.work.takeStale();
    work.isChanged.resize(world.shapes.size());
    work.isMoved.resize(world.shapes.size());
    if (stale) {  // the world was created or overwritten: recompute derived data
        work.pairs.clear();
        countSurfaces(world, work);
        forContacts(world, [&](const Contact& c) { work.pairs.add(pairKey(c.shapeA, c.shapeB)); });
        work.joints.trees.stale = true;
    }
    if (stale || work.broadPhaseKind != world.settings.broadPhase) {
        if (work.broadPhase == nullptr || work.broadPhaseKind != world.settings.broadPhase)
            work.broadPhase = makeBroadPhase(world.settings.broadPhase);
        work.broadPhaseKind = world.settings.broadPhase;
        work.broadPhase->rebuild(proxiesOf(world));
        std::fill(work.isChanged.begin(), work.isChanged.end(), std::uint8_t{0});
    } else if (!work.changedProxies.empty()) {
        work.broadPhase->update(proxiesOf(world), work.changedProxies);
        for (const std::uint32_t shape : work.changedProxies) work.isChanged[shape] = 0;
    }
    work.changedProxies.clear();
}

void refreshContacts(World& world, std::uint32_t shape) {
    refreshThose(world, [&](const Contact& c) { return c.shapeA == shape || c.shapeB == shape; });
}

void refreshContactsOf(World& world, std::uint32_t body) {
    refreshThose(world, [&](const Contact& c) { return c.bodyA == body || c.bodyB == body; });
}

}  // namespace plumb::physics
