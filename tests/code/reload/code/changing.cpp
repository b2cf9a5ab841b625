#include <cstdio>
#include <cstdlib>
#include <plumb.hpp>

#include "../layout.hpp"

// A module for tests of the reload. A file, not the compiler, says which fields its component Changing has,
// so each load of the same library can be another version.

using namespace plumb;

struct Changing;

namespace {

test::Layout readLayout() {
    test::Layout layout;
    if (std::FILE* file = std::fopen(std::getenv(test::kLayoutVariable), "rb")) {
        const std::size_t read = std::fread(&layout, sizeof layout, 1, file);
        if (read != 1) layout = {};
        std::fclose(file);
    }
    return layout;
}

/// That of this version; names of fields point to it.
const test::Layout kLayout = readLayout();

FieldInfo described(const test::LayoutField& from) {
    FieldInfo field;
    field.name = from.name.view();
    field.was = from.was.view();
    field.kind = from.kind;
    field.isSigned = from.isSigned;
    field.min = from.min;
    field.max = from.max;
    field.size = from.size;
    field.offset = from.offset;
    if (field.kind == FieldKind::List) {
        field.element = from.capacity == 0 ? FieldKind::Vec2 : FieldKind::Float;  // 0: a curve
        field.elementSize = from.capacity == 0 ? sizeof(Vec2) : sizeof(float);
        field.capacity = from.capacity == 0 ? Curve::kKeys : from.capacity;
        field.countOffset = field.capacity * field.elementSize;
    }
    for (std::size_t i = 0; field.kind == FieldKind::Enum && i < from.enumNames.size(); ++i)
        field.names.push_back({from.enumNames[i].view(), from.enumValues[i]});
    return field;
}

}  // namespace

namespace plumb {

template <>
class TypeBuilder<Changing> {
public:
    explicit TypeBuilder(TypeInfo& type) {
        type.name = "Changing";
        type.key = typeKey<Changing>();
        type.size = kLayout.size;
        type.alignment = 8;
        type.defaults.assign(kLayout.defaults.begin(), kLayout.defaults.begin() + kLayout.size);
        for (std::uint32_t i = 0; i < kLayout.fieldCount; ++i)
            type.fields.push_back(described(kLayout.fields[i]));
    }
};

}  // namespace plumb

/// Only a name: the fields are those of kLayout.
struct Changing {
    static void describe(TypeBuilder<Changing>&) {}
};

/// Present on all entities of the test, the same in all versions.
struct Steady {
    int ticks = 0;

    static void describe(TypeBuilder<Steady>& type) {
        type.name("Steady");
        type.field<&Steady::ticks>("ticks").transient();
    }
};

/// A resource that is kept.
struct Score {
    int beats = 0;
    int rings = 0;

    static void describe(TypeBuilder<Score>& type) {
        type.name("Score");
        type.field<&Score::beats>("beats");
        type.field<&Score::rings>("rings");
    }
};

/// A timer of three ticks that sets itself again.
struct Alarm {
    int amount = 1;
};
constexpr float kAlarm = 3.0f / 60.0f;  // s

/// Counts the ticks in `ticks` of Steady and of Changing, wherever that field is now.
struct CountSystem {
    void update(World& world, float) const {
        const TypeInfo* type = world.types()->find("Changing");
        const FieldInfo* field = type == nullptr ? nullptr : type->find("ticks");
        for (auto [entity, steady] : world.query<Steady>()) {
            ++steady.ticks;
            void* changing = type == nullptr ? nullptr : world.find(*type, entity);
            if (changing == nullptr || field == nullptr) continue;
            int ticks = 0;
            std::memcpy(&ticks, field->in(changing), sizeof ticks);
            ++ticks;
            std::memcpy(field->in(changing), &ticks, sizeof ticks);
        }
    }
};

namespace {

// Types of unnamed namespaces: in each version they could be others.
struct Beat {
    int amount = 1;
};
struct BeatSystem {
    void update(World& world, float) const { world.emit(Beat{}); }
};
struct Unkept {
    int beats = 0;
};

void count(World& world, const Beat& beat) {
    world.resource<Score>().beats += beat.amount;
    world.resource<Unkept>().beats += beat.amount;
    if (world.resource<Score>().beats == 1) emitAfter(world, kAlarm, Alarm{});
}

void ring(World& world, const Alarm& alarm) {
    world.resource<Score>().rings += alarm.amount;
    emitAfter(world, kAlarm, alarm);
}

}  // namespace

PLUMB_MODULE(module) {
    module.components<Steady>();
    if (kLayout.listed) module.components<Changing>();
    module.resources<Score>();
    module.system<CountSystem, Steady>();
    module.system<BeatSystem>();
    module.on<Beat, count>();
    module.on<Alarm, ring>();
}
