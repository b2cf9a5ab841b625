// Source of kernels_*.cpp. It may use only lanes.hpp (which explains this) and plain arrays.

#include "physics/kernels.hpp"

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
inline Two8 operator+(Two8 a, Two8 b) { return {a.x + b.x, a.y + b.y}; }
inline Two8 operator-(Two8 a, Two8 b) { return {a.x - b.x, a.y - b.y}; }
inline Two8 operator*(Float8 s, Two8 a) { return {s * a.x, s * a.y}; }
inline Two8 load2(const VecLanes& from) { return {load(from.x), load(from.y)}; }
inline void store2(VecLanes& to, Two8 a) { store(to.x, a.x), store(to.y, a.y); }

/// Returns 1/x, or 0 for x = 0: the effective mass of a body that cannot move.
inline Float8 inverseOrZero(Float8 x) {
    const Float8 zero = all(0.0f);
    const Mask8 some = x > zero;
    return select(some, all(1.0f) / select(some, x, all(1.0f)), zero);
}

#include "physics/solver/contact_kernels.inl"
#include "physics/solver/contact_preparation.inl"
#include "physics/solver/joint_kernels.inl"

// Bodies.

/// 1 for the velocities in two rows of BodiesWithoutRotation::velocity, 0 for the displacements.
alignas(32) constexpr float kIsSpeed[kLanes] = {1.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f};

template <class Bodies>
void accelerate(const Bodies& bodies, float h, bool first, int begin, int end) {
    const Float8 step = all(h);
    for (int i = 4 * begin; i < 4 * end; i += kLanes) {
        const auto offset = static_cast<std::uint32_t>(i) * std::uint32_t{sizeof(float)};
        float* velocity = rowOf(bodies.velocity, offset);
        float* velocityBeforeImpulses = rowOf(bodies.velocityBeforeImpulses, offset);
        const Float8 now = load(velocity);
        const Float8 kept = bodies.keep != nullptr ? now * load(rowOf(bodies.keep, offset)) : now;
        const Float8 driven = kept + load(rowOf(bodies.drive, offset)) * step;
        const Float8 after = first ? driven : driven + (now - load(velocityBeforeImpulses));
        store(velocity, Bodies::kRotate ? after : select(load(kIsSpeed) > all(0.0f), after, now));
        store(velocityBeforeImpulses, driven);
    }
}

/// Rotations of eight bodies as sine and cosine - 1, which is accurate for small angles.
struct Turn8 {
    Float8 sine, versine;
};

/// Returns a rotation, rotated further by `angle`. Series, accurate to 1e-7 below half a radian.
inline Turn8 turnedOn(Turn8 turn, Float8 angle) {
    const Float8 square = angle * angle;
    const Float8 s = angle * (all(1.0f) - square * (all(1.0f / 6.0f) - square * all(1.0f / 120.0f)));
    const Float8 v = -(square * (all(0.5f) - square * (all(1.0f / 24.0f) - square * all(1.0f / 720.0f))));
    return {turn.sine + (turn.sine * v + s + turn.versine * s),
            turn.versine + (v + turn.versine * v - turn.sine * s)};
}

/// Angles above half a radian, up to 8 rad, take sixteen steps.
inline Turn8 turnedBy(Turn8 turn, Float8 angle) {
    const Turn8 near = turnedOn(turn, angle);
    const Mask8 far = abs(angle) > all(0.5f);
    if (bits(far) == 0) return near;
    const Float8 part = clamp(angle, all(-8.0f), all(8.0f)) * all(1.0f / 16.0f);
    for (int i = 0; i < 16; ++i) turn = turnedOn(turn, part);
    return {select(far, turn.sine, near.sine), select(far, turn.versine, near.versine)};
}

template <bool kTurns = true>
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

void move(const BodiesWithoutRotation& bodies, float, int begin, int end) {
    for (int n = begin; n < end; n += kLanes) {
        std::int32_t slots[kLanes];
        for (int i = 0; i < kLanes; ++i) slots[i] = n + i;
        Float8 state[4], ballisticDrift[4];
        gather(bodies.velocity, slots, state);
        gather(bodies.ballisticDrift, slots, ballisticDrift);
        state[2] += state[0] * ballisticDrift[2] + ballisticDrift[0];
        state[3] += state[1] * ballisticDrift[2] + ballisticDrift[1];
        scatter(bodies.velocity, slots, state, kLanes);
    }
}

#include "physics/narrowphase/box_kernel.inl"

void collideBoxes(const BoxPairs& pairs, float speculative, BoxTouches& touches) {
    BoxPair pair;
    static_assert(sizeof pair == sizeof pairs && sizeof(BoxTouch) == sizeof touches);
    __builtin_memcpy(&pair, &pairs, sizeof pair);
    const BoxTouch touch = touchBoxes(pair, all(speculative));
    store(touches.count, touch.count);
    if (any(touch.count > all(0.0f))) __builtin_memcpy(&touches, &touch, sizeof touch);
}

}  // namespace

template <bool kHasFriction, class Block, class Bodies>
constexpr ContactKernels<Block, Bodies> kContacts{
    prepare<kHasFriction>,
    {warmStart<kHasFriction>, push<kHasFriction>, relax<kHasFriction>},
    storeImpulses<kHasFriction>};

template <class Bodies, class Two = typename Bodies::TwoBlock, class Fixed = typename Bodies::FixedBlock>
constexpr GroupKernels<Bodies> kGroups{{kContacts<false, Two, Bodies>, kContacts<true, Two, Bodies>},
                                       {kContacts<false, Fixed, Bodies>, kContacts<true, Fixed, Bodies>},
                                       accelerate<Bodies>,
                                       move};

template <class Block>
constexpr JointPasses<Block> kPasses{{{warmStartJoints<false>, warmStartJoints<true>},
                                      {answerJoints<true, false>, answerJoints<true, true>},
                                      {answerJoints<false, false>, answerJoints<false, true>}}};

#define PLUMB_NAME(lanes) #lanes
#define PLUMB_NAME_OF(lanes) PLUMB_NAME(lanes)

extern const SolverKernels kKernels;
const SolverKernels kKernels{
    PLUMB_NAME_OF(PLUMB_LANES),
    kGroups<SolverBodies>,
    kGroups<BodiesWithoutRotation>,
    move<false>,
    collideBoxes,
    {kPasses<PointBlock>, kPasses<HingeBlock>, kPasses<RodBlock>, kPasses<SliderBlock>},
};

}  // namespace plumb::physics::PLUMB_LANES
