// Part of kernels.inl: contacts with two points between bodies that can rotate.

// Preparation: transposes rows of contacts and bodies into SIMD lanes.

/// Row indices of eight contacts and their bodies. Idle lanes repeat those of the first contact and are
/// masked out.
struct Rows8 {
    std::int32_t contact[kLanes];
    std::int32_t a[kLanes];
    std::int32_t b[kLanes];
    Float8 used;  // 1 in lanes with a contact, else 0
};

inline Rows8 rowsOf(const ContactSource& source, const BlockLanes& lanes) {
    Rows8 rows;
    float used[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        const std::int32_t contact = lanes.contact[i < lanes.count ? i : 0];
        std::int32_t ids[4];
        __builtin_memcpy(ids, source.contacts + contact * kContactRows, sizeof ids);
        rows.contact[i] = contact * kContactRows;
        rows.a[i] = ids[2];
        rows.b[i] = ids[3];
        used[i] = i < lanes.count ? 1.0f : 0.0f;
    }
    rows.used = load(used);
    return rows;
}

constexpr int kAhead = 2;  // blocks: prefetch distance

/// Prefetches rows of the contacts of a later block: they are scattered in memory.
inline void fetch(const Float4* contacts, const BlockLanes& lanes, int line) {
    for (int i = 0; i < kLanes; ++i)
        __builtin_prefetch(contacts + lanes.contact[i < lanes.count ? i : 0] * kContactRows + line);
}

inline void slotsOf(const ContactSource& source, const BlockLanes& lanes, const std::int32_t* body,
                    std::int32_t* slot) {
    for (int i = 0; i < kLanes; ++i) slot[i] = i < lanes.count ? source.slots[body[i]] : source.idleSlot + i;
}

/// Inverse mass and inertia of one body of eight contacts.
struct Side8 {
    Float8 inverseMass, inverseInertia;
};

inline Side8 sideOf(const ContactSource& source, const std::int32_t* body) {
    Float8 mass[4];
    gather(source.masses, body, mass);
    return {mass[0], source.turning ? mass[1] : all(0.0f)};
}

/// Geometry of eight contacts, at the orientations that the bodies had when the points were found.
struct Places8 {
    Two8 normal;
    Two8 turnA, turnB;  // cosine and sine
    Float8 friction, slideImpulse;
    Float8 anchors[2][4];
    Float8 impulses[4];
    Float8 rounds[4];
};

inline Places8 placesOf(const ContactSource& source, const Rows8& rows) {
    Places8 places;
    Float8 first[4], turn[4];
    gather(source.contacts + kNormalRow, rows.contact, first);
    gather(source.contacts + kTurnRow, rows.contact, turn);
    gather(source.contacts + kAnchorsRow, rows.contact, places.anchors[0]);
    gather(source.contacts + kAnchorsRow + 1, rows.contact, places.anchors[1]);
    gather(source.contacts + kImpulseRow, rows.contact, places.impulses);
    gather(source.contacts + kRoundRow, rows.contact, places.rounds);
    places.normal = {first[0], first[1]};
    const Two8 normalInA{places.rounds[2], places.rounds[3]};
    places.turnA = {dot8(normalInA, places.normal), cross8(normalInA, places.normal)};
    places.turnB = turned(places.turnA.x, places.turnA.y, turn[0], turn[1]);
    places.friction = first[2];
    places.slideImpulse = first[3] * rows.used;
    return places;
}

inline Float8 surfaceSpeeds(const ContactSource& source, const Rows8& rows) {
    if (!source.surfaces) return all(0.0f);
    Float8 surface[4];
    gather(source.contacts + kSurfaceRow, rows.contact, surface);
    return surface[3] * rows.used;
}

void prepare(const ContactSource& source, const BlockLanes* lanes, ContactBlock* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        ContactBlock& block = blocks[n];
        const Rows8 rows = rowsOf(source, lanes[n]);
        slotsOf(source, lanes[n], rows.a, block.a);
        slotsOf(source, lanes[n], rows.b, block.b);
        const Side8 a = sideOf(source, rows.a);
        const Side8 b = sideOf(source, rows.b);
        const Places8 places = placesOf(source, rows);
        const Two8 normal = places.normal;
        const Float8 masses = a.inverseMass + b.inverseMass;
        Float8 slideA = all(0.0f), slideB = all(0.0f);
        for (int p = 0; p < 2; ++p) {
            const Float8(&anchors)[4] = places.anchors[p];
            const Two8 armA = turned(places.turnA.x, places.turnA.y, anchors[0], anchors[1]);
            const Two8 armB = turned(places.turnB.x, places.turnB.y, anchors[2], anchors[3]);
            const Float8 leverA = cross8(armA, normal);
            const Float8 leverB = cross8(armB, normal);
            slideA += all(0.5f) * dot8(armA, normal);
            slideB += all(0.5f) * dot8(armB, normal);
            ContactBlockPoint& point = block.points[p];
            store(point.leverA, leverA);
            store(point.leverB, leverB);
            store(point.separation, places.impulses[2 * p]);
            store(point.gap, places.impulses[2 * p]);
            const Float8 impulse = max(places.impulses[2 * p + 1], all(0.0f)) * rows.used;
            store(point.impulse, impulse);
            store(point.mass, rows.used * inverseOrZero(masses + a.inverseInertia * leverA * leverA +
                                                        b.inverseInertia * leverB * leverB));
        }
        store(block.normalX, normal.x);
        store(block.normalY, normal.y);
        store(block.inverseInertiaA, a.inverseInertia);
        store(block.inverseInertiaB, b.inverseInertia);
        store(block.turnA, slideA - places.rounds[0]);
        store(block.turnB, slideB + places.rounds[1]);
        store(block.slideA, slideA);
        store(block.slideB, slideB);
        store(block.friction, places.friction);
        store(block.slideImpulse, places.slideImpulse);
        store(block.slideSpeed, surfaceSpeeds(source, rows));
        store(block.slideMass, rows.used * inverseOrZero(masses + a.inverseInertia * slideA * slideA +
                                                         b.inverseInertia * slideB * slideB));
    }
}

/// Velocity of the surface of a static or kinematic body.
struct Surface8 {
    Two8 velocity;
    Float8 spin;
};

inline Surface8 surfaceOf(const ContactSource& source, const std::int32_t* body) {
    const Float8 zero = all(0.0f);
    if (!source.kinematics) return {{zero, zero}, zero};
    Float8 motion[4];
    gather(source.motions, body, motion);
    return {{motion[0], motion[1]}, motion[2]};
}

void prepareFixed(const ContactSource& source, const BlockLanes* lanes, FixedContactBlock* blocks, int begin,
                  int end) {
    for (int n = begin; n < end; ++n) {
        FixedContactBlock& block = blocks[n];
        const Rows8 rows = rowsOf(source, lanes[n]);
        slotsOf(source, lanes[n], rows.b, block.b);
        const Side8 b = sideOf(source, rows.b);
        const Surface8 surface = surfaceOf(source, rows.a);
        const Places8 places = placesOf(source, rows);
        const Two8 normal = places.normal;
        const Float8 surfaceAlong = dot8(surface.velocity, normal);
        Float8 slide = all(0.0f), slideA = all(0.0f);
        for (int p = 0; p < 2; ++p) {
            const Float8(&anchors)[4] = places.anchors[p];
            const Two8 armA = turned(places.turnA.x, places.turnA.y, anchors[0], anchors[1]);
            const Two8 armB = turned(places.turnB.x, places.turnB.y, anchors[2], anchors[3]);
            const Float8 lever = cross8(armB, normal);
            slide += all(0.5f) * dot8(armB, normal);
            slideA += all(0.5f) * dot8(armA, normal);
            FixedContactBlockPoint& point = block.points[p];
            store(point.lever, lever);
            store(point.approach, rows.used * (surfaceAlong + surface.spin * cross8(armA, normal)));
            store(point.separation, places.impulses[2 * p]);
            store(point.gap, places.impulses[2 * p]);
            const Float8 impulse = max(places.impulses[2 * p + 1], all(0.0f)) * rows.used;
            store(point.impulse, impulse);
            store(point.mass, rows.used * inverseOrZero(b.inverseMass + b.inverseInertia * lever * lever));
        }
        const Float8 surfaceAcross = normal.x * surface.velocity.y - normal.y * surface.velocity.x;
        store(block.normalX, normal.x);
        store(block.normalY, normal.y);
        store(block.inverseInertia, b.inverseInertia);
        store(block.turn, slide + places.rounds[1]);
        store(block.slide, slide);
        store(block.friction, places.friction);
        store(block.slideImpulse, places.slideImpulse);
        store(block.slideSpeed,
              surfaceSpeeds(source, rows) + rows.used * (surfaceAcross + surface.spin * slideA));
        store(block.slideMass, rows.used * inverseOrZero(b.inverseMass + b.inverseInertia * slide * slide));
    }
}

// Solving.

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

inline Body8 bodyAt(const Float4* velocity, const std::int32_t* slots, const float* inverseInertia) {
    Body8 body;
    gather(velocity, slots, body.lane);
    body.inverseInertia = load(inverseInertia);
    return body;
}

/// Velocity of a body's point along a direction with lever arm `lever`.
inline Float8 speedAlong(const Body8& body, Two8 direction, Float8 lever) {
    return body.lane[0] * direction.x + body.lane[1] * direction.y + body.lane[2] * lever;
}

/// Displacement of a body's point along the normal since the start of the step.
inline Float8 movedAlong(const Float8 (&deltaPosition)[4], Two8 normal, Float8 lever, Float8 turn) {
    return deltaPosition[0] * normal.x + deltaPosition[1] * normal.y +
           (deltaPosition[2] * lever + deltaPosition[3] * turn);
}

template <bool kHasFriction>
void warmStart(const SolverBodies& bodies, const BlockLanes* lanes, ContactBlock* blocks, int begin,
               int end) {
    for (int n = begin; n < end; ++n) {
        const ContactBlock& block = blocks[n];
        Body8 a = bodyAt(bodies.velocity, block.a, block.inverseInertiaA);
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertiaB);
        const Float8 push0 = load(block.points[0].impulse), push1 = load(block.points[1].impulse);
        const Float8 slide = kHasFriction ? load(block.slideImpulse) : all(0.0f), push = push0 + push1;
        const Float8 nx = load(block.normalX), ny = load(block.normalY);
        const Two8 impulse{push * nx - slide * ny, push * ny + slide * nx};
        a.push({-impulse.x, -impulse.y},
               -(push0 * load(block.points[0].leverA) + push1 * load(block.points[1].leverA) +
                 slide * load(block.slideA)));
        b.push(impulse, push0 * load(block.points[0].leverB) + push1 * load(block.points[1].leverB) +
                            slide * load(block.slideB));
        scatter(bodies.velocity, block.a, a.lane, lanes[n].count);
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
    }
}

template <bool kHasFriction>
void warmStartFixed(const SolverBodies& bodies, const BlockLanes* lanes, FixedContactBlock* blocks, int begin,
                    int end) {
    for (int n = begin; n < end; ++n) {
        const FixedContactBlock& block = blocks[n];
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertia);
        const Float8 push0 = load(block.points[0].impulse), push1 = load(block.points[1].impulse);
        const Float8 slide = kHasFriction ? load(block.slideImpulse) : all(0.0f), push = push0 + push1;
        const Float8 nx = load(block.normalX), ny = load(block.normalY);
        b.push({push * nx - slide * ny, push * ny + slide * nx}, push0 * load(block.points[0].lever) +
                                                                     push1 * load(block.points[1].lever) +
                                                                     slide * load(block.slide));
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
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

    /// Change of the normal impulse in response to a relative velocity `speed` along the normal; adds it to
    /// `impulse`. Separated bodies may close their gap within the substep; overlapping ones are pushed out by
    /// a spring.
    [[nodiscard]] Float8 answer(Float8 speed, Float8 gap, Float8 mass, Float8& impulse) const {
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
inline Float8 relaxed(Float8 speed, Float8 gap, Float8 substepRate, Float8 mass, Float8& impulse) {
    const Float8 before = impulse;
    const Float8 bias = select(before > all(0.0f), all(0.0f), max(gap, all(0.0f)) * substepRate);
    impulse = max(before - mass * (speed + bias), all(0.0f));
    return impulse - before;
}

/// Coulomb friction: the impulse that stops sliding, limited by the normal impulse.
inline Float8 rubbed(Float8 speed, Float8 mass, Float8 maximum, float* total) {
    const Float8 before = load(total);
    const Float8 after = clamp(before - mass * speed, -maximum, maximum);
    store(total, after);
    return after - before;
}

/// Friction of a whole contact, whose points together have the normal impulse `pressed`.
inline void rub(ContactBlock& block, Two8 normal, Float8 pressed, Body8& a, Body8& b) {
    const Two8 along{-normal.y, normal.x};
    const Float8 slideA = load(block.slideA), slideB = load(block.slideB);
    const Float8 sliding =
        speedAlong(b, along, slideB) - speedAlong(a, along, slideA) - load(block.slideSpeed);
    const Float8 change =
        rubbed(sliding, load(block.slideMass), load(block.friction) * pressed, block.slideImpulse);
    const Two8 impulse{change * along.x, change * along.y};
    a.push({-impulse.x, -impulse.y}, -(change * slideA));
    b.push(impulse, change * slideB);
}

inline void rub(FixedContactBlock& block, Two8 normal, Float8 pressed, Body8& b) {
    const Two8 along{-normal.y, normal.x};
    const Float8 slide = load(block.slide);
    const Float8 sliding = speedAlong(b, along, slide) - load(block.slideSpeed);
    const Float8 change =
        rubbed(sliding, load(block.slideMass), load(block.friction) * pressed, block.slideImpulse);
    b.push({change * along.x, change * along.y}, change * slide);
}

template <bool kHasFriction>
void push(const SolverBodies& bodies, const ContactPass& pass, const BlockLanes* lanes, ContactBlock* blocks,
          int begin, int end) {
    const SoftPush8 soft{pass};
    for (int n = begin; n < end; ++n) {
        ContactBlock& block = blocks[n];
        Body8 a = bodyAt(bodies.velocity, block.a, block.inverseInertiaA);
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertiaB);
        Float8 shiftA[4], shiftB[4];
        gather(bodies.deltaPosition, block.a, shiftA);
        gather(bodies.deltaPosition, block.b, shiftB);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 turnA = load(block.turnA), turnB = load(block.turnB);
        for (ContactBlockPoint& point : block.points) {
            const Float8 leverA = load(point.leverA), leverB = load(point.leverB);
            const Float8 gap = load(point.separation) + (movedAlong(shiftB, normal, leverB, turnB) -
                                                         movedAlong(shiftA, normal, leverA, turnA));
            const Float8 speed = speedAlong(b, normal, leverB) - speedAlong(a, normal, leverA);
            Float8 impulse = load(point.impulse);
            const Float8 change = soft.answer(speed, gap, load(point.mass), impulse);
            store(point.gap, gap);
            store(point.impulse, impulse);
            const Two8 pushed{change * normal.x, change * normal.y};
            a.push({-pushed.x, -pushed.y}, -(change * leverA));
            b.push(pushed, change * leverB);
        }
        if constexpr (kHasFriction)
            rub(block, normal, load(block.points[0].impulse) + load(block.points[1].impulse), a, b);
        scatter(bodies.velocity, block.a, a.lane, lanes[n].count);
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
    }
}

template <bool kHasFriction>
void pushFixed(const SolverBodies& bodies, const ContactPass& pass, const BlockLanes* lanes,
               FixedContactBlock* blocks, int begin, int end) {
    const SoftPush8 soft{pass};
    const Float8 elapsed = all(pass.elapsed);
    for (int n = begin; n < end; ++n) {
        FixedContactBlock& block = blocks[n];
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertia);
        Float8 deltaPosition[4];
        gather(bodies.deltaPosition, block.b, deltaPosition);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 turn = load(block.turn);
        for (FixedContactBlockPoint& point : block.points) {
            const Float8 lever = load(point.lever), approach = load(point.approach);
            const Float8 gap = load(point.separation) +
                               (movedAlong(deltaPosition, normal, lever, turn) - approach * elapsed);
            const Float8 speed = speedAlong(b, normal, lever) - approach;
            Float8 impulse = load(point.impulse);
            const Float8 change = soft.answer(speed, gap, load(point.mass), impulse);
            store(point.gap, gap);
            store(point.impulse, impulse);
            b.push({change * normal.x, change * normal.y}, change * lever);
        }
        if constexpr (kHasFriction)
            rub(block, normal, load(block.points[0].impulse) + load(block.points[1].impulse), b);
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
    }
}

template <bool kHasFriction>
void relax(const SolverBodies& bodies, const ContactPass& pass, const BlockLanes* lanes, ContactBlock* blocks,
           int begin, int end) {
    const Float8 substepRate = all(pass.substepRate);
    for (int n = begin; n < end; ++n) {
        ContactBlock& block = blocks[n];
        Body8 a = bodyAt(bodies.velocity, block.a, block.inverseInertiaA);
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertiaB);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        Float8 impulses[2] = {load(block.points[0].impulse), load(block.points[1].impulse)};
        for (int p = 0; p < 2; ++p) {
            ContactBlockPoint& point = block.points[p];
            const Float8 leverA = load(point.leverA), leverB = load(point.leverB);
            const Float8 speed = speedAlong(b, normal, leverB) - speedAlong(a, normal, leverA);
            const Float8 change = relaxed(speed, load(point.gap), substepRate, load(point.mass), impulses[p]);
            store(point.impulse, impulses[p]);
            const Two8 pushed{change * normal.x, change * normal.y};
            a.push({-pushed.x, -pushed.y}, -(change * leverA));
            b.push(pushed, change * leverB);
        }
        if constexpr (kHasFriction) rub(block, normal, impulses[0] + impulses[1], a, b);
        scatter(bodies.velocity, block.a, a.lane, lanes[n].count);
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
    }
}

template <bool kHasFriction>
void relaxFixed(const SolverBodies& bodies, const ContactPass& pass, const BlockLanes* lanes,
                FixedContactBlock* blocks, int begin, int end) {
    const Float8 substepRate = all(pass.substepRate);
    for (int n = begin; n < end; ++n) {
        FixedContactBlock& block = blocks[n];
        Body8 b = bodyAt(bodies.velocity, block.b, block.inverseInertia);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        Float8 impulses[2] = {load(block.points[0].impulse), load(block.points[1].impulse)};
        for (int p = 0; p < 2; ++p) {
            FixedContactBlockPoint& point = block.points[p];
            const Float8 lever = load(point.lever);
            const Float8 speed = speedAlong(b, normal, lever) - load(point.approach);
            const Float8 change = relaxed(speed, load(point.gap), substepRate, load(point.mass), impulses[p]);
            store(point.impulse, impulses[p]);
            b.push({change * normal.x, change * normal.y}, change * lever);
        }
        if constexpr (kHasFriction) rub(block, normal, impulses[0] + impulses[1], b);
        scatter(bodies.velocity, block.b, b.lane, lanes[n].count);
    }
}

/// Stores the impulses for warm starting of the next step.
template <bool kHasFriction, class Block>
void storeImpulses(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        const Block& block = blocks[n];
        for (int i = 0; i < lanes[n].count; ++i) {
            Float4* rows = contacts + lanes[n].contact[i] * kContactRows;
            if constexpr (kHasFriction) rows[kNormalRow].w = block.slideImpulse[i];
            rows[kImpulseRow].y = block.points[0].impulse[i];
            rows[kImpulseRow].w = block.points[1].impulse[i];
        }
    }
}
