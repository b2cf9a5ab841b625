// Part of joint_kernels.inl: joints that act along a direction, rods and sliders.

// Constraints on lengths along a direction.

struct SlideLine8 {
    Couple8& couple;
    Two8 axis;
    Float8 leverA, leverB;

    [[nodiscard]] Float8 speed() const {
        return speedAlong(couple.b, axis, leverB) - speedAlong(couple.a, axis, leverA);
    }
    void push(Float8 impulse) { couple.push(impulse * axis, impulse * leverA, impulse * leverB); }
    [[nodiscard]] Float8 inverseMass() const {
        return couple.a.lane[3] + couple.b.lane[3] +
               (couple.a.inverseInertia * leverA * leverA + couple.b.inverseInertia * leverB * leverB);
    }
};

/// Sum of all impulses of a block along the current directions.
struct Carry8 {
    Two8 impulse;
    Float8 rotationA, rotationB;

    void add(const SlideLine8& line, Float8 size) {
        impulse = impulse + size * line.axis;
        rotationA += size * line.leverA;
        rotationB += size * line.leverB;
    }
};

inline void makeUp(Couple8& couple, const CarryLanes& carry) {
    couple.push(load2(carry.impulse), load(carry.rotationA), load(carry.rotationB));
}
inline void note(CarryLanes& lanes, const Carry8& carry) {
    store2(lanes.impulse, carry.impulse);
    store(lanes.rotationA, carry.rotationA);
    store(lanes.rotationB, carry.rotationB);
}
inline void noteLack(CarryLanes& lanes, const Carry8& carry) {
    store2(lanes.impulse, carry.impulse - load2(lanes.impulse));
    store(lanes.rotationA, carry.rotationA - load(lanes.rotationA));
    store(lanes.rotationB, carry.rotationB - load(lanes.rotationB));
}

inline Carry8 carryOf(const SlideLine8& line, Float8 size) {
    return {size * line.axis, size * line.leverA, size * line.leverB};
}

/// A rod at the current poses: its line and its length.
struct Rod8 {
    SlideLine8 along;
    Float8 value;
};

inline Rod8 placeOf(Couple8& couple, const RodBlock& block) {
    const Anchors8 at = anchorsAt(block.anchors, couple);
    const Float8 length = sqrt(dot8(at.apart, at.apart));
    const Two8 axis = inverseOrZero(length) * at.apart;
    return {{couple, axis, cross8(at.armA, axis), cross8(at.armB, axis)}, length};
}

inline Carry8 carryOf(const Rod8& rod, const RodBlock& block) {
    return carryOf(rod.along, totalOf(block.along));
}

/// A slider at the current poses.
struct Slider8 {
    SlideLine8 along, across;
    Float8 value;   // displacement of B's anchor along the axis
    Float8 offWay;  // displacement across the axis
};

inline Slider8 placeOf(Couple8& couple, const SliderBlock& block) {
    const Anchors8 at = anchorsAt(block.anchors, couple);
    const Two8 start = load2(block.axis);
    const Two8 axis = start + changeOf(start, couple.shiftA);
    const Two8 across{-axis.y, axis.x};
    const Two8 armA = at.armA + at.apart;
    return {{couple, axis, cross8(armA, axis), cross8(at.armB, axis)},
            {couple, across, cross8(armA, across), cross8(at.armB, across)},
            dot8(at.apart, axis),
            dot8(at.apart, across)};
}

inline Carry8 carryOf(const Slider8& slider, const SliderBlock& block) {
    Carry8 carry = carryOf(slider.along, totalOf(block.along));
    carry.add(slider.across, load(block.acrossImpulse));
    return carry;
}

inline void spin(SliderBlock& block, Couple8& couple) {
    const Float8 before = load(block.spinImpulse), maximum = load(block.maxSpin);
    const Float8 after =
        clamp(before - angleMass(couple) * (couple.spin() - load(block.spin)), -maximum, maximum);
    store(block.spinImpulse, after);
    couple.turn(after - before);
}

/// Solves the position across the axis, and the angle if it is fixed: two rows, solved together.
template <bool kPush>
[[gnu::always_inline]] inline void keepOnWay(SliderBlock& block, Couple8& couple, const Slider8& slider,
                                             const JointPass& pass) {
    const SlideLine8& across = slider.across;
    const Mask8 held = load(block.holdsAngle) > all(0.5f);
    const Float8 zero = all(0.0f), rotationA = couple.a.inverseInertia, rotationB = couple.b.inverseInertia;
    const Float8 ww = across.inverseMass();
    const Grip8 soft = gripOf(kPush ? pass.rigid : kRelaxed);
    Float8 displacement = soft.speedScale * across.speed();
    if constexpr (kPush) displacement += closing(soft, slider.offWay, maxPull(pass, soft));
    const Float8 displacementBefore = load(block.acrossImpulse);
    const auto give = [&](Float8 change) {
        store(block.acrossImpulse, displacementBefore + change);
        couple.push(change * across.axis, change * across.leverA, change * across.leverB);
    };
    if (!any(held)) return give(-(inverseOrZero(ww) * displacement + soft.impulseScale * displacementBefore));
    const Float8 wa = select(held, rotationA * across.leverA + rotationB * across.leverB, zero);
    const Mask8 turns = held & (rotationA + rotationB > zero);
    const Float8 aa = select(turns, rotationA + rotationB, all(1.0f));
    Float8 turning = soft.speedScale * couple.spin();
    if constexpr (kPush)
        turning += closing(soft, load(block.angle) + turnBetween(couple), maxPull(pass, soft));
    const Float8 angle = select(turns, turning, zero);
    const Float8 inverse = inverseOrZero(ww * aa - wa * wa);
    const Float8 angleBefore = load(block.angleImpulse);
    const Float8 angleChange = -(inverse * (ww * angle - wa * displacement) + soft.impulseScale * angleBefore);
    store(block.angleImpulse, angleBefore + angleChange);
    give(-(inverse * (aa * displacement - wa * angle) + soft.impulseScale * displacementBefore));
    couple.turn(angleChange);
}

template <class Block>
concept ActsAlong = requires { Block::kSlides; };

template <bool kOneSided, ActsAlong Block>
void warmStartJoints(const SolverBodies& bodies, const JointPass&, const BlockLanes* lanes, Block* blocks,
                     int begin, int end) {
    for (int n = begin; n < end; ++n) {
        const Block& block = blocks[n];
        Couple8 couple = coupleOf(bodies, block.bodies);
        const Carry8 carry = carryOf(placeOf(couple, block), block);
        couple.push(carry.impulse, carry.rotationA, carry.rotationB);
        if constexpr (Block::kSlides) couple.turn(load(block.angleImpulse) + load(block.spinImpulse));
        write<kOneSided>(bodies, block.bodies, couple, lanes[n].count);
    }
}

template <bool kPush, bool kOneSided, ActsAlong Block>
void answerJoints(const SolverBodies& bodies, const JointPass& pass, const BlockLanes* lanes, Block* blocks,
                  int begin, int end) {
    for (int n = begin; n < end; ++n) {
        Block& block = blocks[n];
        Couple8 couple = coupleOf(bodies, block.bodies);
        const auto place = placeOf(couple, block);
        if constexpr (kPush) {
            if (pass.first) makeUp(couple, block.carry);
            store(block.along.value, place.value);
        } else if (pass.first) {
            noteLack(block.carry, carryOf(place, block));
        }
        const Float8 mass = inverseOrZero(place.along.inverseMass());
        answerRows<kPush>(block.along, pass, load(block.along.value), mass, place.along);
        if constexpr (Block::kSlides) {
            if (block.spins != 0) spin(block, couple);
            keepOnWay<kPush>(block, couple, place, pass);
        }
        if constexpr (kPush) note(block.carry, carryOf(place, block));
        write<kOneSided>(bodies, block.bodies, couple, lanes[n].count);
    }
}
