#include "gameplay/character_motion.hpp"

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

constexpr int kMostTurns = 4;     // times that one way may be bent in one tick
constexpr float kGap = 0.03125f;  // px that are kept between a character and the world

/// The part of a way that leads into a surface is taken away.
Vec2 alongSurface(Vec2 way, Vec2 normal) { return way - normal * std::min(dot(way, normal), 0.0f); }

/// Down the slope of the ground by as much as dx goes.
Vec2 onGround(float dx, Vec2 normal) { return {dx, -dx * normal.x / normal.y}; }

}  // namespace

void CharacterMover::pushOut() {
    for (int i = 0; i < kMostTurns; ++i) {
        const auto hit = cast({});
        if (!hit || hit->separation >= 0.0f) return;
        shift(hit->normal * (kGap - hit->separation));
    }
}

void CharacterMover::carry(Vec2 way) {
    if (way == Vec2{}) return;
    const auto hit = cast(way);
    shift(way * (hit ? hit->fraction : 1.0f));
}

CharacterMotion CharacterMover::walk(float dx, Vec2 groundNormal) {
    CharacterMotion motion;
    Vec2 normal = isGround(groundNormal) ? groundNormal : Vec2{0.0f, -1.0f};
    for (int turn = 0; turn < kMostTurns && dx != 0.0f; ++turn) {
        const Vec2 way = onGround(dx, normal);
        const auto hit = cast(way);
        if (!hit) {
            shift(way);
            break;
        }
        shift(way * hit->fraction);
        dx *= 1.0f - hit->fraction;
        if (isGround(hit->normal)) {
            normal = hit->normal;
        } else if (hit->normal.y > 0.1f && normal.x != 0.0f) {
            break;  // a low ceiling over a slope
        } else {
            motion.hitWall = true;
            motion.wall = hit->entity;
            break;
        }
    }
    return motion;
}

CharacterMotion CharacterMover::fly(Vec2 way, float correction) {
    CharacterMotion motion;
    for (int turn = 0; turn < kMostTurns && way != Vec2{}; ++turn) {
        const auto hit = cast(way);
        if (!hit) {
            shift(way);
            break;
        }
        shift(way * hit->fraction);
        way *= 1.0f - hit->fraction;
        if (isGround(hit->normal)) {
            motion.landed = true;
            motion.ground = hit->entity;
            motion.groundNormal = hit->normal;
            walk(way.x, hit->normal);
            break;
        }
        if (hit->normal.y > 0.7f) {
            if (passCorner(way.y, correction, way.x)) continue;
            motion.hitCeiling = true;
        } else {
            motion.hitWall = motion.hitWall || std::abs(hit->normal.x) > 0.7f;
            motion.wall = hit->entity;
        }
        way = alongSurface(way, hit->normal);
    }
    return motion;
}

bool CharacterMover::passCorner(float rise, float correction, float preferred) {
    const float first = preferred < 0.0f ? -1.0f : 1.0f;
    for (float step = 1.0f; step <= correction; step += 1.0f) {
        for (const float side : {first, -first}) {
            const Vec2 aside{step * side, 0.0f};
            // Going against its own direction only helps who has none.
            if (side != first && preferred != 0.0f) continue;
            if (cast(aside)) continue;
            const AABB moved{box_.min + aside, box_.max + aside};
            if (castBox(world_, moved, {0.0f, std::min(rise, -1.0f)}, filter_)) continue;
            box_ = moved;
            return true;
        }
    }
    return false;
}

CharacterMotion CharacterMover::snapDown(float reach) {
    CharacterMotion motion;
    const auto hit = cast({0.0f, reach});
    if (!hit || !isGround(hit->normal)) return motion;
    shift({0.0f, reach * hit->fraction});
    motion.landed = true;
    motion.ground = hit->entity;
    motion.groundNormal = hit->normal;
    return motion;
}

bool CharacterMover::standsOn(float reach) const {
    const auto hit = cast({0.0f, reach});
    return hit && isGround(hit->normal);
}

}  // namespace plumb
