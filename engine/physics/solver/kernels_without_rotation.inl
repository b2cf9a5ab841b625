// Part of kernels.inl: contacts in a step without rotation. Each operation is one of the full kernels, in
// their order; the omitted terms are zero, so both give the same bits.

/// One body of eight contacts that only translates.
struct Plain8 {
    Float8 x, y;  // velocity
    Float8 inverseMass;

    void push(Two8 impulse) {
        x += inverseMass * impulse.x;
        y += inverseMass * impulse.y;
    }
    void pull(Two8 impulse) {
        x -= inverseMass * impulse.x;
        y -= inverseMass * impulse.y;
    }
    [[gnu::always_inline]] void put(Float4* state, const std::uint32_t* at, int count) const {
        scatterTwoAt(state, at, x, y, count);
    }
};

[[gnu::always_inline]] inline Plain8 plainAt(const Float4* state, const std::uint32_t* at,
                                             const float* inverseMass) {
    Plain8 body;
    gatherTwoAt(state, at, body.x, body.y);
    body.inverseMass = load(inverseMass);
    return body;
}
/// @param moved  displacement since the start of the step
[[gnu::always_inline]] inline Plain8 plainAt(const Float4* state, const std::uint32_t* at,
                                             const float* inverseMass, Two8& moved) {
    Float8 lane[4];
    gatherAt(state, at, lane);
    moved = {lane[2], lane[3]};
    return {lane[0], lane[1], load(inverseMass)};
}

inline Float8 along(const Plain8& body, Two8 direction) {
    return body.x * direction.x + body.y * direction.y;
}
inline Two8 times(Float8 size, Two8 direction) { return {size * direction.x, size * direction.y}; }
inline Two8 acrossOf(Two8 normal) { return {-normal.y, normal.x}; }

inline void offsetsOf(const ContactSource& source, const BlockLanes& lanes, const std::int32_t* body,
                      std::uint32_t* offset) {
    std::int32_t slots[kLanes];
    slotsOf(source, lanes, body, slots);
    for (int i = 0; i < kLanes; ++i)
        offset[i] = static_cast<std::uint32_t>(slots[i]) * std::uint32_t{sizeof(Float4)};
}

inline Float8 inverseMassOf(const ContactSource& source, const std::int32_t* body) {
    Float8 mass[4];
    gather(source.masses, body, mass);
    return mass[0];
}

/// Members that both kinds of blocks share.
/// @return the normals
template <bool kHasFriction, class Block>
Two8 preparePoint(const ContactSource& source, const Rows8& rows, Float8 inverseMass, Block& block) {
    Float8 first[4], impulses[4];
    gather(source.contacts + kNormalRow, rows.contact, first);
    gather(source.contacts + kImpulseRow, rows.contact, impulses);
    store(block.normalX, first[0]);
    store(block.normalY, first[1]);
    store(block.separation, impulses[0]);
    store(block.gap, impulses[0]);
    const Float8 impulse = max(impulses[1], all(0.0f)) * rows.used;
    store(block.impulse, impulse);
    store(block.mass, rows.used * inverseOrZero(inverseMass));
    if constexpr (kHasFriction) {
        store(block.friction, first[2]);
        store(block.slideImpulse, first[3] * rows.used);
        store(block.slideSpeed, surfaceSpeeds(source, rows));
    }
    return {first[0], first[1]};
}

template <bool kHasFriction>
void preparePlain(const ContactSource& source, const BlockLanes* lanes, BlockWithoutRotation* blocks,
                  int begin, int end) {
    for (int n = begin; n < end; ++n) {
        if (n + kAhead < end) fetch(source.contacts, lanes[n + kAhead], 0);
        const Rows8 rows = rowsOf(source, lanes[n]);
        offsetsOf(source, lanes[n], rows.a, blocks[n].a);
        offsetsOf(source, lanes[n], rows.b, blocks[n].b);
        const Float8 a = inverseMassOf(source, rows.a), b = inverseMassOf(source, rows.b);
        store(blocks[n].inverseMassA, a);
        store(blocks[n].inverseMassB, b);
        preparePoint<kHasFriction>(source, rows, a + b, blocks[n]);
    }
}

/// Contribution of a kinematic body's own motion.
template <bool kHasFriction>
void prepareSurface(const ContactSource& source, const Rows8& rows, Two8 normal,
                    FixedBlockWithoutRotation& block) {
    const Surface8 surface = surfaceOf(source, rows.a);
    Float8 anchors[4], rounds[4];
    gather(source.contacts + kAnchorsRow, rows.contact, anchors);
    gather(source.contacts + kRoundRow, rows.contact, rounds);
    const Two8 normalInA{rounds[2], rounds[3]};
    const Two8 arm = turned(dot8(normalInA, normal), cross8(normalInA, normal), anchors[0], anchors[1]);
    store(block.approach, rows.used * (dot8(surface.velocity, normal) + surface.spin * cross8(arm, normal)));
    if constexpr (kHasFriction) {
        const Float8 across = normal.x * surface.velocity.y - normal.y * surface.velocity.x;
        store(block.slideSpeed,
              load(block.slideSpeed) + rows.used * (across + surface.spin * dot8(arm, normal)));
    }
}

template <bool kHasFriction>
void preparePlain(const ContactSource& source, const BlockLanes* lanes, FixedBlockWithoutRotation* blocks,
                  int begin, int end) {
    for (int n = begin; n < end; ++n) {
        if (n + kAhead < end) fetch(source.contacts, lanes[n + kAhead], 0);
        const Rows8 rows = rowsOf(source, lanes[n]);
        offsetsOf(source, lanes[n], rows.b, blocks[n].b);
        const Float8 b = inverseMassOf(source, rows.b);
        store(blocks[n].inverseMass, b);
        const Two8 normal = preparePoint<kHasFriction>(source, rows, b, blocks[n]);
        store(blocks[n].approach, all(0.0f));
        if (source.kinematics) prepareSurface<kHasFriction>(source, rows, normal, blocks[n]);
    }
}

/// The impulse for warm starting.
template <bool kHasFriction, class Block>
Two8 firstImpulse(const Block& block) {
    const Float8 push = load(block.impulse), nx = load(block.normalX), ny = load(block.normalY);
    if constexpr (!kHasFriction) return {push * nx, push * ny};
    const Float8 slide = load(block.slideImpulse);
    return {push * nx - slide * ny, push * ny + slide * nx};
}

template <bool kHasFriction>
void warmStartPlain(const BodiesWithoutRotation& bodies, const BlockLanes* lanes,
                    BlockWithoutRotation* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        const BlockWithoutRotation& block = blocks[n];
        Plain8 a = plainAt(bodies.state, block.a, block.inverseMassA);
        Plain8 b = plainAt(bodies.state, block.b, block.inverseMassB);
        const Two8 impulse = firstImpulse<kHasFriction>(block);
        a.pull(impulse);
        b.push(impulse);
        a.put(bodies.state, block.a, lanes[n].count);
        b.put(bodies.state, block.b, lanes[n].count);
    }
}

template <bool kHasFriction>
void warmStartPlain(const BodiesWithoutRotation& bodies, const BlockLanes* lanes,
                    FixedBlockWithoutRotation* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        Plain8 b = plainAt(bodies.state, blocks[n].b, blocks[n].inverseMass);
        b.push(firstImpulse<kHasFriction>(blocks[n]));
        b.put(bodies.state, blocks[n].b, lanes[n].count);
    }
}

inline void rubPlain(BlockWithoutRotation& block, Two8 normal, Float8 pressed, Plain8& a, Plain8& b) {
    const Two8 across = acrossOf(normal);
    const Float8 sliding = along(b, across) - along(a, across) - load(block.slideSpeed);
    const Float8 change =
        rubbed(sliding, load(block.mass), load(block.friction) * pressed, block.slideImpulse);
    a.pull(times(change, across));
    b.push(times(change, across));
}

inline void rubPlain(FixedBlockWithoutRotation& block, Two8 normal, Float8 pressed, Plain8& b) {
    const Two8 across = acrossOf(normal);
    const Float8 sliding = along(b, across) - load(block.slideSpeed);
    b.push(
        times(rubbed(sliding, load(block.mass), load(block.friction) * pressed, block.slideImpulse), across));
}

template <bool kHasFriction>
void pushPlain(const BodiesWithoutRotation& bodies, const ContactPass& pass, const BlockLanes* lanes,
               BlockWithoutRotation* blocks, int begin, int end) {
    const SoftPush8 soft{pass};
    for (int n = begin; n < end; ++n) {
        BlockWithoutRotation& block = blocks[n];
        Two8 movedA, movedB;
        Plain8 a = plainAt(bodies.state, block.a, block.inverseMassA, movedA);
        Plain8 b = plainAt(bodies.state, block.b, block.inverseMassB, movedB);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 gap = load(block.separation) + (dot8(movedB, normal) - dot8(movedA, normal));
        const Float8 speed = along(b, normal) - along(a, normal);
        Float8 impulse = load(block.impulse);
        const Float8 change = soft.answer(speed, gap, load(block.mass), impulse);
        store(block.gap, gap);
        store(block.impulse, impulse);
        a.pull(times(change, normal));
        b.push(times(change, normal));
        if constexpr (kHasFriction) rubPlain(block, normal, impulse, a, b);
        a.put(bodies.state, block.a, lanes[n].count);
        b.put(bodies.state, block.b, lanes[n].count);
    }
}

template <bool kHasFriction>
void pushPlain(const BodiesWithoutRotation& bodies, const ContactPass& pass, const BlockLanes* lanes,
               FixedBlockWithoutRotation* blocks, int begin, int end) {
    const SoftPush8 soft{pass};
    const Float8 elapsed = all(pass.elapsed);
    for (int n = begin; n < end; ++n) {
        FixedBlockWithoutRotation& block = blocks[n];
        Two8 moved;
        Plain8 b = plainAt(bodies.state, block.b, block.inverseMass, moved);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 approach = load(block.approach);
        const Float8 gap = load(block.separation) + (dot8(moved, normal) - approach * elapsed);
        const Float8 speed = along(b, normal) - approach;
        Float8 impulse = load(block.impulse);
        const Float8 change = soft.answer(speed, gap, load(block.mass), impulse);
        store(block.gap, gap);
        store(block.impulse, impulse);
        b.push(times(change, normal));
        if constexpr (kHasFriction) rubPlain(block, normal, impulse, b);
        b.put(bodies.state, block.b, lanes[n].count);
    }
}

template <bool kHasFriction>
void relaxPlain(const BodiesWithoutRotation& bodies, const ContactPass& pass, const BlockLanes* lanes,
                BlockWithoutRotation* blocks, int begin, int end) {
    const Float8 substepRate = all(pass.substepRate);
    for (int n = begin; n < end; ++n) {
        BlockWithoutRotation& block = blocks[n];
        Plain8 a = plainAt(bodies.state, block.a, block.inverseMassA);
        Plain8 b = plainAt(bodies.state, block.b, block.inverseMassB);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 speed = along(b, normal) - along(a, normal);
        Float8 impulse = load(block.impulse);
        const Float8 change = relaxed(speed, load(block.gap), substepRate, load(block.mass), impulse);
        store(block.impulse, impulse);
        a.pull(times(change, normal));
        b.push(times(change, normal));
        if constexpr (kHasFriction) rubPlain(block, normal, impulse, a, b);
        a.put(bodies.state, block.a, lanes[n].count);
        b.put(bodies.state, block.b, lanes[n].count);
    }
}

template <bool kHasFriction>
void relaxPlain(const BodiesWithoutRotation& bodies, const ContactPass& pass, const BlockLanes* lanes,
                FixedBlockWithoutRotation* blocks, int begin, int end) {
    const Float8 substepRate = all(pass.substepRate);
    for (int n = begin; n < end; ++n) {
        FixedBlockWithoutRotation& block = blocks[n];
        Plain8 b = plainAt(bodies.state, block.b, block.inverseMass);
        const Two8 normal{load(block.normalX), load(block.normalY)};
        const Float8 speed = along(b, normal) - load(block.approach);
        Float8 impulse = load(block.impulse);
        const Float8 change = relaxed(speed, load(block.gap), substepRate, load(block.mass), impulse);
        store(block.impulse, impulse);
        b.push(times(change, normal));
        if constexpr (kHasFriction) rubPlain(block, normal, impulse, b);
        b.put(bodies.state, block.b, lanes[n].count);
    }
}

template <bool kHasFriction, class Block>
void storePlain(Float4* contacts, const BlockLanes* lanes, const Block* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        for (int i = 0; i < lanes[n].count; ++i) {
            Float4* rows = contacts + lanes[n].contact[i] * kContactRows;
            if constexpr (kHasFriction) rows[kNormalRow].w = blocks[n].slideImpulse[i];
            rows[kImpulseRow].y = blocks[n].impulse[i];
        }
    }
}

// Bodies: see accelerate() and move().

/// 1 for the velocities in rows of a state.
alignas(32) constexpr float kIsSpeed[kLanes] = {1.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f};

void acceleratePlain(const BodiesWithoutRotation& bodies, float h, bool first, int begin, int end) {
    const Float8 step = all(h);
    const Mask8 isSpeed = load(kIsSpeed) > all(0.0f);
    for (int i = 4 * begin; i < 4 * end; i += kLanes) {
        float* state = &bodies.state[0].x + i;
        float* velocityBeforeImpulses = &bodies.velocityBeforeImpulses[0].x + i;
        const Float8 now = load(state);
        const Float8 kept = bodies.keep != nullptr ? now * load(&bodies.keep[0].x + i) : now;
        const Float8 driven = kept + load(&bodies.drive[0].x + i) * step;
        const Float8 velocity = first ? driven : driven + (now - load(velocityBeforeImpulses));
        store(state, select(isSpeed, velocity, now));
        store(velocityBeforeImpulses, driven);
    }
}

void movePlain(const BodiesWithoutRotation& bodies, int begin, int end) {
    for (int n = begin; n < end; n += kLanes) {
        std::int32_t slots[kLanes];
        for (int i = 0; i < kLanes; ++i) slots[i] = n + i;
        Float8 state[4], ballisticDrift[4];
        gather(bodies.state, slots, state);
        gather(bodies.ballisticDrift, slots, ballisticDrift);
        state[2] += state[0] * ballisticDrift[2] + ballisticDrift[0];
        state[3] += state[1] * ballisticDrift[2] + ballisticDrift[1];
        scatter(bodies.state, slots, state, kLanes);
    }
}
