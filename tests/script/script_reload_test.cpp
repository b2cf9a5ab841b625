#include <cmath>
#include <map>
#include <string>

#include "core/random.hpp"
#include "core/text.hpp"
#include "tests/script/script_world.hpp"

// A script is changed at random while it runs: its properties are added, removed, renamed, and get other
// types.

namespace plumb {
namespace {

enum class Kind { Number, Integer, Boolean, Text };

/// A property as the file declares it, with the value that it must have in the world.
struct Expected {
    Kind kind = Kind::Number;
    double value = 0.0;  // of a number, integer or bool
    std::string text;
    std::string was;  // name in the former version
};

std::string declaration(const Expected& property) {
    const char* kinds[] = {"number { 1", "integer { 2", "boolean { true", "text { 'new'"};
    const std::string was = property.was.empty() ? std::string{} : format(", was = \"{}\"", property.was);
    return format("{}{} }", kinds[static_cast<int>(property.kind)], was);
}

Expected fresh(Kind kind) {
    return {kind, kind == Kind::Integer ? 2.0 : 1.0, kind == Kind::Text ? "new" : "", ""};
}

/// The rules of convertComponent(): numbers, integers and bools become one another, others get their default,
/// as do those that had their default.
Expected retyped(const Expected& before, Kind kind) {
    Expected now = fresh(kind);
    if (before.kind == kind) return before;
    if (before.value == fresh(before.kind).value && before.text == fresh(before.kind).text) return now;
    if (before.kind == Kind::Text || kind == Kind::Text) return now;
    now.value = kind == Kind::Boolean   ? (before.value != 0.0 ? 1.0 : 0.0)
                : kind == Kind::Integer ? std::round(before.value)
                                        : before.value;
    return now;
}

class ScriptReload : public ScriptWorld {
protected:
    using Properties = std::map<std::string, Expected>;

    void reload() {
        std::string declared;
        for (const auto& [name, property] : properties)
            declared += format("{} = {},\n", name, declaration(property));
        use({{"thing", "local Thing = script {\n" + declared + R"(
            ticks = integer { 0 } }
            function Thing:onCreate() local n = 0 while true do n = n + 1 self.waits = n wait() end end
            function Thing:onTick() self.ticks = self.ticks + 1 end
            return Thing)"}});
        ASSERT_TRUE(problems.empty()) << problems[0].text();
        for (auto& [name, property] : properties) property.was.clear();
    }

    void changeOne(Random& random) {
        const auto kind = static_cast<Kind>(random.below(4));
        const std::uint32_t action = random.below(4);
        auto chosen = properties.begin();
        std::advance(chosen, static_cast<int>(random.below(static_cast<std::uint32_t>(properties.size()))));
        if (action == 0 && properties.size() < 12) {
            properties[format("p{}", ++made)] = fresh(kind);
        } else if (action == 1 && properties.size() > 3) {
            properties.erase(chosen);
        } else if (action == 2) {
            Expected renamed = chosen->second;
            renamed.was = chosen->first;
            properties.erase(chosen);
            properties[format("p{}", ++made)] = renamed;
        } else {
            chosen->second = retyped(chosen->second, kind);
        }
    }

    /// Gives a property a value, as a game does.
    void set(Random& random, EntityId entity) {
        auto chosen = properties.begin();
        std::advance(chosen, static_cast<int>(random.below(static_cast<std::uint32_t>(properties.size()))));
        Expected& property = chosen->second;
        const TypeInfo& type = *types.find("Thing");
        void* at = type.find(chosen->first)->in(world.find(type, entity));
        property.value = static_cast<double>(random.below(100));
        if (property.kind == Kind::Number) {
            property.value += 0.5;
            store(at, static_cast<float>(property.value));
        } else if (property.kind == Kind::Integer) {
            store(at, static_cast<std::int64_t>(property.value));
        } else if (property.kind == Kind::Boolean) {
            property.value = property.value < 50.0 ? 0.0 : 1.0;
            store(at, property.value != 0.0);
        } else {
            property.text = format("text {}", property.value);
            store(at, world.texts().add(property.text));
        }
    }
    template <class T>
    static void store(void* at, T value) {
        std::memcpy(at, &value, sizeof value);
    }

    void check(EntityId entity) const {
        for (const auto& [name, wanted] : properties) {
            switch (wanted.kind) {
                case Kind::Number:
                    ASSERT_EQ(property<float>(entity, name), static_cast<float>(wanted.value)) << name;
                    break;
                case Kind::Integer:
                    ASSERT_EQ(property<std::int64_t>(entity, name), static_cast<std::int64_t>(wanted.value))
                        << name;
                    break;
                case Kind::Boolean:
                    ASSERT_EQ(property<bool>(entity, name), wanted.value != 0.0) << name;
                    break;
                case Kind::Text:
                    ASSERT_EQ(world.texts().find(property<TextId>(entity, name)), wanted.text) << name;
                    break;
            }
        }
    }

    Properties properties{{"a", fresh(Kind::Number)}, {"b", fresh(Kind::Integer)}, {"c", fresh(Kind::Text)}};
    int made = 0;
};

TEST_F(ScriptReload, thousandRandomEditsKeepTheStateOfARunningScript) {
    Random random = Random::seeded(1);
    reload();
    const EntityId entity = add("Thing");
    run();
    for (int i = 0; i < 1000; ++i) {
        set(random, entity);
        changeOne(random);
        reload();
        run();
        check(entity);
        ASSERT_FALSE(HasFatalFailure()) << "edit " << i;
        ASSERT_EQ(property<std::int64_t>(entity, "ticks"), i + 2);
    }
    EXPECT_EQ(logText(), "");
    EXPECT_LT(world.findResource<ScriptState>()->memory.bytes(), 2'000'000u) << "old versions are freed";
}

}  // namespace
}  // namespace plumb
