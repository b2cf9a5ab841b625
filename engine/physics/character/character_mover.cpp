#include "physics/character/character_mover.hpp"

#include <algorithm>

#include "physics/shapes/shape_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

constexpr int kMaxPushes = 16;  // maximum number of iterations of pushOut()

/// Removes the component of a displacement that leads into a surface.
Vec2 alongSurface(Vec2 displacement, Vec2 normal) {
    return displacement - normal * std::min(dot(displacement, normal), 0.0f);
}

}  // namespace

CharacterMover::CharacterMover(World& world, const CharacterDefinition& definition, WorldPosition position,
                               float dt)
    : definition_{definition},
      probe_{world, definition, dt},
      position_{position},
      right_{perpendicular(definition.up)},
      steepest_{cosine(definition.steepest) - kSlopeSlack},
      feet_{reachAlong(convexOf(definition.outline, {}), -definition.up)} {}

/// On a corner of a floor, a round outline has a normal between those of two faces; uses that of the floor.
std::optional<Vec2> CharacterMover::groundNormalOf(const CastHit& hit) const {
    const Vec2 normal = hit.normal;
    if (isGround(normal)) return normal;
    if (definition_.outline.radius == 0.0f || rise(normal) < kRoundCorner) return std::nullopt;
    const float gap = definition_.gap;
    const float inward = along(normal) > 0.0f ? -3.0f * gap : 3.0f * gap;
    const WorldPosition over = hit.point + (right_ * inward + definition_.up * (5.0f * gap));
    const auto floor = probe_.cast(circle(gap), over, definition_.up * (-8.0f * gap));
    if (!floor || !isGround(floor->normal)) return std::nullopt;
    return floor->normal;
}

void CharacterMover::note(CharacterMotion& motion, const CharacterTouch& touch) const {
    const float up = rise(touch.normal);
    (up > kAxisAligned ? motion.slope : up < -kSolidSide ? motion.ceiling : motion.wall) = touch;
}

CharacterTouch CharacterMover::pushOut() {
    const WorldPosition before = position_;
    const float gap = definition_.gap;
    for (int i = 0; i < kMaxPushes; ++i) {
        const auto hit = probe_.nearest(position_, 0.5f * gap);
        if (!hit) return {};
        shift(hit->normal * (gap - hit->separation));
    }
    const auto hit = probe_.nearest(position_, -0.5f * gap);
    if (!hit) return {};
    position_ = before;
    return touchOf(*hit);
}

bool CharacterMover::escape() {
    const WorldPosition before = position_;
    const Vec2 up = definition_.up, right = right_;
    const Vec2 extent = boundsOf(definition_.outline, {}, {}).size();
    const float size = 0.125f * std::min(extent.x, extent.y);
    for (int ring = 1; ring <= 32; ++ring) {
        for (const Vec2 displacement :
             {up, right, -right, up + right, up - right, -up, right - up, -right - up}) {
            position_ = before + displacement * (size * static_cast<float>(ring));
            if (!probe_.nearest(position_, 0.0f)) return true;
        }
    }
    position_ = before;
    return false;
}

bool CharacterMover::carryTo(WorldPosition place) {
    Vec2 displacement = place - position_;
    for (int iteration = 0; iteration < kMoverTurns; ++iteration) {
        const auto hit = advance(displacement);
        if (!hit && iteration == 0) position_ = place;  // the exact target, without rounding
        if (!hit) return iteration == 0;
        displacement = alongSurface(displacement * (1.0f - hit->fraction), hit->normal);
    }
    return false;
}

Vec2 CharacterMover::giveWay(const CharacterProbe::Pushes& pushes, Vec2 own) {
    float met = 1.0f;
    for (const CharacterProbe::Push& push : pushes) met = std::min(met, push.fraction);
    for (const CharacterProbe::Push& push : pushes) {
        probe_.carrier = push.body;
        if (&push == pushes.begin()) advance(own * met);
        advance(push.displacement);
        if ((probe_.world().shapes.info[push.shape.index].flags & kOneWay) != 0) probe_.floor = push.shape;
    }
    probe_.carrier = {};
    return pushes.empty() ? own : own * (1.0f - met);
}

void CharacterMover::settle(float reach) {
    const Vec2 lift = definition_.up * reach;
    const auto above = cast(lift);
    const float raised = reach * (above ? above->fraction : 1.0f);
    const WorldPosition from = position_ + definition_.up * raised;
    const auto floor = probe_.cast(from, definition_.up * -(raised + reach));
    if (floor) position_ = from + definition_.up * (-(raised + reach) * floor->fraction);
}

/// Climbs a step: moves up, forward and down.
/// @return false if there is no step that is low enough; the position is then unchanged
bool CharacterMover::stepUp(float dx) {
    if (!(definition_.stepHeight > 0.0f)) return false;
    const Vec2 up = definition_.up;
    const float gap = definition_.gap;
    const auto above = cast(up * definition_.stepHeight);
    const float raised = definition_.stepHeight * (above ? above->fraction : 1.0f);
    WorldPosition place = position_ + up * raised;
    const float onto = std::max(std::fabs(dx), 4.0f * gap + kRoundReach * definition_.outline.radius);
    const Vec2 forward = right_ * (dx < 0.0f ? -onto : onto);
    const auto ahead = probe_.cast(place, forward);
    if (ahead && ahead->fraction * onto < 2.0f * gap) return false;
    place = place + forward * (ahead ? ahead->fraction : 1.0f);
    const auto floor = probe_.cast(place, up * -raised);
    if (!floor || !groundNormalOf(*floor)) return false;
    // A round outline could also slide over the corner of a higher step.
    const float height = rise(floor->point - position_) + feet_ + gap;
    if (height > definition_.stepHeight + 0.5f * gap) return false;
    place = place + up * (-raised * floor->fraction);
    if (!(raised * (1.0f - floor->fraction) > 0.1f * gap)) return false;
    position_ = place;
    return true;
}

CharacterMotion CharacterMover::walk(float dx, Vec2 groundNormal) {
    CharacterMotion motion;
    Vec2 normal = isGround(groundNormal) ? groundNormal : definition_.up;
    for (int iteration = 0; iteration < kMoverTurns && dx != 0.0f; ++iteration) {
        const auto hit = advance(onGround(dx, normal));
        if (!hit) break;
        dx *= 1.0f - hit->fraction;
        if (isGround(hit->normal)) {
            normal = hit->normal;
            continue;
        }
        if (!stepUp(dx)) note(motion, touchOf(*hit));
        break;
    }
    return motion;
}

CharacterMotion CharacterMover::fly(Vec2 displacement) {
    CharacterMotion motion;
    Vec2 before;  // normal of the last surface along which it slid
    for (int iteration = 0; iteration < kMoverTurns && displacement != Vec2{}; ++iteration) {
        const auto hit = advance(displacement);
        if (!hit) break;
        const Vec2 normal = hit->normal;
        displacement *= 1.0f - hit->fraction;
        const auto ground = rise(displacement) <= 0.0f ? groundNormalOf(*hit) : std::nullopt;
        if (ground) {
            const CharacterMotion walked = walk(along(displacement), *ground);
            motion.wall = walked.wall ? walked.wall : motion.wall;
            motion.ground = touchOf(*hit, ground);
            break;
        }
        if (rise(normal) < -kSolidSide && rise(displacement) > 0.0f && passCorner(displacement)) continue;
        note(motion, touchOf(*hit));
        displacement = alongSurface(displacement, normal);
        const bool wedged =
            before != Vec2{} && dot(before, normal) < 0.999f && dot(displacement, before) < 0.0f;
        if (wedged && rise(before) > kAxisAligned && rise(normal) > kAxisAligned) {
            // A character wedged between two slopes counts as standing.
            motion.ground = touchOf(*hit, definition_.up);
        }
        if (wedged) break;
        before = normal;
    }
    return motion;
}

bool CharacterMover::passCorner(Vec2 displacement) {
    const float step = definition_.cornerCorrection / static_cast<float>(kCornerTries);
    const float aim = along(displacement);
    const float first = aim < 0.0f ? -1.0f : 1.0f;
    const Vec2 rising = definition_.up * std::max(rise(displacement), 4.0f * definition_.gap);
    for (int i = 1; i <= kCornerTries && step > 0.0f; ++i) {
        for (const float side : {first, -first}) {
            // Corrections against the direction of motion are tried only without a sideways motion.
            if (side != first && aim != 0.0f) continue;
            const Vec2 aside = right_ * (side * step * static_cast<float>(i));
            const WorldPosition place = position_ + aside;
            if (cast(aside) || probe_.cast(place, rising)) continue;
            position_ = place;
            return true;
        }
    }
    return false;
}

CharacterTouch CharacterMover::snapDown(float reach) {
    auto hit = cast(definition_.up * -reach);
    auto normal = hit ? groundNormalOf(*hit) : std::nullopt;
    if (hit && !normal) {
        // The rear of the outline may rest on the corner that it has just passed.
        const Vec2 aside = right_ * (along(hit->normal) < 0.0f ? -definition_.gap : definition_.gap);
        const WorldPosition place = position_ + aside;
        hit = cast(aside) ? std::nullopt : probe_.cast(place, definition_.up * -reach);
        normal = hit ? groundNormalOf(*hit) : std::nullopt;
        if (normal) position_ = place;
    }
    if (!normal) return {};
    const float drop = reach * hit->fraction;
    // Ignores small drops, or a character at rest would creep.
    if (drop > 0.0625f * definition_.gap) shift(definition_.up * -drop);
    return touchOf(*hit, normal);
}

CharacterMotion CharacterMover::walkOnGround(float dx, Vec2 groundNormal) {
    CharacterMotion motion;
    const float pieces = std::ceil(std::fabs(dx) * steepestSlope() / std::max(definition_.snap, 1.0e-3f));
    const int count = static_cast<int>(std::clamp(pieces, 1.0f, kMaxPieces));
    const float piece = dx / static_cast<float>(count);
    const float drop = std::max(definition_.snap, std::fabs(piece) * steepestSlope());
    Vec2 normal = groundNormal;
    for (int i = 0; i < count; ++i) {
        const WorldPosition before = position_;
        motion = walk(piece, normal);
        const bool stopped = motion.wall || motion.slope || motion.ceiling;
        const float climbed = std::max(rise(position_ - before), 0.0f);
        motion.ground = snapDown(drop + climbed + 2.0f * definition_.gap);
        if (!motion.ground && !stopped) return fly(right_ * (piece * static_cast<float>(count - 1 - i)));
        if (!motion.ground || stopped) return motion;
        normal = motion.ground.normal;
    }
    return motion;
}

}  // namespace plumb::physics
