#include "physics/narrowphase/time_of_impact.hpp"

namespace plumb::physics {

namespace {

constexpr int kMostIterations = 64;

/// One body's part in how a gap closes.
struct Mover {
    const Convex& convex;
    const Sweep& sweep;
    float reach = 0.0f;  ///< m: of the core around the centre of mass

    Mover(const Convex& outline, const Sweep& motion) : convex{outline}, sweep{motion} {
        float square = 0.0f;
        for (const Corner& corner : convex.corners()) {
            const float far = lengthSquared(corner.point - sweep.localCentre);
            square = far > square ? far : square;
        }
        reach = std::sqrt(square);
    }
};

/// A mover seen along the normal, towards the other one.
struct Advance {
    const Mover& mover;
    Vec2 direction;       ///< in its own frame
    float extent = 0.0f;  ///< m: how far its core reaches along it now

    Advance(const Mover& moves, Rot rotation, Vec2 normal)
        : mover{moves}, direction{unrotate(rotation, normal)} {
        extent = along(static_cast<std::size_t>(farthest(mover.convex.corners(), direction)));
    }
    [[nodiscard]] float along(std::size_t corner) const { return dot(arm(corner), direction); }
    [[nodiscard]] Vec2 arm(std::size_t corner) const {
        return mover.convex.corners()[corner].point - mover.sweep.localCentre;
    }
    /// m: how much further it may reach after a part of the step. Taylor's bound on each corner: what it
    /// moves at first, and at most so much more on its circle. Convex in the part.
    [[nodiscard]] float growth(float part) const {
        const float turn = mover.sweep.turn * part;
        if (turn == 0.0f) return 0.0f;
        const float bend = 0.5f * turn * turn * mover.reach;
        float most = extent;
        for (std::size_t i = 0; i < mover.convex.corners().size(); ++i) {
            const float reached = along(i) + turn * dot(perpendicular(arm(i)), direction) + bend;
            most = reached > most ? reached : most;
        }
        return most - extent;
    }
    /// m: the same after any turn.
    [[nodiscard]] float room() const {
        return mover.sweep.turn == 0.0f ? 0.0f : std::max(mover.reach - extent, 0.0f);
    }
    [[nodiscard]] float spin() const { return std::fabs(mover.sweep.turn) * mover.reach; }
};

/// A part of the step in which a gap cannot close, up to `rest`.
/// @param speed  m per step at which the centres close in along the normal; may be negative
float safePart(float gap, float speed, const Advance& a, const Advance& b, float rest) {
    const auto until = [&](float left, float rate) {
        return left < 0.0f ? 0.0f : rate * rest > left ? left / rate : rest;
    };
    // Corners move no faster than the farthest, and reach no further.
    float safe = std::max(until(gap, speed + a.spin() + b.spin()), until(gap - a.room() - b.room(), speed));
    if (a.mover.sweep.turn == 0.0f && b.mover.sweep.turn == 0.0f) return safe;

    // What is left of the gap is concave in the part: above each of its chords, and safe wherever it is
    // positive.
    const auto left = [&](float part) { return gap - speed * part - a.growth(part) - b.growth(part); };
    float low = 0.0f;
    float high = rest;
    float lowLeft = gap;
    float highLeft = left(rest);
    if (highLeft >= 0.0f) return rest;
    for (int i = 0; i < 4 && lowLeft > 0.25f * kImpactTolerance; ++i) {
        for (const float part :
             {low + (high - low) * (lowLeft / (lowLeft - highLeft)), 0.5f * (low + high)}) {
            const float remains = left(part);
            (remains >= 0.0f ? low : high) = part;
            (remains >= 0.0f ? lowLeft : highLeft) = remains;
        }
    }
    return std::max(safe, low);
}

}  // namespace

Frame frameAt(const Sweep& sweep, float fraction) {
    const Rot rotation =
        sweep.turn == 0.0f ? sweep.rotation : sweep.rotation * rotFromAngle(sweep.turn * fraction);
    const Vec2 centre = lerp(sweep.start, sweep.end, fraction);
    return {centre - rotate(rotation, sweep.localCentre), rotation};
}

TimeOfImpact timeOfImpact(const Convex& a, const Sweep& sweepA, const Convex& b, const Sweep& sweepB,
                          float target) {
    const Mover moverA{a, sweepA};
    const Mover moverB{b, sweepB};
    const Vec2 approach = (sweepA.end - sweepA.start) - (sweepB.end - sweepB.start);
    SimplexCache cache;
    TimeOfImpact impact{.state = SweepState::Failed, .fraction = 0.0f};
    while (impact.iterations < kMostIterations) {
        const Frame frameA = frameAt(sweepA, impact.fraction);
        const Frame frameB = frameAt(sweepB, impact.fraction);
        const Distance apart = distanceBetween(a, b, inverse(frameA) * frameB, &cache);
        impact.normal = rotate(frameA.rotation, apart.normal);
        const float gap = apart.distance - target;
        if (!(gap > kImpactTolerance)) {
            impact.state = impact.iterations == 0 && !(gap > 0.0f) ? SweepState::Overlapped : SweepState::Hit;
            return impact;
        }
        ++impact.iterations;
        const Advance advanceA{moverA, frameA.rotation, impact.normal};
        const Advance advanceB{moverB, frameB.rotation, -impact.normal};
        const float rest = 1.0f - impact.fraction;
        const float part =
            safePart(gap - 0.5f * kImpactTolerance, dot(approach, impact.normal), advanceA, advanceB, rest);
        const float next = impact.fraction + part;
        if (!(next < 1.0f) || part >= rest) return {.iterations = impact.iterations};
        if (next == impact.fraction) {  // nothing between two floats is left to wait for
            impact.state = SweepState::Hit;
            return impact;
        }
        impact.fraction = next;
    }
    return impact;
}

}  // namespace plumb::physics
