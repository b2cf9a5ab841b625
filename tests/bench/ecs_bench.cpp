#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <numeric>
#include <utility>

#include "core/random.hpp"
#include "ecs/world.hpp"
#include "tests/bench/bench.hpp"
#include "tests/bench/ecs_table.hpp"

// Compares operations of engine/ecs with plain arrays that do the same arithmetic, in alternating runs.

namespace plumb::bench {

namespace {

struct Position {
    float x = 0.0f;
    float y = 0.0f;
};
struct Velocity {
    float x = 1.0f;
    float y = 1.0f;
};
struct Acceleration {
    float x = 0.5f;
    float y = 0.5f;
};
struct Counter {
    std::uint32_t value = 1;
    std::uint32_t other = 0;
};
template <int N>
struct Part {};  // used to create many different component sets

constexpr float kDt = 1.0f / 60.0f;

/// The contestants of one row of the table.
struct Case {
    Contestant subject;     ///< the ECS
    Contestant limit;       ///< plain arrays; may be empty
    std::size_t items = 0;  ///< number of items processed in one run
};

void move(Position& position, const Velocity& velocity) {
    position.x += velocity.x * kDt;
    position.y += velocity.y * kDt;
}

/// Components in plain arrays.
struct Arrays {
    explicit Arrays(std::size_t n) : position(n), velocity(n), acceleration(n) {}
    std::vector<Position> position;
    std::vector<Velocity> velocity;
    std::vector<Acceleration> acceleration;
};

std::shared_ptr<World> movers(std::size_t n) {
    auto world = std::make_shared<World>();
    std::vector<EntityId> ids(n);
    world->createEntities(ids, Position{}, Velocity{}, Acceleration{});
    return world;
}

std::vector<std::uint32_t> shuffled(std::size_t n) {
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    Random random = Random::seeded(7);
    for (std::size_t i = n; i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    return order;
}

/// Minimum implementation of a set of entities with two components that are found by entity number: removing
/// an entity moves the last entity to the freed index.
struct PlainSet {
    explicit PlainSet(std::size_t n) : indexOf(n), owner(n), position(n), velocity(n) {}
    void add(std::uint32_t which) {
        indexOf[which] = count;
        owner[count] = which;
        position[count] = {};
        velocity[count] = {};
        ++count;
    }
    void remove(std::uint32_t which) {
        const std::uint32_t gap = indexOf[which];
        const std::uint32_t last = --count;
        const std::uint32_t moved = owner[last];
        owner[gap] = moved;
        indexOf[moved] = gap;
        position[gap] = position[last];
        velocity[gap] = velocity[last];
    }
    void fill() {
        count = 0;
        for (std::uint32_t i = 0; i < indexOf.size(); ++i) add(i);
    }
    void clear() {
        std::fill(indexOf.begin(), indexOf.end(), 0u);
        count = 0;
    }
    std::vector<std::uint32_t> indexOf;  ///< index in the columns, by entity number
    std::vector<std::uint32_t> owner;    ///< entity number, by index in the columns
    std::vector<Position> position;
    std::vector<Velocity> velocity;
    std::uint32_t count = 0;
};

Contestant growingVectors(std::size_t n) {
    return {{}, [n] {
                std::vector<Position> position;
                std::vector<Velocity> velocity;
                for (std::size_t i = 0; i < n; ++i) {
                    position.push_back({});
                    velocity.push_back({});
                }
                keep(position.data());
                keep(velocity.data());
            }};
}

Case createOneByOne(std::size_t n) {
    auto world = std::make_shared<World>();
    return {{[world] { world->clear(); },
             [world, n] {
                 for (std::size_t i = 0; i < n; ++i) {
                     Entity entity = world->createEntity();
                     entity.addComponent<Position>();
                     entity.addComponent<Velocity>();
                 }
             }},
            growingVectors(n),
            n};
}

Case createBulk(std::size_t n) {
    auto world = std::make_shared<World>();
    auto empty = std::make_shared<Snapshot>(world->save());
    auto ids = std::make_shared<std::vector<EntityId>>(n);
    return {{[world, empty] { world->restore(*empty); },
             [world, ids] { world->createEntities(*ids, Position{}, Velocity{}); }},
            growingVectors(n),
            n};
}

Case destroyEach(std::size_t n) {
    auto world = std::make_shared<World>();
    auto plain = std::make_shared<PlainSet>(n);
    auto ids = std::make_shared<std::vector<EntityId>>(n);
    const auto fill = [world, ids] {
        world->clear();
        for (EntityId& id : *ids) {
            Entity entity = world->createEntity();
            entity.addComponent<Position>();
            entity.addComponent<Velocity>();
            id = entity;
        }
    };
    return {{fill,
             [world, ids] {
                 for (const EntityId id : *ids) world->destroy(id);
             }},
            {[plain] { plain->fill(); },
             [plain, n] {
                 for (std::uint32_t i = 0; i < n; ++i) plain->remove(i);
                 keep(plain.get());
             }},
            n};
}

Case destroyAll(std::size_t n) {
    auto world = std::make_shared<World>();
    auto plain = std::make_shared<PlainSet>(n);
    const auto fill = [world, n] {
        for (std::size_t i = 0; i < n; ++i) {
            Entity entity = world->createEntity();
            entity.addComponent<Position>();
            entity.addComponent<Velocity>();
        }
    };
    const auto clear = [plain] {
        plain->clear();
        keep(plain.get());
    };
    return {{fill, [world] { world->clear(); }}, {[plain] { plain->fill(); }, clear}, n};
}

Case randomGet(std::size_t n) {
    auto world = std::make_shared<World>();
    std::vector<EntityId> made(n);
    world->createEntities(made, Counter{});
    const std::vector<std::uint32_t> order = shuffled(n);
    std::vector<EntityId> ids(n);
    for (std::size_t i = 0; i < n; ++i) ids[i] = made[order[i]];
    auto column = std::make_shared<std::vector<Counter>>(n);
    return {{{},
             [world, ids] {
                 std::uint64_t sum = 0;
                 for (const EntityId id : ids) sum += world->get<const Counter>(id).value;
                 const std::uint64_t result = sum;  // keep(&sum) would force the sum into memory
                 keep(&result);
             }},
            {{},
             [column, ids] {
                 std::uint64_t sum = 0;
                 for (const EntityId id : ids) sum += (*column)[id.index - 1].value;
                 const std::uint64_t result = sum;  // keep(&sum) would force the sum into memory
                 keep(&result);
             }},
            n};
}

Case addAndRemove(std::size_t n) {
    auto world = std::make_shared<World>();
    auto ids = std::make_shared<std::vector<EntityId>>(n);
    world->createEntities(*ids, Position{});
    auto plain = std::make_shared<PlainSet>(n);
    return {{{},
             [world, ids] {
                 for (const EntityId id : *ids) {
                     world->add<Velocity>(id);
                     world->remove<Velocity>(id);
                 }
             }},
            {{},
             [plain, n] {
                 for (std::uint32_t i = 0; i < n; ++i) {
                     plain->add(i);
                     plain->remove(i);
                     keep(plain.get());
                 }
             }},
            n};
}

Case addAndRemoveInLoop(std::size_t n) {
    auto world = std::make_shared<World>();
    std::vector<EntityId> ids(n);
    world->createEntities(ids, Position{});
    return {{{},
             [world] {
                 for (auto [entity, position] : world->query<const Position>())
                     entity.addComponent<Velocity>();
                 for (auto [entity, position] : world->query<const Position>())
                     entity.removeComponent<Velocity>();
             }},
            {},
            n};
}

Case iterateOne(std::size_t n) {
    auto world = movers(n);
    auto arrays = std::make_shared<Arrays>(n);
    return {{{}, [world] { world->each<Position>([](Position& p) { p.x += 1.0f, p.y += 1.0f; }); }},
            {{},
             [arrays, n] {
                 Position* p = arrays->position.data();
                 for (std::size_t i = 0; i < n; ++i) p[i].x += 1.0f, p[i].y += 1.0f;
                 keep(p);
             }},
            n};
}

Case iterateTwo(std::size_t n) {
    auto world = movers(n);
    auto arrays = std::make_shared<Arrays>(n);
    return {{{},
             [world] {
                 world->each<Position, const Velocity>(
                     [](Position& p, const Velocity& v) { p.x += v.x, p.y += v.y; });
             }},
            {{},
             [arrays, n] {
                 Position* p = arrays->position.data();
                 const Velocity* v = arrays->velocity.data();
                 for (std::size_t i = 0; i < n; ++i) p[i].x += v[i].x, p[i].y += v[i].y;
                 keep(p);
             }},
            n};
}

Case iterateThree(std::size_t n) {
    auto world = movers(n);
    auto arrays = std::make_shared<Arrays>(n);
    return {{{},
             [world] {
                 world->each<Position, const Velocity, const Acceleration>(
                     [](Position& p, const Velocity& v, const Acceleration& a) {
                         p.x += v.x + a.x, p.y += v.y + a.y;
                     });
             }},
            {{},
             [arrays, n] {
                 Position* p = arrays->position.data();
                 const Velocity* v = arrays->velocity.data();
                 const Acceleration* a = arrays->acceleration.data();
                 for (std::size_t i = 0; i < n; ++i) p[i].x += v[i].x + a[i].x, p[i].y += v[i].y + a[i].y;
                 keep(p);
             }},
            n};
}

Contestant moveArrays(std::size_t n) {
    auto arrays = std::make_shared<Arrays>(n);
    return {{}, [arrays, n] {
                Position* p = arrays->position.data();
                const Velocity* v = arrays->velocity.data();
                for (std::size_t i = 0; i < n; ++i) move(p[i], v[i]);
                keep(p);
            }};
}

Case moveEach(std::size_t n) {
    auto world = movers(n);
    return {{{}, [world] { world->each<Position, const Velocity>(move); }}, moveArrays(n), n};
}

Case rangeFor(std::size_t n) {
    auto world = movers(n);
    return {{{},
             [world] {
                 for (auto [entity, position, velocity] : world->query<Position, const Velocity>()) {
                     move(position, velocity);
                 }
             }},
            moveArrays(n),
            n};
}

Case oneInEight(std::size_t n) {
    auto world = std::make_shared<World>();
    for (std::size_t i = 0; i < n; ++i) {
        Entity entity = world->createEntity();
        entity.addComponent<Position>();
        if (i % 8 == 0) entity.addComponent<Velocity>();
    }
    world->cluster();
    return {{{}, [world] { world->each<Position, const Velocity>(move); }}, moveArrays(n / 8), n / 8};
}

template <int... N>
void addParts(Entity entity, std::uint64_t which, std::integer_sequence<int, N...>) {
    ((which >> N & 1u ? static_cast<void>(entity.addComponent<Part<N>>()) : void()), ...);
}

Case manySets(std::size_t n) {
    auto world = std::make_shared<World>();
    Random random = Random::seeded(3);
    for (std::size_t i = 0; i < n; ++i) {
        Entity entity = world->createEntity();
        entity.addComponent<Position>();
        entity.addComponent<Velocity>();
        addParts(entity, random.below(256), std::make_integer_sequence<int, 8>{});
    }
    return {{{}, [world] { world->each<Position, const Velocity>(move); }}, moveArrays(n), n};
}

Case churn(std::size_t n) {
    auto world = std::make_shared<World>();
    auto ids = std::make_shared<std::vector<EntityId>>(n);
    world->createEntities(*ids, Position{}, Velocity{});
    auto random = std::make_shared<Random>(Random::seeded(5));
    auto plain = std::make_shared<PlainSet>(n);
    plain->fill();
    return {{{},
             [world, ids, random, n] {
                 for (std::size_t k = 0; k < n / 100; ++k) {
                     EntityId& id = (*ids)[random->below(static_cast<std::uint32_t>(n))];
                     world->destroy(id);
                     Entity entity = world->createEntity();
                     entity.addComponent<Position>();
                     entity.addComponent<Velocity>();
                     id = entity;
                 }
                 world->each<Position, const Velocity>(move);
             }},
            {{},
             [plain, random, n] {
                 for (std::size_t k = 0; k < n / 100; ++k) {
                     const std::uint32_t which = random->below(static_cast<std::uint32_t>(n));
                     plain->remove(which);
                     plain->add(which);
                 }
                 for (std::size_t i = 0; i < n; ++i) move(plain->position[i], plain->velocity[i]);
                 keep(plain.get());
             }},
            n};
}

Case snapshot(std::size_t n) {
    auto world = std::make_shared<World>();
    std::vector<EntityId> ids(n);
    world->createEntities(ids, Position{}, Velocity{});
    auto saved = std::make_shared<Snapshot>();
    // The plain set is copied completely; a world's snapshot omits data that can be computed again.
    auto plain = std::make_shared<PlainSet>(n);
    auto copy = std::make_shared<PlainSet>(n);
    return {{{}, [world, saved] { world->save(*saved); }},
            {{},
             [plain, copy] {
                 *copy = *plain;
                 keep(copy.get());
             }},
            1};
}

struct Line {
    const TableLine& table;
    Case (*make)(std::size_t n);
};

constexpr Line kLines[] = {
    {kTable[kIterateTwo], &iterateTwo},  // first, because it measures the speed of this machine
    {kTable[kIterateOne], &iterateOne},
    {kTable[kIterateThree], &iterateThree},
    {kTable[kMove], &moveEach},
    {kTable[kRangeFor], &rangeFor},
    {kTable[kOneInEight], &oneInEight},
    {kTable[kManySets], &manySets},
    {kTable[kChurn], &churn},
    {kTable[kCreate], &createOneByOne},
    {kTable[kCreateBulk], &createBulk},
    {kTable[kDestroyEach], &destroyEach},
    {kTable[kDestroyAll], &destroyAll},
    {kTable[kRandomGet], &randomGet},
    {kTable[kAddRemove], &addAndRemove},
    {kTable[kAddRemoveInLoop], &addAndRemoveInLoop},
    {kTable[kSnapshot], &snapshot},
};

Row measure(const Line& line, std::size_t size, const Options& options, double& machine) {
    const Case made = line.make(kSizes[size]);
    std::vector<Contestant> contestants{made.subject};
    if (made.limit.run) contestants.push_back(made.limit);
    const std::vector<Timing> timings = race(contestants, options);
    const double scale = 1e9 / static_cast<double>(made.items);
    Row row;
    row.name = line.table.name;
    row.n = kSizes[size];
    row.ns = timings[0].minimum * scale;
    row.median = timings[0].median * scale;
    if (timings.size() > 1) row.limitNs = timings[1].minimum * scale;
    if (&line.table == &kTable[kIterateTwo]) machine = row.limitNs / line.table.limit[size];
    row.target = line.table.limit[size] > 0.0 ? line.table.target[size] * row.limitNs / line.table.limit[size]
                                              : line.table.target[size] * machine;
    return row;
}

}  // namespace

int runEcs(const Options& options) {
#if defined(__AVX2__) && defined(__GNUC__)
    if (!__builtin_cpu_supports("avx2")) {
        std::printf("plumb-bench was compiled for AVX2, which this machine lacks; build it without -mavx2\n");
        return 1;
    }
#endif
    printHeader();
    std::vector<Row> rows;
    std::array<double, kSizes.size()> machine{};
    for (const Line& line : kLines) {
        if (!options.rest.empty() &&
            std::string_view{line.table.name}.find(options.rest[0]) == std::string_view::npos &&
            &line.table != &kTable[kIterateTwo]) {
            continue;
        }
        for (std::size_t size = 0; size < (options.quick ? 2 : kSizes.size()); ++size) {
            rows.push_back(measure(line, size, options, machine[size]));
            print(rows.back());
        }
    }
    std::size_t met = 0;
    for (const Row& row : rows) met += row.met() ? 1 : 0;
    std::printf("%zu of %zu at target\n", met, rows.size());
    if (!options.jsonPath.empty() && !writeRows(options.jsonPath, rows)) return 1;
    return 0;
}

}  // namespace plumb::bench
