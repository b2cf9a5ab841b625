#include "reflect/type_registry.hpp"

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
