// Part of kernels.inl: transposes rows of contacts and bodies into SIMD lanes.

/// Row indices of eight contacts and their bodies. Idle lanes repeat the first contact and are masked out.
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
        const std::int32_t contact = lanes.index[i < lanes.count ? i : 0];
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

/// Prefetches the first rows of the contacts of a later block: they are scattered in memory.
inline void fetch(const Float4* contacts, const BlockLanes& lanes) {
    for (int i = 0; i < kLanes; ++i)
        __builtin_prefetch(contacts + lanes.index[i < lanes.count ? i : 0] * kContactRows);
}

inline void slotsOf(const ContactSource& source, const BlockLanes& lanes, const std::int32_t* body,
                    std::int32_t* slot) {
    for (int i = 0; i < kLanes; ++i) slot[i] = i < lanes.count ? source.slots[body[i]] : source.idleSlot + i;
}

/// Inverse mass and inertia of one body of eight contacts.
struct Side8 {
    Float8 inverseMass, inverseInertia;
};

inline Side8 prepareSide(const ContactSource& source, const BlockLanes& lanes, const std::int32_t* body,
                         RotatingSide& side) {
    Float8 mass[4];
    slotsOf(source, lanes, body, side.slot);
    gather(source.masses, body, mass);
    const Float8 inverseInertia = source.turning ? mass[1] : all(0.0f);
    store(side.inverseInertia, inverseInertia);
    return {mass[0], inverseInertia};
}

/// @return the inverse mass of the body
inline Float8 prepareSide(const ContactSource& source, const BlockLanes& lanes, const std::int32_t* body,
                          SideWithoutRotation& side) {
    std::int32_t slots[kLanes];
    slotsOf(source, lanes, body, slots);
    for (int i = 0; i < kLanes; ++i)
        side.offset[i] = static_cast<std::uint32_t>(slots[i]) * std::uint32_t{sizeof(Float4)};
    Float8 mass[4];
    gather(source.masses, body, mass);
    store(side.inverseMass, mass[0]);
    return mass[0];
}

/// Geometry of eight contacts, at the rotations of the bodies when the points were computed.
struct Places8 {
    Two8 normal;
    Two8 rotationA, rotationB;  // cosine and sine
    Float8 friction, slideImpulse;
    Float8 anchors[2][4];
    Float8 impulses[4];
    Float8 rounds[4];
};

inline Places8 placesOf(const ContactSource& source, const Rows8& rows) {
    Places8 places;
    Float8 first[4], rotation[4];
    gather(source.contacts + kNormalRow, rows.contact, first);
    gather(source.contacts + kRotationRow, rows.contact, rotation);
    gather(source.contacts + kAnchorsRow, rows.contact, places.anchors[0]);
    gather(source.contacts + kAnchorsRow + 1, rows.contact, places.anchors[1]);
    gather(source.contacts + kImpulseRow, rows.contact, places.impulses);
    gather(source.contacts + kRoundRow, rows.contact, places.rounds);
    places.normal = {first[0], first[1]};
    const Two8 normalInA{places.rounds[2], places.rounds[3]};
    places.rotationA = {dot8(normalInA, places.normal), cross8(normalInA, places.normal)};
    places.rotationB = turned(places.rotationA.x, places.rotationA.y, rotation[0], rotation[1]);
    places.friction = first[2];
    places.slideImpulse = first[3];
    return places;
}

inline Float8 surfaceSpeeds(const ContactSource& source, const Rows8& rows) {
    if (!source.surfaces) return all(0.0f);
    Float8 surface[4];
    gather(source.contacts + kSurfaceRow, rows.contact, surface);
    return surface[3] * rows.used;
}

/// Velocity and angular velocity of static or kinematic bodies.
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

/// @param response  1/kg: change of the relative velocity along the normal per N s
inline void preparePoint(const Rows8& rows, Float8 separation, Float8 impulse, Float8 response,
                         ContactBlockPoint& point) {
    store(point.separation, separation);
    store(point.gap, separation);
    store(point.impulse, max(impulse, all(0.0f)) * rows.used);
    store(point.mass, rows.used * inverseOrZero(response));
}

template <class Block>
void prepareFriction(const Rows8& rows, Float8 friction, Float8 impulse, Float8 speed, Float8 response,
                     Block& block) {
    store(block.friction, friction);
    store(block.slideSpeed, speed);
    store(block.slideImpulse, impulse * rows.used);
    store(block.slideMass, rows.used * inverseOrZero(response));
}

/// Prepares contacts of bodies that can rotate.
template <bool kHasFriction, class SideA>
void prepare(const ContactSource& source, const BlockLanes* lanes,
             ContactBlockOf<SideA, RotatingSide, 2>* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        auto& block = blocks[n];
        const Rows8 rows = rowsOf(source, lanes[n]);
        const Side8 b = prepareSide(source, lanes[n], rows.b, block.b);
        Side8 a;
        Surface8 surface;
        if constexpr (SideA::kFixed) {
            surface = surfaceOf(source, rows.a);
        } else {
            a = prepareSide(source, lanes[n], rows.a, block.a);
        }
        const auto response = [&](Float8 leverA, Float8 leverB) {
            const Float8 rotationB = b.inverseInertia * leverB * leverB;
            if constexpr (SideA::kFixed) return b.inverseMass + rotationB;
            return a.inverseMass + b.inverseMass + a.inverseInertia * leverA * leverA + rotationB;
        };
        const Places8 places = placesOf(source, rows);
        const Two8 normal = places.normal;
        Float8 slideA = all(0.0f), slideB = all(0.0f);
        for (int p = 0; p < 2; ++p) {
            const Float8(&anchors)[4] = places.anchors[p];
            const Two8 armA = turned(places.rotationA.x, places.rotationA.y, anchors[0], anchors[1]);
            const Two8 armB = turned(places.rotationB.x, places.rotationB.y, anchors[2], anchors[3]);
            const Float8 leverA = cross8(armA, normal), leverB = cross8(armB, normal);
            slideA += all(0.5f) * dot8(armA, normal);
            slideB += all(0.5f) * dot8(armB, normal);
            if constexpr (SideA::kFixed) {
                store(block.a.approach[p],
                      rows.used * (dot8(surface.velocity, normal) + surface.spin * leverA));
            } else {
                store(block.a.lever[p], leverA);
            }
            store(block.b.lever[p], leverB);
            preparePoint(rows, places.impulses[2 * p], places.impulses[2 * p + 1], response(leverA, leverB),
                         block.points[p]);
        }
        Float8 slideSpeed = surfaceSpeeds(source, rows);
        if constexpr (SideA::kFixed) {
            slideSpeed += rows.used * (cross8(normal, surface.velocity) + surface.spin * slideA);
        } else {
            store(block.a.turn, slideA - places.rounds[0]);
            store(block.a.slide, slideA);
        }
        store(block.b.turn, slideB + places.rounds[1]);
        store(block.b.slide, slideB);
        store2(block.normal, normal);
        prepareFriction(rows, places.friction, places.slideImpulse, slideSpeed, response(slideA, slideB),
                        block);
    }
}

/// Adds the velocity of a kinematic body's surface.
template <bool kHasFriction>
void prepareSurface(const ContactSource& source, const Rows8& rows, Two8 normal,
                    BodiesWithoutRotation::FixedBlock& block) {
    const Surface8 surface = surfaceOf(source, rows.a);
    Float8 anchors[4], rounds[4];
    gather(source.contacts + kAnchorsRow, rows.contact, anchors);
    gather(source.contacts + kRoundRow, rows.contact, rounds);
    const Two8 normalInA{rounds[2], rounds[3]};
    const Two8 arm = turned(dot8(normalInA, normal), cross8(normalInA, normal), anchors[0], anchors[1]);
    store(block.a.approach[0],
          rows.used * (dot8(surface.velocity, normal) + surface.spin * cross8(arm, normal)));
    if constexpr (kHasFriction) {
        store(block.slideSpeed, load(block.slideSpeed) + rows.used * (cross8(normal, surface.velocity) +
                                                                      surface.spin * dot8(arm, normal)));
    }
}

/// Prepares contacts in a group without rotation.
template <bool kHasFriction, class SideA>
void prepare(const ContactSource& source, const BlockLanes* lanes,
             ContactBlockOf<SideA, SideWithoutRotation, 1>* blocks, int begin, int end) {
    for (int n = begin; n < end; ++n) {
        if (n + kAhead < end) fetch(source.contacts, lanes[n + kAhead]);
        auto& block = blocks[n];
        const Rows8 rows = rowsOf(source, lanes[n]);
        Float8 response = prepareSide(source, lanes[n], rows.b, block.b);
        if constexpr (!SideA::kFixed) response += prepareSide(source, lanes[n], rows.a, block.a);
        Float8 first[4], impulses[4];
        gather(source.contacts + kNormalRow, rows.contact, first);
        gather(source.contacts + kImpulseRow, rows.contact, impulses);
        store2(block.normal, {first[0], first[1]});
        preparePoint(rows, impulses[0], impulses[1], response, block.points[0]);
        if constexpr (kHasFriction)
            prepareFriction(rows, first[2], first[3], surfaceSpeeds(source, rows), response, block);
        if constexpr (SideA::kFixed) {
            store(block.a.approach[0], all(0.0f));
            if (source.kinematics) prepareSurface<kHasFriction>(source, rows, {first[0], first[1]}, block);
        }
    }
}
