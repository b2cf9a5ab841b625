// Part of kernels.inl: contacts. The kernels without rotation have the same source with other types of sides:
// the omitted terms are zero, so both give the same bits.

/// One body of eight contacts while a block is solved.
struct Body8 {
    Float8 lane[4];  // velocity x, y, angular; inverse mass
    Float8 inverseInertia;

    void push(Two8 impulse, Float8 turning) {
        lane[0] += lane[3] * impulse.x;
        lane[1] += lane[3] * impulse.y;
        lane[2] += inverseInertia * turning;
    }
};

/// Returns the velocity of a body's point along a direction with lever arm `lever`.
inline Float8 speedAlong(const Body8& body, Two8 direction, Float8 lever) {
    return body.lane[0] * direction.x + body.lane[1] * direction.y + body.lane[2] * lever;
}

// One side of eight contacts while a block is solved: its velocity, and in a biased pass (kPush) its motion
// since the start of the step. An "arm" is the data with which the velocity of a point is computed: a lever,
// nothing for a body that does not rotate, or the velocity itself for a static or kinematic surface.

template <class Lanes, bool kPush>
struct Mover8;

template <bool kPush>
struct Mover8<RotatingSide, kPush> {
    const RotatingSide& side;
    Body8 body;
    Float8 shift[4], turns;

    [[gnu::always_inline]] Mover8(const SolverBodies& bodies, const RotatingSide& lanes, Float8)
        : side{lanes} {
        gather(bodies.velocity, lanes.slot, body.lane);
        body.inverseInertia = load(lanes.inverseInertia);
        if constexpr (!kPush) return;
        gather(bodies.deltaPosition, lanes.slot, shift);
        turns = load(lanes.turn);
    }
    [[nodiscard]] Float8 arm(int p) const { return load(side.lever[p]); }
    [[nodiscard]] Float8 slideArm() const { return load(side.slide); }
    [[nodiscard]] Float8 speed(Two8 direction, Float8 lever) const {
        return speedAlong(body, direction, lever);
    }
    /// Returns the displacement of a point along the normal since the start of the step.
    [[nodiscard]] Float8 moved(Two8 normal, Float8 lever) const {
        return shift[0] * normal.x + shift[1] * normal.y + (shift[2] * lever + shift[3] * turns);
    }
    void push(Two8 impulse, Float8 torque) { body.push(impulse, torque); }
    void pull(Two8 impulse, Float8 torque) { body.push({-impulse.x, -impulse.y}, -torque); }
    [[gnu::always_inline]] void write(const SolverBodies& bodies, int count) const {
        scatter(bodies.velocity, side.slot, body.lane, count);
    }
};

struct NoArm8 {};
inline NoArm8 operator*(Float8, NoArm8) { return {}; }
inline NoArm8 operator+(NoArm8, NoArm8) { return {}; }

template <bool kPush>
struct Mover8<SideWithoutRotation, kPush> {
    const SideWithoutRotation& side;
    Two8 velocity, shift;
    Float8 inverseMass;

    [[gnu::always_inline]] Mover8(const BodiesWithoutRotation& bodies, const SideWithoutRotation& lanes,
                                  Float8)
        : side{lanes}, inverseMass{load(lanes.inverseMass)} {
        if constexpr (kPush) {
            Float8 lane[4];
            gather(bodies.velocity, lanes.offset, lane);
            velocity = {lane[0], lane[1]};
            shift = {lane[2], lane[3]};
        } else {
            gatherTwo(bodies.velocity, lanes.offset, velocity.x, velocity.y);
        }
    }
    [[nodiscard]] NoArm8 arm(int) const { return {}; }
    [[nodiscard]] NoArm8 slideArm() const { return {}; }
    [[nodiscard]] Float8 speed(Two8 direction, NoArm8) const { return dot8(velocity, direction); }
    [[nodiscard]] Float8 moved(Two8 normal, NoArm8) const { return dot8(shift, normal); }
    void push(Two8 impulse, NoArm8) { velocity = velocity + inverseMass * impulse; }
    void pull(Two8 impulse, NoArm8) { velocity = velocity - inverseMass * impulse; }
    [[gnu::always_inline]] void write(const BodiesWithoutRotation& bodies, int count) const {
        scatterTwo(bodies.velocity, side.offset, velocity.x, velocity.y, count);
    }
};

template <std::size_t kPoints, bool kPush>
struct Mover8<FixedSide<kPoints>, kPush> {
    const FixedSide<kPoints>& side;
    Float8 elapsed;

    template <class Bodies>
    [[gnu::always_inline]] Mover8(const Bodies&, const FixedSide<kPoints>& lanes, Float8 since)
        : side{lanes}, elapsed{since} {}
    [[nodiscard]] Float8 arm(int p) const { return load(side.approach[p]); }
    [[nodiscard]] Float8 slideArm() const { return all(0.0f); }  // slideSpeed includes its motion
    [[nodiscard]] Float8 speed(Two8, Float8 approach) const { return approach; }
    [[nodiscard]] Float8 moved(Two8, Float8 approach) const { return approach * elapsed; }
    void pull(Two8, Float8) const {}
    template <class Bodies>
    void write(const Bodies&, int) const {}
};

template <class MoverA, class MoverB, class ArmA, class ArmB>
inline void exchange(MoverA& a, MoverB& b, Float8 impulse, Two8 direction, ArmA armA, ArmB armB) {
    a.pull(impulse * direction, impulse * armA);
    b.push(impulse * direction, impulse * armB);
}

/// Returns the torque of all impulses of a block on one side.
template <bool kHasFriction, class Block, class Mover>
auto torqueOn(const Mover& mover, const Block& block) {
    auto torque = load(block.points[0].impulse) * mover.arm(0);
    for (int p = 1; p < Block::kPoints; ++p) torque = torque + load(block.points[p].impulse) * mover.arm(p);
    if constexpr (kHasFriction) torque = torque + load(block.slideImpulse) * mover.slideArm();
    return torque;
}

template <bool kHasFriction, class Block, class Bodies>
void warmStart(const Bodies& bodies, const ContactPass&, const BlockLanes* lanes, Block* blocks, int begin,
               int end) {
    for (int n = begin; n < end; ++n) {
        const Block& block = blocks[n];
        Mover8<decltype(block.a), false> a{bodies, block.a, all(0.0f)};
        Mover8<decltype(block.b), false> b{bodies, block.b, all(0.0f)};
        Float8 push = load(block.points[0].impulse);
        for (int p = 1; p < Block::kPoints; ++p) push += load(block.points[p].impulse);
        const Two8 normal = load2(block.normal);
        Two8 impulse = push * normal;
        if constexpr (kHasFriction) {
            const Float8 slide = load(block.slideImpulse);
            impulse = {impulse.x - slide * normal.y, impulse.y + slide * normal.x};
        }
        a.pull(impulse, torqueOn<kHasFriction>(a, block));
        b.push(impulse, torqueOn<kHasFriction>(b, block));
        a.write(bodies, lanes[n].count);
        b.write(bodies, lanes[n].count);
    }
}

/// Soft one-sided constraint of a contact point, in SIMD lanes.
struct SoftPush8 {
    Float8 substepRate, biasRate, deepRate, pushSpeed, massScale, impulseScale;

    explicit SoftPush8(const ContactPass& pass)
        : substepRate{all(pass.substepRate)},
          biasRate{all(pass.softness.biasRate)},
          deepRate{all(pass.deepPushRate)},
          pushSpeed{all(pass.pushSpeed)},
          massScale{all(pass.softness.massScale)},
          impulseScale{all(pass.softness.impulseScale)} {}

    /// Returns the change of the normal impulse for a relative velocity `speed` along the normal, and adds it
    /// to `impulse`. Separated bodies may close their gap in the substep; a spring removes overlaps.
    Float8 operator()(Float8 speed, Float8 gap, Float8 mass, Float8& impulse) const {
        const Mask8 apart = gap > all(0.0f);
        const Float8 bias = select(apart, gap * substepRate, max(gap * biasRate, gap * deepRate - pushSpeed));
        const Float8 scale = select(apart, all(1.0f), massScale);
        const Float8 give = select(apart, all(0.0f), impulseScale);
        const Float8 before = impulse;
        impulse = max(before - (mass * scale * (speed + bias) + give * before), all(0.0f));
        return impulse - before;
    }
};

/// Rigid constraint of the relax pass: touching bodies must not approach, separated ones may close their gap.
struct RigidPush8 {
    Float8 substepRate;

    Float8 operator()(Float8 speed, Float8 gap, Float8 mass, Float8& impulse) const {
        const Float8 before = impulse;
        const Float8 bias = select(before > all(0.0f), all(0.0f), max(gap, all(0.0f)) * substepRate);
        impulse = max(before - mass * (speed + bias), all(0.0f));
        return impulse - before;
    }
};

/// Applies Coulomb friction of a contact; `pressed` is the sum of the normal impulses of its points.
template <class Block, class MoverA, class MoverB>
inline void rub(Block& block, Two8 normal, Float8 pressed, MoverA& a, MoverB& b) {
    const Two8 along{-normal.y, normal.x};
    const auto armA = a.slideArm();
    const auto armB = b.slideArm();
    const Float8 sliding = b.speed(along, armB) - a.speed(along, armA) - load(block.slideSpeed);
    const Float8 before = load(block.slideImpulse), maximum = load(block.friction) * pressed;
    const Float8 after = clamp(before - load(block.slideMass) * sliding, -maximum, maximum);
    store(block.slideImpulse, after);
    exchange(a, b, after - before, along, armA, armB);
}

/// Performs one pass over the points of the contacts, and over their friction.
/// @param answer  returns the change of the impulse of a point: answer(point, speed, gap, impulse)
template <bool kHasFriction, bool kPush, class Block, class Bodies, class Answer>
[[gnu::always_inline]] inline void solve(const Bodies& bodies, Float8 elapsed, const BlockLanes* lanes,
                                         Block* blocks, int begin, int end, const Answer& answer) {
    for (int n = begin; n < end; ++n) {
        Block& block = blocks[n];
        Mover8<decltype(block.a), kPush> a{bodies, block.a, elapsed};
        Mover8<decltype(block.b), kPush> b{bodies, block.b, elapsed};
        const Two8 normal = load2(block.normal);
        Float8 pressed;
        for (int p = 0; p < Block::kPoints; ++p) {
            ContactBlockPoint& point = block.points[p];
            const auto armA = a.arm(p);
            const auto armB = b.arm(p);
            Float8 gap;
            if constexpr (kPush) {
                gap = load(point.separation) + (b.moved(normal, armB) - a.moved(normal, armA));
                store(point.gap, gap);
            } else {
                gap = load(point.gap);
            }
            const Float8 speed = b.speed(normal, armB) - a.speed(normal, armA);
            Float8 impulse = load(point.impulse);
            const Float8 change = answer(speed, gap, load(point.mass), impulse);
            store(point.impulse, impulse);
            pressed = p == 0 ? impulse : pressed + impulse;
            exchange(a, b, change, normal, armA, armB);
        }
        if constexpr (kHasFriction) rub(block, normal, pressed, a, b);
        a.write(bodies, lanes[n].count);
        b.write(bodies, lanes[n].count);
    }
}

template <bool kHasFriction, class Block, class Bodies>
void push(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks, int begin,
          int end) {
    solve<kHasFriction, true>(bodies, all(pass.elapsed), lanes, blocks, begin, end, SoftPush8{pass});
}

template <bool kHasFriction, class Block, class Bodies>
void relax(const Bodies& bodies, const ContactPass& pass, const BlockLanes* lanes, Block* blocks, int begin,
           int end) {
    const Float8 substepRate = all(pass.substepRate);
    solve<kHasFriction, false>(bodies, substepRate, lanes, blocks, begin, end, RigidPush8{substepRate});
}

/// Stores the impulses for warm starting of the next step.
template <bool kHasFriction, class Block>
void storeImpulses(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        const Block& block = blocks[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            Float4* rows = contacts + lanes[n].index[i] * kContactRows;
            if constexpr (kHasFriction) rows[kNormalRow].w = block.slideImpulse[i];
            rows[kImpulseRow].y = block.points[0].impulse[i];
            if constexpr (Block::kPoints == 2) rows[kImpulseRow].w = block.points[1].impulse[i];
        }
    }
}
