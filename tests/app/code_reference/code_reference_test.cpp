#include "tests/app/code_reference/code_reference.hpp"

#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/file.hpp"
#include "core/text.hpp"
#include "gameplay/register_components.hpp"
#include "reflect/type_registry.hpp"
#include "scene/register_components.hpp"
#include "tests/app/code_reference/header_reader.hpp"
#include "tests/support/places.hpp"

// docs/code-reference.md is made from the headers.

namespace plumb {
namespace {

/// UPDATE_GOLDEN=1 writes the document.
TEST(CodeReference, isMadeFromTheHeaders) {
    std::string missing;
    const std::string made = test::codeReference(missing);
    EXPECT_EQ(missing, "");
    const Path file = test::sourceFolder() / "docs/code-reference.md";
    if (std::getenv("UPDATE_GOLDEN") != nullptr) {
        ASSERT_TRUE(writeFile(file, made).ok());
        return;
    }
    EXPECT_TRUE(*readFile(file) == made) << "run this test with UPDATE_GOLDEN=1";
}

TEST(CodeReference, hasAllComponentsAndTheirFields) {
    std::string missing;
    const std::string made = test::codeReference(missing);
    TypeRegistry types;
    registerSceneComponents(types);
    registerGameplayComponents(types);
    const std::string inherited = made.substr(made.find("\n## Fields that components inherit\n"));
    for (const TypeInfo& type : types.all()) {
        const std::size_t at = made.find(format("\n### {}\n", type.name));
        ASSERT_NE(at, std::string::npos) << type.name;
        std::string part = made.substr(at, made.find("\n### ", at + 1) - at);
        if (part.find(format("struct {} : ", type.name)) != std::string::npos)
            part += inherited.substr(0, inherited.find("\n## ", 1));
        for (const FieldInfo& field : type.fields)
            EXPECT_NE(part.find(format(" {}", field.name)), std::string::npos) << type.name << field.name;
    }
}

TEST(HeaderReader, readsWhatIsPublicWithItsComments) {
    const std::vector<test::Declaration> all = test::readHeader(R"(#pragma once
namespace plumb {
class Other;
/// A thing.
/// It has two lines.
///
///     for (Example& example : of(code)) {}
class Thing : Base {
public:
    Thing() = default;
    explicit Thing(int a) : a_{a}, b_{1} {}
    /// Returns a part. @param index  from 0
    [[nodiscard]] int part(int index, Vec2 at = {}) const {
        if (index == '{') return 1;
        return 2;
    }
    int part() const;  // no comment of its own

    float size = 1.5f;  ///< px, its size
    Vec2 scale{1.0f, 1.0f};  ///< ratio
    bool plain = false;
    static void describe(TypeBuilder<Thing>& type) { type.name("Thing"); }

private:
    /// Hidden.
    int hidden() const;
    int a_ = 0;
};
/// Kinds.
enum class Kind : std::uint8_t { First = 1, Second };
/// Adds.
template <class T>
inline T add(T a,
             T b) {
    return a + b;
}
/// Handles.
template <class E, void (*Handler)(World& world, const E& event)>
void on(Place place = {});
}  // namespace plumb
)");
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].signature, "class Thing : Base");
    EXPECT_EQ(all[0].doc, "A thing. It has two lines.");
    std::vector<std::string> members;
    for (const test::Declaration& member : all[0].members)
        members.push_back(member.signature + " | " + member.doc + (member.continues ? " | as above" : ""));
    EXPECT_EQ(members, (std::vector<std::string>{
                           "Thing(int a) | ",
                           "int part(int index, Vec2 at = {}) const | Returns a part. @param index  from 0",
                           "int part() const |  | as above",
                           "float size = 1.5f | px, its size",
                           "Vec2 scale | ratio",
                           "bool plain = false |  | as above",
                       }));
    EXPECT_EQ(all[1].members.size(), 2u);
    EXPECT_EQ(all[1].members[1].name, "Second");
    EXPECT_EQ(all[2].signature, "template <class T> T add(T a, T b)");
    EXPECT_EQ(all[2].name, "add");
    EXPECT_EQ(all[3].name, "on");
}

}  // namespace
}  // namespace plumb
