// Part of kernels.inl: joints.
//
// Arms rotate with the bodies in every substep, so that fast swinging chains stay accurate. Warm starting
// repeats the velocity change of the previous substep (accelerate), which used the previous arms; the biased
// pass adds the difference to the current arms.

/// The bodies of eight joints while a block is solved. shiftA and shiftB: motion since the start of the step.
struct Couple8 {
    Body8 a, b;
    Float8 shiftA[4], shiftB[4];

    void push(Two8 impulse, Float8 rotationA, Float8 rotationB) {
        a.push({-impulse.x, -impulse.y}, -rotationA);
        b.push(impulse, rotationB);
    }
    void turn(Float8 impulse) {
        a.lane[2] -= a.inverseInertia * impulse;
        b.lane[2] += b.inverseInertia * impulse;
    }
    [[nodiscard]] Float8 spin() const { return b.lane[2] - a.lane[2]; }
    [[nodiscard]] Two8 velocityBetween(Two8 armA, Two8 armB) const {
        return {b.lane[0] - b.lane[2] * armB.y - (a.lane[0] - a.lane[2] * armA.y),
                b.lane[1] + b.lane[2] * armB.x - (a.lane[1] + a.lane[2] * armA.x)};
    }
};

// Always inlined: a call would pass sixteen registers through memory.
[[gnu::always_inline]] inline Couple8 coupleOf(const SolverBodies& bodies, const JointBodies& block) {
    Couple8 couple;
    gather(bodies.velocity, block.a, couple.a.lane);
    gather(bodies.velocity, block.b, couple.b.lane);
    gather(bodies.deltaPosition, block.a, couple.shiftA);
    gather(bodies.deltaPosition, block.b, couple.shiftB);
    couple.a.inverseInertia = load(block.inverseInertiaA);
    couple.b.inverseInertia = load(block.inverseInertiaB);
    return couple;
}

/// Stores the velocities, except of a body that the joint does not move: other threads may read it.
template <bool kOneSided>
[[gnu::always_inline]] inline void write(const SolverBodies& bodies, const JointBodies& block,
                                         const Couple8& couple, int count) {
    if constexpr (kOneSided) {
        const Mask8 ownIsA = load(block.ownIsA) > all(0.5f);
        Float8 own[4];
        for (int i = 0; i < 4; ++i) own[i] = select(ownIsA, couple.a.lane[i], couple.b.lane[i]);
        scatter(bodies.velocity, block.own, own, count);
    } else {
        scatter(bodies.velocity, block.a, couple.a.lane, count);
        scatter(bodies.velocity, block.b, couple.b.lane, count);
    }
}

/// Returns the change of an arm by the rotation of its body since the start of the step.
inline Two8 changeOf(Two8 arm, const Float8 (&deltaPosition)[4]) {
    return {deltaPosition[3] * arm.x - deltaPosition[2] * arm.y,
            deltaPosition[2] * arm.x + deltaPosition[3] * arm.y};
}

/// Two anchors at the current poses.
struct Anchors8 {
    Two8 armA, armB;
    Two8 apart;  // from A's anchor to B's
};

inline Anchors8 anchorsAt(const AnchorLanes& lanes, const Couple8& couple) {
    const Two8 armA = load2(lanes.armA), armB = load2(lanes.armB);
    const Two8 changeA = changeOf(armA, couple.shiftA), changeB = changeOf(armB, couple.shiftB);
    const Two8 moved{couple.shiftB[0] - couple.shiftA[0], couple.shiftB[1] - couple.shiftA[1]};
    return {armA + changeA, armB + changeB, load2(lanes.apart) + (moved + (changeB - changeA))};
}

// Soft constraint parameters.

struct Grip8 {
    Float8 speedScale, errorRate, impulseScale;
};

inline Grip8 gripOf(const Grip& grip) { return {all(grip.speedScale), all(grip.errorRate), all(grip.impulseScale)}; }

template <bool kPush>
inline Grip8 gripOf(const GripLanes& lanes) {
    const Grip8 soft{load(lanes.speedScale), load(lanes.errorRate), load(lanes.impulseScale)};
    if constexpr (kPush) return soft;
    const Mask8 springs = load(lanes.springs) > all(0.5f);
    return {select(springs, soft.speedScale, all(1.0f)), select(springs, soft.errorRate, all(0.0f)),
            select(springs, soft.impulseScale, all(0.0f))};
}

inline constexpr Grip kRelaxed{1.0f, 0.0f, 0.0f};

/// Returns the maximum speed at which joint errors are closed, times grip.speedScale. Springs are not limited.
inline Float8 maxPull(const JointPass& pass, const GripLanes& lanes, const Grip8& grip) {
    return select(load(lanes.springs) > all(0.5f), all(1.0e30f), grip.speedScale * all(pass.pushSpeed));
}
inline Float8 maxPull(const JointPass& pass, const Grip8& grip) { return grip.speedScale * all(pass.pushSpeed); }

// Point constraint: two rows, solved together.

/// Returns the impulse that changes the velocity between the anchors by `wanted`: solves a 2 x 2 system.
inline Two8 solvePoint(const Couple8& couple, const Anchors8& at, Two8 wanted) {
    const Float8 rotationA = couple.a.inverseInertia, rotationB = couple.b.inverseInertia;
    const Float8 masses = couple.a.lane[3] + couple.b.lane[3];
    const Float8 xx = masses + (rotationA * at.armA.y * at.armA.y + rotationB * at.armB.y * at.armB.y);
    const Float8 yy = masses + (rotationA * at.armA.x * at.armA.x + rotationB * at.armB.x * at.armB.x);
    const Float8 xy = -(rotationA * at.armA.x * at.armA.y + rotationB * at.armB.x * at.armB.y);
    const Float8 inverse = inverseOrZero(xx * yy - xy * xy);
    return {inverse * (yy * wanted.x - xy * wanted.y), inverse * (xx * wanted.y - xy * wanted.x)};
}

/// Returns `grip.errorRate` times the error, limited to `maximum` (from maxPull()).
inline Two8 closing(const Grip8& grip, Two8 apart, Float8 maximum) {
    const Two8 pull = grip.errorRate * apart;
    const Float8 square = dot8(pull, pull);
    const Mask8 fast = square > maximum * maximum;
    if (bits(fast) == 0) return pull;
    const Float8 ratio = maximum / sqrt(select(fast, square, all(1.0f)));
    return select(fast, ratio, all(1.0f)) * pull;
}
inline Float8 closing(const Grip8& grip, Float8 apart, Float8 maximum) {
    return clamp(grip.errorRate * apart, -maximum, maximum);
}

/// Returns the change of the impulse of a soft point constraint.
/// @param pull  velocity that corrects the error, from closing()
inline Two8 answerPoint(const Couple8& couple, const Anchors8& at, const Grip8& grip, Two8 pull,
                        Two8 impulse) {
    const Two8 speed = couple.velocityBetween(at.armA, at.armB);
    const Two8 wanted = grip.speedScale * speed + pull;
    return Two8{all(0.0f), all(0.0f)} - (solvePoint(couple, at, wanted) + grip.impulseScale * impulse);
}

inline void givePoint(Couple8& couple, const Anchors8& at, Two8 impulse) {
    couple.push(impulse, cross8(at.armA, impulse), cross8(at.armB, impulse));
}

/// Before a biased pass: adds the torques that warm starting misses because the arms have changed.
inline void makeUp(Couple8& couple, const PointBlock& block) {
    couple.a.lane[2] -= couple.a.inverseInertia * load(block.rotationA);
    couple.b.lane[2] += couple.b.inverseInertia * load(block.rotationB);
}

inline void noteTurns(PointBlock& block, const Anchors8& at, Two8 impulse) {
    store(block.rotationA, cross8(at.armA, impulse));
    store(block.rotationB, cross8(at.armB, impulse));
}

/// In the relax pass: stores the torques along the current arms minus those of the biased pass.
inline void noteLack(PointBlock& block, const Anchors8& at, Two8 impulse) {
    store(block.rotationA, cross8(at.armA, impulse) - load(block.rotationA));
    store(block.rotationB, cross8(at.armB, impulse) - load(block.rotationB));
}

// Constraints on a value: an angle, or a length along a direction. A Line has speed() and applies impulses.

inline Float8 totalOf(const RowLanes& rows) {
    return (load(rows.holdImpulse) + load(rows.motorImpulse)) +
           (load(rows.lowerImpulse) - load(rows.upperImpulse));
}

template <bool kPush, class Line>
inline void hold(RowLanes& rows, const JointPass& pass, Float8 value, Float8 mass, Line line) {
    const Grip8 grip = gripOf<kPush>(rows.grip);
    const Float8 before = load(rows.holdImpulse), maximum = load(rows.grip.maximum);
    const Float8 pull = closing(grip, value - load(rows.rest), maxPull(pass, rows.grip, grip));
    const Float8 wanted = grip.speedScale * line.speed() + pull;
    const Float8 after = clamp(before - (mass * wanted + grip.impulseScale * before), -maximum, maximum);
    store(rows.holdImpulse, after);
    line.push(after - before);
}

/// Returns the maximum speed of a value towards a limit: within the substep it may reach but not pass the
/// limit; beyond the limit it returns at the speed of the limit's error correction.
template <bool kPush>
inline Float8 speedTo(const RowLanes& rows, const JointPass& pass, Float8 gap) {
    const float back = kPush ? pass.rigid.errorRate / pass.rigid.speedScale : 0.0f;
    return max(gap * select(gap > all(0.0f), all(pass.substepRate), all(back)), -load(rows.returnSpeed));
}

/// Motor, which stops at a limit. If it acted against the limit, both impulses would grow to the maximum, and
/// the limit, which is slightly compliant, would yield. The limit alone acts against all other forces.
template <bool kPush, class Line>
inline void drive(RowLanes& rows, const JointPass& pass, Float8 value, Float8 mass, Line line) {
    const Float8 before = load(rows.motorImpulse), maximum = load(rows.maxMotor), speed = line.speed();
    const Float8 wanted = load(rows.speed), zero = all(0.0f);
    Float8 after = clamp(before - mass * (speed - wanted), -maximum, maximum);
    if ((rows.uses & kLimits) != 0) {
        const Float8 lowest = -speedTo<kPush>(rows, pass, value - load(rows.lower));
        const Float8 highest = speedTo<kPush>(rows, pass, load(rows.upper) - value);
        const Float8 allowed = clamp(wanted, lowest, highest);
        const Float8 there = clamp(before - mass * (speed - allowed), -maximum, maximum);
        const Mask8 stops = (wanted < lowest) | (wanted > highest);
        after = select(stops, clamp(there, min(after, zero), max(after, zero)), after);
    }
    store(rows.motorImpulse, after);
    line.push(after - before);
}

/// A limit, as a one-sided impulse. A value at a distance from the limit may reach it within the substep.
template <bool kPush>
inline Float8 limited(const RowLanes& rows, const JointPass& pass, Float8 speed, Float8 gap, Float8 mass, float* total) {
    const Mask8 apart = gap > all(0.0f);
    const Grip grip = kPush ? pass.rigid : kRelaxed;
    const Float8 before = load(total);
    const Float8 wanted =
        select(apart, all(1.0f), all(grip.speedScale)) * (speed + speedTo<kPush>(rows, pass, gap));
    const Float8 give = select(apart, all(0.0f), all(grip.impulseScale));
    const Float8 after = max(before - (mass * wanted + give * before), all(0.0f));
    store(total, after);
    return after - before;
}

template <bool kPush, class Line>
[[gnu::always_inline]] inline void answerRows(RowLanes& rows, const JointPass& pass, Float8 value,
                                              Float8 mass, Line line) {
    if ((rows.uses & kHolds) != 0) hold<kPush>(rows, pass, value, mass, line);
    if ((rows.uses & kLimits) != 0) {
        line.push(limited<kPush>(rows, pass, line.speed(), value - load(rows.lower), mass, rows.lowerImpulse));
        line.push(-limited<kPush>(rows, pass, -line.speed(), load(rows.upper) - value, mass, rows.upperImpulse));
    }
    if ((rows.uses & kDrives) != 0) drive<kPush>(rows, pass, value, mass, line);
}

// The angle between two bodies.

/// Source: M. Abramowitz, I. Stegun, "Handbook of Mathematical Functions", 1964, 4.4.49: |error| <= 2e-8.
inline Float8 arcTangent8(Float8 y, Float8 x) {
    constexpr float kTerms[] = {0.0028662257f, -0.0161657367f, 0.0429096138f, -0.0752896400f,
                                0.1065626393f, -0.1420889944f, 0.1999355085f, -0.3333314528f};
    constexpr float kQuarter = 1.57079632679489661923f;
    const Float8 width = abs(x), height = abs(y), zero = all(0.0f);
    const Float8 ratio = min(width, height) * inverseOrZero(max(width, height));
    const Float8 square = ratio * ratio;
    Float8 sum = zero;
    for (const float term : kTerms) sum = (sum + all(term)) * square;
    Float8 angle = ratio + ratio * sum;
    angle = select(height > width, all(kQuarter) - angle, angle);
    angle = select(x < zero, all(2.0f * kQuarter) - angle, angle);
    return select(y < zero, -angle, angle);
}

/// Returns the rotation (rad) of B relative to A since the start of the step.
inline Float8 turnBetween(const Couple8& couple) {
    const Float8 sineA = couple.shiftA[2], versineA = couple.shiftA[3];
    const Float8 sineB = couple.shiftB[2], versineB = couple.shiftB[3];
    const Float8 sine = (sineB - sineA) + (sineB * versineA - sineA * versineB);
    const Float8 cosine = all(1.0f) + ((versineA + versineB) + (versineA * versineB + sineA * sineB));
    return arcTangent8(sine, cosine);
}

struct AngleLine8 {
    Couple8& couple;
    [[nodiscard]] Float8 speed() const { return couple.spin(); }
    void push(Float8 impulse) { couple.turn(impulse); }
};

inline Float8 angleMass(const Couple8& couple) {
    return inverseOrZero(couple.a.inverseInertia + couple.b.inverseInertia);
}

// Joints that constrain a point: hinges without (PointBlock) and with a constraint on the angle (HingeBlock).

template <class Block>
concept HasPoint = requires { Block::kHasAngle; };

template <bool kOneSided, HasPoint Block>
void warmStartJoints(const SolverBodies& bodies, const JointPass&, const BlockLanes* lanes, Block* blocks,
                     int begin, int end) {
    for (int n = begin; n < end; ++n) {
        PointBlock& point = blocks[n];
        Couple8 couple = coupleOf(bodies, point.bodies);
        if constexpr (Block::kHasAngle) couple.turn(totalOf(blocks[n].turning));
        givePoint(couple, anchorsAt(point.anchors, couple), load2(point.impulse));
        write<kOneSided>(bodies, point.bodies, couple, lanes[n].count);
    }
}

/// Returns an impulse, limited to a magnitude of `maximum`.
inline Two8 shortened(Two8 impulse, Float8 maximum) {
    const Float8 square = dot8(impulse, impulse);
    if (!any(square > maximum * maximum)) return impulse;
    const Float8 ratio = maximum / max(sqrt(square), all(1.0e-30f));
    return min(ratio, all(1.0f)) * impulse;
}

/// Solves the angle of a joint, before its point.
template <bool kPush>
inline void answerAngle(HingeBlock& block, const JointPass& pass, Couple8& couple, Anchors8& at) {
    if constexpr (kPush) {
        if ((block.turning.uses & (kHolds | kLimits)) != 0)  // a motor alone does not read the angle
            store(block.turning.value, load(block.angle) + turnBetween(couple));
        store2(block.apart, at.apart);
    } else {
        at.apart = load2(block.apart);  // spring forces are evaluated once per substep
    }
    if (block.turning.uses == 0) return;
    answerRows<kPush>(block.turning, pass, load(block.turning.value), angleMass(couple), AngleLine8{couple});
}

template <bool kPush, bool kOneSided, HasPoint Block>
void answerJoints(const SolverBodies& bodies, const JointPass& pass, const BlockLanes* lanes, Block* blocks,
                  int begin, int end) {
    const Grip8 rigid = gripOf(kPush ? pass.rigid : kRelaxed);
    for (int n = begin; n < end; ++n) {
        PointBlock& point = blocks[n];
        Couple8 couple = coupleOf(bodies, point.bodies);
        Anchors8 at = anchorsAt(point.anchors, couple);
        const Two8 before = load2(point.impulse);
        if (pass.first) kPush ? makeUp(couple, point) : noteLack(point, at, before);
        Two8 after;
        if constexpr (Block::kHasAngle) {
            answerAngle<kPush>(blocks[n], pass, couple, at);
            const Grip8 grip = gripOf<kPush>(blocks[n].grip);
            const Two8 pull = closing(grip, at.apart, maxPull(pass, blocks[n].grip, grip));
            after =
                shortened(before + answerPoint(couple, at, grip, pull, before), load(blocks[n].grip.maximum));
            givePoint(couple, at, after - before);
        } else {
            Two8 pull{all(0.0f), all(0.0f)};
            if constexpr (kPush) pull = closing(rigid, at.apart, maxPull(pass, rigid));
            const Two8 change = answerPoint(couple, at, rigid, pull, before);
            after = before + change;
            givePoint(couple, at, change);
        }
        store2(point.impulse, after);
        if constexpr (kPush) noteTurns(point, at, after);
        write<kOneSided>(bodies, point.bodies, couple, lanes[n].count);
    }
}

#include "physics/solver/slide_kernels.inl"
