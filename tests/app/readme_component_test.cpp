#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "app/engine_types.hpp"
#include "core/file.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"
#include "reflect/type_builder.hpp"
#include "tests/support/places.hpp"

namespace plumb {
namespace {

// The component of engine/README.md, word for word: the test below compares.
// README begin
struct Glow {
    float radius = 32.0f;  ///< px

    static void describe(TypeBuilder<Glow>& type) {
        type.name("Glow").doc("Lights its surroundings.");
        type.field<&Glow::radius>("radius").unit(Unit::Pixels).range(0.0f, 512.0f);
    }
};
// README end

std::string between(const std::string& text, std::string_view begin, std::string_view end) {
    const std::size_t start = text.find(begin);
    if (start == std::string::npos) return {};
    const std::size_t from = start + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

TEST(ReadmeComponent, theComponentInTheReadmeEqualsThisOneAndHasLessThanTenLines) {
    const auto map = readFile(test::sourceFolder() / "engine/README.md");
    const auto self = readFile(test::sourceFolder() / "tests/app/readme_component_test.cpp");
    ASSERT_TRUE(map.ok() && self.ok());

    const std::string shown = between(*map, "```cpp\n", "```");
    const std::string here = between(*self, "// README begin\n", "// README end");

    ASSERT_FALSE(shown.empty());
    EXPECT_EQ(shown, here);
    constexpr int kRegistration = 2;  // an #include and an entry in components.hpp
    EXPECT_LT(std::count(shown.begin(), shown.end(), '\n') - 1 /* blank */ + kRegistration, 10);
}

TEST(ReadmeComponent, aDescribedStructCanBeFoundAndAddedByName) {
    TypeRegistry types = engineTypes();
    types.add<Glow>();
    World world{types};
    Entity lamp = world.createEntity();

    const TypeInfo* type = types.find("Glow");
    ASSERT_NE(type, nullptr);
    world.add(*type, lamp);

    EXPECT_EQ(lamp.get<Glow>().radius, 32.0f);
    EXPECT_EQ(type->find("radius")->max, 512.0f);
}

}  // namespace
}  // namespace plumb
