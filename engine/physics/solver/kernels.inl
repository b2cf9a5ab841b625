// Source of kernels_*.cpp. It may use only lanes.hpp and plain arrays: see there.

#include "physics/model/contact_rows.hpp"
#include "physics/solver/kernels.hpp"

namespace plumb::physics::PLUMB_LANES {

namespace {

struct Two8 {
    Float8 x, y;
};

inline Two8 turned(Float8 cosine, Float8 sine, Float8 x, Float8 y) {
    return {cosine * x - sine * y, sine * x + cosine * y};
}
inline Float8 dot8(Two8 a, Two8 b) { return a.x * b.x + a.y * b.y; }
inline Float8 cross8(Two8 a, Two8 b) { return a.x * b.y - a.y * b.x; }

/// 1/x, or 0 for 0: the effective mass of what cannot move.
inline Float8 inverseOrZero(Float8 x) {
    const Float8 zero = all(0.0f);
    const Mask8 some = x > zero;
    return select(some, all(1.0f) / select(some, x, all(1.0f)), zero);
}

// Contacts.

#include "physics/solver/contact_kernels.inl"
#include "physics/solver/kernels_without_rotation.inl"

// Bodies.

void accelerate(const SolverBodies& bodies, float h, bool first, int begin, int end) {
    const Float8 step = all(h);
    for (int i = 4 * begin; i < 4 * end; i += kLanes) {
        float* velocity = &bodies.velocity[0].x + i;
        float* velocityBeforeImpulses = &bodies.velocityBeforeImpulses[0].x + i;
        const Float8 now = load(velocity);
        const Float8 kept = bodies.keep != nullptr ? now * load(&bodies.keep[0].x + i) : now;
        const Float8 driven = kept + load(&bodies.drive[0].x + i) * step;
        store(velocity, first ? driven : driven + (now - load(velocityBeforeImpulses)));
        store(velocityBeforeImpulses, driven);
    }
}

/// A rotation as the solver keeps it: sine, and cosine - 1, which stays accurate for small angles.
struct Turn8 {
    Float8 sine, versine;
};

/// A rotation followed by one by `angle`. Series, accurate to 1e-7 below half a radian.
inline Turn8 turnedOn(Turn8 turn, Float8 angle) {
    const Float8 square = angle * angle;
    const Float8 s = angle * (all(1.0f) - square * (all(1.0f / 6.0f) - square * all(1.0f / 120.0f)));
    const Float8 v = -(square * (all(0.5f) - square * (all(1.0f / 24.0f) - square * all(1.0f / 720.0f))));
    return {turn.sine + (turn.sine * v + s + turn.versine * s),
            turn.versine + (v + turn.versine * v - turn.sine * s)};
}

/// The same for angles up to 8 rad, in sixteen steps.
inline Turn8 turnedFar(Turn8 turn, Float8 angle) {
    const Float8 part = clamp(angle, all(-8.0f), all(8.0f)) * all(1.0f / 16.0f);
    for (int i = 0; i < 16; ++i) turn = turnedOn(turn, part);
    return turn;
}

inline Turn8 turnedBy(Turn8 turn, Float8 angle) {
    const Turn8 near = turnedOn(turn, angle);
    const Mask8 far = abs(angle) > all(0.5f);
    if (bits(far) == 0) return near;
    const Turn8 slow = turnedFar(turn, angle);
    return {select(far, slow.sine, near.sine), select(far, slow.versine, near.versine)};
}

template <bool kTurns>
void move(const SolverBodies& bodies, float h, int begin, int end) {
    const Float8 step = all(h);
    for (int n = begin; n < end; n += kLanes) {
        std::int32_t slots[kLanes];
        for (int i = 0; i < kLanes; ++i) slots[i] = n + i;
        Float8 velocity[4], deltaPosition[4], ballisticDrift[4];
        gather(bodies.velocity, slots, velocity);
        gather(bodies.deltaPosition, slots, deltaPosition);
        gather(bodies.ballisticDrift, slots, ballisticDrift);
        deltaPosition[0] += velocity[0] * ballisticDrift[2] + ballisticDrift[0];
        deltaPosition[1] += velocity[1] * ballisticDrift[2] + ballisticDrift[1];
        if constexpr (kTurns) {
            const Turn8 turn = turnedBy({deltaPosition[2], deltaPosition[3]}, velocity[2] * step);
            deltaPosition[2] = turn.sine;
            deltaPosition[3] = turn.versine;
        }
        scatter(bodies.deltaPosition, slots, deltaPosition, kLanes);
    }
}

// Collision detection.

#include "physics/narrowphase/box_kernel.inl"

void collideBoxes(const BoxPairs& pairs, float speculative, BoxTouches& touches) {
    const BoxTouch touch =
        touchBoxes({load(pairs.halfAx), load(pairs.halfAy), load(pairs.halfBx), load(pairs.halfBy),
                            load(pairs.x), load(pairs.y), load(pairs.cosine), load(pairs.sine),
                            load(pairs.radiusA), load(pairs.radiusB), all(speculative)});
    store(touches.count, touch.count);
    if (!any(touch.count > all(0.0f))) return;
    store(touches.normalX, touch.normalX);
    store(touches.normalY, touch.normalY);
    for (int p = 0; p < 2; ++p) {
        store(touches.pointX[p], touch.pointX[p]);
        store(touches.pointY[p], touch.pointY[p]);
        store(touches.separation[p], touch.separation[p]);
        store(touches.id[p], touch.id[p]);
    }
    store(touches.roundA, touch.roundA);
    store(touches.roundB, touch.roundB);
}

}  // namespace

template <bool kHasFriction>
constexpr ContactKernels<ContactBlock> kContacts{prepare, warmStart<kHasFriction>, push<kHasFriction>,
                                                 relax<kHasFriction>,
                                                 storeImpulses<kHasFriction, ContactBlock>};
template <bool kHasFriction>
constexpr ContactKernels<FixedContactBlock> kFixedContacts{prepareFixed, warmStartFixed<kHasFriction>,
                                                           pushFixed<kHasFriction>, relaxFixed<kHasFriction>,
                                                           storeImpulses<kHasFriction, FixedContactBlock>};
template <bool kHasFriction, class Block>
constexpr ContactKernels<Block, BodiesWithoutRotation> kPlain{
    preparePlain<kHasFriction>, warmStartPlain<kHasFriction>, pushPlain<kHasFriction>,
    relaxPlain<kHasFriction>, storePlain<kHasFriction, Block>};

extern const SolverKernels kKernels;
const SolverKernels kKernels{
    PLUMB_LANES_NAME,
    {kContacts<false>, kContacts<true>},
    {kFixedContacts<false>, kFixedContacts<true>},
    {kPlain<false, BlockWithoutRotation>, kPlain<true, BlockWithoutRotation>},
    {kPlain<false, FixedBlockWithoutRotation>, kPlain<true, FixedBlockWithoutRotation>},
    accelerate,
    move<true>,
    move<false>,
    acceleratePlain,
    movePlain,
    collideBoxes,
};

}  // namespace plumb::physics::PLUMB_LANES
