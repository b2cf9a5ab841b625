#include <algorithm>

#include "physics/broadphase/overlap.hpp"
#include "physics/contacts/contacts.hpp"
#include "physics/narrowphase/reference_face.hpp"
#include "physics/shapes/shape_types.hpp"
#include "physics/stages.hpp"

namespace plumb::physics {

namespace {

constexpr int kSeamGrain = 32;  // bodies that a thread takes at a time

/// Position of a point relative to an outline, and the normals of the first and the last edge at the point.
struct EdgesAt {
    Vec2 first, last;
    bool isAt = false;      // the point is on the outline or inside
    bool isInside = false;  // the point is inside, farther from all edges than the tolerance
};

EdgesAt edgesAt(const Convex& outline, Vec2 point, float tolerance) {
    EdgesAt edges;
    if (outline.radius > 0.0f) {
        const ClosestPoint closest = closestPointOf(outline, point);
        return {closest.normal, closest.normal, closest.distance <= tolerance, closest.distance < -tolerance};
    }
    const std::span<const Corner> corners = outline.corners();
    const auto heightOver = [&](const Corner& face) { return dot(face.normal, point - face.point); };
    bool before = heightOver(corners.back()) >= -tolerance;
    edges.isInside = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const float height = heightOver(corners[i]);
        if (!(height <= tolerance)) return {};
        const bool is = height >= -tolerance;
        if (is) edges.isInside = false;
        if (is && !before) edges.first = corners[i].normal;
        if (!is && before) edges.last = corners[i > 0 ? i - 1 : corners.size() - 1].normal;
        before = is;
    }
    edges.isAt = edges.isInside || edges.first != Vec2{};  // false: outline smaller than the tolerance
    return edges;
}

/// The sector of directions at a point that no outline around it covers. Adjacent outlines have one common
/// border: contacts must have normals of this border, not of interior edges.
class FreeSector {
public:
    /// @param inside  a free direction: towards the middle of the body that touches the outlines at the point
    /// @param tolerance  m: outlines closer than this to the point cover a sector
    FreeSector(Vec2 point, Vec2 inside, float tolerance)
        : point_{point}, inside_{inside}, tolerance_{tolerance} {}

    /// Removes the sector that an outline covers. Must first be called for the outline of the contact.
    /// @return false if the outline is not at the point
    bool cover(const Convex& outline, const Frame& frame) {
        const Vec2 place = applyInverse(frame, point_);
        const EdgesAt edges = edgesAt(outline, place, tolerance_);
        if (!edges.isAt) return false;
        const Vec2 first = rotate(frame.rotation, edges.first), last = rotate(frame.rotation, edges.last);
        const Border start{angleFrom(-perpendicular(first)), first},
            end{angleFrom(perpendicular(last)), last};
        isCovered_ = isCovered_ || edges.isInside || end.angle > start.angle;
        if (start.angle > start_.angle) start_ = start;
        if (end.angle < end_.angle) end_ = end;
        if (!ownStart_) {
            ownStart_ = start;
            ownEnd_ = end;
        }
        return true;
    }

    /// True if the outlines surround the point, or cover the direction `inside`.
    [[nodiscard]] bool isClosed() const { return isCovered_ || end_.angle + 4.0f - start_.angle < kParallel; }
    /// True if the common border is straight.
    [[nodiscard]] bool isFlat() const { return dot(start_.normal, end_.normal) > 1.0f - kSameNormal; }
    /// True if the normal is a normal of the common border or, at a corner, between the two normals.
    [[nodiscard]] bool allows(Vec2 normal) const {
        // A normal between two others differs from their middle by at most half of their angle.
        const Vec2 middle = normalized(start_.normal + end_.normal);
        return dot(normal, middle) >= dot(start_.normal, middle) - kSameNormal;
    }
    /// Returns the first outline's border normal nearest to a given one, if it has a part of the border.
    [[nodiscard]] std::optional<Vec2> ownNormal(Vec2 normal) const {
        const bool starts = ownStart_->angle > start_.angle - kParallel;
        const bool ends = ownEnd_->angle < end_.angle + kParallel;
        if (!starts && !ends) return std::nullopt;
        const bool nearer = dot(ownStart_->normal, normal) > dot(ownEnd_->normal, normal);
        return starts && (!ends || nearer) ? ownStart_->normal : ownEnd_->normal;
    }

private:
    /// A border of a covered sector.
    struct Border {
        float angle;  ///< counterclockwise from `inside`, see angleFrom()
        Vec2 normal;  ///< outward
    };
    /// Returns a measure of the angle that increases by 1 for each quarter turn, from 0 to 4.
    [[nodiscard]] float angleFrom(Vec2 direction) const {
        const float along = dot(inside_, direction), across = cross(inside_, direction);
        const float part = along / (std::fabs(along) + std::fabs(across));
        return across >= 0.0f ? 1.0f - part : 3.0f + part;
    }

    Vec2 point_;
    Vec2 inside_;
    float tolerance_;
    bool isCovered_ = false;  ///< the direction `inside` is covered
    Border end_{4.0f, {}};    ///< ends of the free sector: the borders of the nearest outlines
    Border start_{-1.0f, {}};
    std::optional<Border> ownEnd_, ownStart_;
};

/// True for shapes that may have seams with adjacent ones. Chains have ghost vertices instead.
bool abuts(ShapeKind kind) { return kind == ShapeKind::Box || kind == ShapeKind::Polygon; }

struct BodyContacts {
    World& world;
    const std::vector<FixedPair>& pairs;
    std::uint32_t first;

    template <class Act>
    void forEach(Act&& act) const {
        for (std::uint32_t i = first; i != kNone; i = pairs[i].next) act(world.contacts[pairs[i].contact]);
    }
};

/// Result of testing a contact against the shapes adjacent to A.
struct Verdict {
    bool abut = false;           ///< there are adjacent shapes at its points
    bool touch = false;          ///< one of these shapes also touches B
    bool isValid = true;         ///< its normal is a normal of the common border
    std::optional<Vec2> normal;  ///< in A's frame, if invalid: A's nearest border normal
};

/// True if two bodies have equal velocities at a point `place`. Otherwise their shapes have no seam there.
bool moveAsOne(const World& world, std::uint32_t a, std::uint32_t b, Vec2 place) {
    if (a == b) return true;
    const auto velocityAt = [&](std::uint32_t body) {
        const BodyMotion& motion = world.bodies.motion[body];
        return motion.velocity +
               cross(motion.angularVelocity, place - toVec2(world.bodies.pose[body].centre));
    };
    const float apart = kFlush * world.settings.slop / world.stepLength;
    return lengthSquared(velocityAt(a) - velocityAt(b)) <= apart * apart;
}

/// Removes the sectors covered by other static or kinematic shapes from the free sector.
/// @param point  in the frame of A's shapes
/// @param others  calls a function with each of these shapes, and true if it touches B
template <class Others>
void coverByOthers(const World& world, const Contact& contact, Vec2 point, const Others& others,
                   FreeSector& sector, Verdict& verdict) {
    const Shapes& shapes = world.shapes;
    const BodyPose& pose = world.bodies.pose[contact.bodyA];
    const Vec2 place = toVec2(pose.centre + rotate(pose.rotation, point - pose.localCentre));
    const float tolerance = kFlush * world.settings.slop;
    const AABB box{place - Vec2{tolerance, tolerance}, place + Vec2{tolerance, tolerance}};
    others([&](std::uint32_t shape, bool touches) {
        const Geometry& geometry = shapes.geometry[shape];
        if (shape == contact.shapeA || !abuts(geometry.kind) || !touch(shapes.bounds[shape], box)) return;
        if (!moveAsOne(world, contact.bodyA, shapes.info[shape].body, place)) return;
        const Frame frame = relativeFrame(pose, world.bodies.pose[shapes.info[shape].body]);
        if (!sector.cover(convexOf(geometry, shapes.corners), frame)) return;
        verdict.abut = true;
        verdict.touch = verdict.touch || touches;
    });
}

/// Returns the point nearest to `place` on the face with this normal.
Vec2 nearestOnFace(const Convex& outline, Vec2 normal, Vec2 place) {
    const std::span<const Corner> corners = outline.corners();
    const std::size_t face = faceAgainst(corners, -normal);
    const Vec2 from = corners[face].point;
    const Vec2 edge = corners[face + 1 < corners.size() ? face + 1 : 0].point - from;
    return from + std::clamp(dot(place - from, edge) / lengthSquared(edge), 0.0f, 1.0f) * edge;
}

/// True if a shape contains the middle of B. Then B is squeezed, and none of its contacts is interior.
/// @param middle  in the frame of A's shapes
template <class Others>
bool isInside(const World& world, const Contact& contact, Vec2 middle, const Others& others) {
    const Shapes& shapes = world.shapes;
    bool inside = false;
    const auto look = [&](std::uint32_t shape) {
        const Convex outline = convexOf(shapes.geometry[shape], shapes.corners);
        const BodyPose& pose = world.bodies.pose[shapes.info[shape].body];
        const Vec2 point = apply(relativeFrame(pose, world.bodies.pose[contact.bodyA]), middle);
        const std::span<const Corner> corners = outline.corners();
        inside = inside || std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
                     return dot(corner.normal, point - corner.point) < 0.0f;
                 });
    };
    look(contact.shapeA);
    others([&](std::uint32_t shape, bool) {
        if (abuts(shapes.geometry[shape].kind)) look(shape);
    });
    return inside;
}

/// Tests a contact at its deepest point that is not inside the other shapes.
template <class Others>
Verdict judge(const World& world, const Contact& contact, const Others& others) {
    const BodyPose& poseA = world.bodies.pose[contact.bodyA];
    const Vec2 normal = unrotate(poseA.rotation, contact.normal);
    const Convex a = convexOf(world.shapes.geometry[contact.shapeA], world.shapes.corners);
    const Convex b = convexOf(world.shapes.geometry[contact.shapeB], world.shapes.corners);
    const Vec2 middle = apply(relativeFrame(poseA, world.bodies.pose[contact.bodyB]), b.centre);
    const float tolerance = kFlush * world.settings.slop;
    Verdict verdict;
    std::optional<FreeSector> deepest;
    float depth = std::numeric_limits<float>::max();
    for (int i = 0; i < contact.count; ++i) {
        const Vec2 point = contact.anchors[i].a + poseA.localCentre;
        FreeSector sector{point, middle - point, tolerance};
        if (!sector.cover(a, {})) continue;
        const bool isDeep = sector.isClosed();  // true if the middle of B is behind the border of A
        Verdict here;
        coverByOthers(world, contact, point, others, sector, here);
        if (isDeep && (!here.abut || isInside(world, contact, middle, others))) return {};
        verdict.abut = verdict.abut || here.abut;
        verdict.touch = verdict.touch || here.touch;
        if (sector.isClosed()) {
            // B is deep in a corner between two faces: tests A's face near B too.
            const Vec2 place = nearestOnFace(a, normal, middle);
            FreeSector beside{place, middle - place, tolerance};
            if (beside.cover(a, {})) coverByOthers(world, contact, place, others, beside, here);
            if (!beside.isClosed() && beside.allows(normal)) return {};
            continue;
        }
        // Of two points of nearly equal depth, prefers the one with an allowed normal.
        const float separation =
            (i == 0 ? contact.separation0 : contact.separation1) + (sector.allows(normal) ? tolerance : 0.0f);
        if (separation >= depth) continue;
        deepest = sector;
        depth = separation;
    }
    verdict.isValid = !verdict.abut || (deepest && deepest->allows(normal));
    if (deepest) verdict.normal = deepest->ownNormal(normal);
    return verdict;
}

void correct(const BodyContacts& all, Contact& contact) {
    World& world = all.world;
    if (contact.count == 0 || !abuts(world.shapes.geometry[contact.shapeA].kind)) return;
    const Verdict verdict = judge(world, contact, [&](auto&& act) {
        all.forEach([&](const Contact& other) { act(other.shapeA, other.count > 0); });
    });
    if (verdict.isValid) return;
    const Contact before = contact;
    const float tolerance = kFlush * world.settings.slop;
    if (verdict.normal) {
        touchFaceOnly(world, contact,
                      {*verdict.normal, {tolerance, tolerance}, world.settings.speculativeDistance});
    } else {
        clearPoints(contact);
    }
    const bool overlaps = std::min(before.separation0, before.separation1) <= 0.0f;
    // Otherwise no contact would support B.
    if (contact.count == 0 && overlaps && !verdict.touch) contact = before;
}

/// True if all contacts of a body have equal normals. Then none of them is of an interior edge.
bool agree(const BodyContacts& all) {
    Vec2 normal;
    bool agrees = true;
    all.forEach([&](const Contact& contact) {
        if (contact.count == 0) return;
        if (normal == Vec2{}) normal = contact.normal;
        agrees = agrees && dot(normal, contact.normal) > 1.0f - kSameNormal;
    });
    return agrees;
}

/// Builds a linked list of the contacts of each body, and collects bodies with several contacts.
void link(const World& world, Workspace& work) {
    work.fixedPairs.clear();
    work.seamBodies.clear();
    work.firstFixedPair.resize(world.bodies.size());
    std::vector<FixedPair>& all = work.fixedPairs;
    for (const ContactFindings& found : work.contactFindings)
        all.insert(all.end(), found.fixed.begin(), found.fixed.end());
    const std::span<FixedPair> pairs{all};
    const std::span<std::uint32_t> firsts{work.firstFixedPair};
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        std::uint32_t& first = firsts[pairs[i].body];
        if (first < i && pairs[first].body == pairs[i].body) {  // otherwise the entry is from an earlier step
            if (pairs[first].next == kNone) work.seamBodies.push_back(pairs[i].body);
            pairs[i].next = first;
        }
        first = i;
    }
}

/// Finds the static and kinematic shapes near B with which B may collide.
const std::vector<std::uint32_t>& fixedNear(StepContext& step, const Contact& contact, float distance) {
    const World& world = step.world;
    const Shapes& shapes = world.shapes;
    std::vector<std::uint32_t>& found = step.work.candidates;
    found.clear();
    const Vec2 place = toVec2(world.bodies.pose[contact.bodyB].centre), half{distance, distance};
    step.work.broadPhase->query({place - half, place + half}, 0xffffffffu, found);
    std::erase_if(found, [&](std::uint32_t shape) {
        const ShapeInfo& info = shapes.info[shape];
        return isDynamic(world, info.body) || !needsContact(world, shape, contact.shapeB) ||
               (info.flags & (kTrigger | kOneWay)) != 0 ||
               !mayCollide(shapes.filter[shape], shapes.filter[contact.shapeB]);
    });
    std::sort(found.begin(), found.end());
    return found;
}

/// True if another shape continues a face of A.
/// @param point  end of the face
template <class Others>
bool goesOn(const World& world, const Contact& contact, const Convex& a, Vec2 point, Vec2 normal,
            const Others& others) {
    FreeSector sector{point, normal, kFlush * world.settings.slop};
    Verdict verdict;
    static_cast<void>(sector.cover(a, {}));
    coverByOthers(world, contact, point, others, sector, verdict);
    return verdict.abut && !sector.isClosed() && sector.isFlat();
}

}  // namespace

void touchUnion(StepContext& step, Contact& contact) {
    const World& world = step.world;
    const Geometry& geometry = world.shapes.geometry[contact.shapeA];
    if (contact.count == 0 || (contact.flags & kFixedA) == 0 || !abuts(geometry.kind)) return;
    const float distance = 2.0f * world.bodies.info[contact.bodyB].reach;
    const std::vector<std::uint32_t>& fixed = fixedNear(step, contact, distance);
    const auto others = [&](auto&& act) {
        for (const std::uint32_t shape : fixed) act(shape, true);
    };
    const Verdict verdict = judge(world, contact, others);
    Vec2 normal = unrotate(world.bodies.pose[contact.bodyA].rotation, contact.normal);
    if (!verdict.isValid) normal = verdict.normal.value_or(normal);
    const Convex a = convexOf(geometry, world.shapes.corners);
    const std::span<const Corner> corners = a.corners();
    const std::size_t face = faceAgainst(corners, -normal);
    if (dot(corners[face].normal, normal) < 1.0f - kSameNormal) return;
    const Vec2 end = corners[face + 1 < corners.size() ? face + 1 : 0].point;
    const Vec2 beyond{goesOn(world, contact, a, corners[face].point, normal, others) ? distance : 0.0f,
                      goesOn(world, contact, a, end, normal, others) ? distance : 0.0f};
    if (verdict.isValid && beyond == Vec2{}) return;
    const Contact before = contact;
    touchFaceOnly(world, contact, {normal, beyond, 0.5f * distance});
    if (contact.count == 0) contact = before;
}

void correctSeams(StepContext& step) {
    World& world = step.world;
    Workspace& work = step.work;
    link(world, work);
    const auto contactsOf = [&](std::uint32_t body) {
        return BodyContacts{world, work.fixedPairs, work.firstFixedPair[body]};
    };
    forEach(step.pool, work.seamBodies.size(), kSeamGrain, [&](std::size_t i) {
        const BodyContacts all = contactsOf(work.seamBodies[i]);
        if (!agree(all)) all.forEach([&](Contact& contact) { correct(all, contact); });
    });
    work.endedAtSeams.clear();
    for (const std::uint32_t body : work.seamBodies) {
        contactsOf(body).forEach([&](const Contact& contact) {
            if (contact.count == 0 && (contact.flags & kTouching) != 0)
                work.endedAtSeams.push_back(static_cast<std::uint32_t>(&contact - world.contacts.data()));
        });
    }
}

}  // namespace plumb::physics
