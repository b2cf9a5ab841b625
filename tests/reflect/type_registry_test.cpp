#include "reflect/type_registry.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reflect/type_key.hpp"
#include "tests/support/random_type.hpp"

namespace plumb {
namespace {

TypeInfo withFields(std::initializer_list<std::string_view> names) {
    TypeInfo type;
    type.name = "Made";
    for (const std::string_view name : names)
        type.fields.push_back(made_types::field(name, FieldKind::Float));
    made_types::layOut(type);
    return type;
}

TEST(TypeRegistry, keepsFieldsInPlaceWhenADescriptionWithAsManyReplacesIt) {
    TypeRegistry types;
    const TypeInfo& known = types.update(withFields({"speed", "health"}));
    const FieldInfo& second = known.fields[1];
    const TypeInfo& now = types.update(withFields({"open", "count"}));
    EXPECT_EQ(&now, &known);
    EXPECT_EQ(&now.fields[1], &second) << "steps of an undo history refer to it";
    EXPECT_EQ(second.name, "count");
    types.update(withFields({"open"}));
    ASSERT_EQ(known.fields.size(), 1u);
    EXPECT_EQ(known.fields[0].name, "open");
}

TEST(TypeRegistry, findsARemovedTypeAtItsFormerPlaceWhenItComesBack) {
    TypeRegistry types;
    const TypeInfo& first = types.update(withFields({"speed"}));
    for (int i = 0; i < 3; ++i) {
        types.remove("Made");
        EXPECT_EQ(types.find("Made"), nullptr);
        EXPECT_EQ(&types.update(withFields({"health"})), &first);
        EXPECT_EQ(types.find("Made"), &first);
    }
    EXPECT_EQ(types.all().size(), 1u);
}

TEST(TypeRegistry, findsTypesByNameAndByKeyInTheOrderOfTheirRegistration) {
    TypeRegistry types;
    for (const std::string_view name : {"C", "A", "B"}) {
        TypeInfo type = withFields({"speed"});
        type.name = name;
        type.key = static_cast<TypeKey>(10 + types.all().size());
        types.update(std::move(type));
    }
    EXPECT_EQ(types.names(), (std::vector<std::string_view>{"C", "A", "B"}));
    for (const TypeInfo& type : types.all()) {
        EXPECT_EQ(types.find(type.name), &type);
        EXPECT_EQ(types.find(type.key), &type);
    }
    EXPECT_EQ(types.find("D"), nullptr);
    EXPECT_EQ(types.find(TypeKey{13}), nullptr);
    types.remove("D");
    types.remove("A");
    EXPECT_EQ(types.names(), (std::vector<std::string_view>{"C", "B"}));
    EXPECT_EQ(types.find(TypeKey{11}), nullptr);
    TypeInfo other = withFields({"health"});
    other.name = "B";
    types.update(std::move(other));
    EXPECT_EQ(types.names(), (std::vector<std::string_view>{"C", "B"}));
    EXPECT_NE(types.find("B")->find("health"), nullptr);
}

TEST(TypeKeys, haveTheNameThatTheyWereMadeWithAndOthersHaveNone) {
    for (int i = 0; i < 40; ++i) {
        const std::string name = "type_registry_test::Made" + std::to_string(i);
        std::vector<std::string> garbage(64,
                                         std::string(511, '\xff'));  // in memory that the keys may get next
        garbage.clear();
        const TypeKey key = nextTypeKey(name);
        EXPECT_TRUE(typeNameOf(key) == name);
        EXPECT_TRUE(typeNameOf(key + 1).empty());
        EXPECT_TRUE(typeNameOf(kMaxTypes).empty());
        EXPECT_FALSE(isReloadable(key));
    }
}

TEST(TypeKeys, countTheVersionsOfReloadedCode) {
    const std::uint32_t version = reloadableVersion();
    beginReloadableTypes();
    EXPECT_EQ(reloadableVersion(), version + 1);
    const TypeKey named = reloadableTypeKey("type_registry_test::Named");
    EXPECT_EQ(reloadableTypeKey("type_registry_test::Named"), named);
    EXPECT_NE(reloadableTypeKey("type_registry_test::Other"), named);
    EXPECT_TRUE(isReloadable(named));
    EXPECT_EQ(typeNameOf(named), "type_registry_test::Named");
}

TEST(TypeKeys, areTheSameForEachVersionOfCodeThatIsLoadedAgain) {
    constexpr std::string_view kNamed = "type_registry_test::Shell";
    constexpr std::string_view kUnnamed = "type_registry_test::{anonymous}::Shell";
    const TypeKey named = reloadableTypeKey(kNamed);
    beginReloadableTypes();
    const TypeKey first = reloadableTypeKey(kUnnamed), second = reloadableTypeKey(kUnnamed);
    EXPECT_NE(first, second) << "of two files";
    for (TypeKey version = 0; version < kMaxTypes; ++version) {
        beginReloadableTypes();
        ASSERT_EQ(reloadableTypeKey(kUnnamed), first);
        ASSERT_EQ(reloadableTypeKey(kUnnamed), second);
        ASSERT_EQ(reloadableTypeKey(kNamed), named);
    }
    EXPECT_TRUE(isReloadable(second));
}

}  // namespace
}  // namespace plumb
