#include "reflect/compare.hpp"

#include <gtest/gtest.h>

#include "reflect/curve_field.hpp"
#include "reflect/type_registry.hpp"

namespace plumb {
namespace {

struct Sample {
    float rate = 1.0f;
    FixedList<std::int16_t, 3> items;
    Curve curve;
    int hidden = 0;

    static void describe(TypeBuilder<Sample>& type) {
        type.name("Sample");
        type.field<&Sample::rate>("rate");
        type.field<&Sample::items>("items");
        type.field<&Sample::curve>("curve");
        type.field<&Sample::hidden>("hidden").transient();
    }
};

struct Compare : testing::Test {
    TypeRegistry types;
    const TypeInfo& type = types.add<Sample>();
    Sample a, b;

    [[nodiscard]] bool areEqual(std::string_view field) { return fieldsEqual(*type.find(field), &a, &b); }
};

TEST_F(Compare, eachFieldThatDiffersMakesComponentsDiffer) {
    EXPECT_TRUE(componentsEqual(type, &a, &b));
    for (const FieldInfo& field : type.fields) {
        b = a;
        if (field.name == "rate") b.rate = 2.0f;
        if (field.name == "items") b.items.push(1);
        if (field.name == "curve") b.curve.keys[7].value = 1.0f;
        if (field.name == "hidden") b.hidden = 1;
        EXPECT_FALSE(componentsEqual(type, &a, &b)) << field.name;
        for (const FieldInfo& other : type.fields)
            EXPECT_EQ(fieldsEqual(other, &a, &b), other.name != field.name)
                << field.name << " " << other.name;
        copyField(field, &b, &a);
        EXPECT_TRUE(componentsEqual(type, &a, &b)) << field.name;
    }
    b.rate = -0.0f;
    a.rate = 0.0f;
    EXPECT_FALSE(areEqual("rate")) << "as files store them";
}

TEST_F(Compare, listsAreComparedUpToTheirCount) {
    a.items.push(1), a.items.push(2);
    b.items.push(1);
    EXPECT_FALSE(areEqual("items"));
    b.items.push(3);
    EXPECT_FALSE(areEqual("items")) << "the last item differs";
    b.items.items[1] = 2;
    EXPECT_TRUE(areEqual("items"));
    b.items.items[2] = 7;
    EXPECT_TRUE(areEqual("items")) << "unused items have no value";
}

TEST_F(Compare, aWrongCountComparesNothingBeyondTheList) {
    a.items.count = 1000, b.items.count = 2000;
    EXPECT_TRUE(areEqual("items"));
    b.items.items[2] = 7;
    EXPECT_FALSE(areEqual("items"));
}

}  // namespace
}  // namespace plumb
