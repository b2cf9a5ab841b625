#include "reflect/json_members.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "reflect/json.hpp"

namespace plumb {
namespace {

constexpr float kMax = std::numeric_limits<float>::max();

const Json kAny[] = {nullptr, true, 1, 1.5, "text", Json::array({1}), Json::object({{"a", 1}})};

TEST(JsonMembers, areFoundByNameAndType) {
    Json json{{"number", 1}, {"text", "t"}, {"list", Json::array()}, {"object", Json::object()}};
    const Json& constant = json;
    for (const char* key : {"number", "text", "list", "object", "none"}) {
        const bool exists = std::string_view{key} != "none";
        const Json* member = exists ? &json[key] : nullptr;
        EXPECT_EQ(findMember(constant, key), member) << key;
        EXPECT_EQ(findMember(json, key), member) << key;
        const Json* object = exists && member->is_object() ? member : nullptr;
        EXPECT_EQ(findObject(constant, key), object) << key;
        EXPECT_EQ(findObject(json, key), object) << key;
        const Json* list = exists && member->is_array() ? member : nullptr;
        EXPECT_EQ(findArray(constant, key), list) << key;
        EXPECT_EQ(findArray(json, key), list) << key;
        const std::string* text = findText(json, key);
        EXPECT_EQ(text != nullptr, std::string_view{key} == "text") << key;
        EXPECT_TRUE(text == nullptr || *text == "t") << key;
    }
    for (const Json& other : kAny) {
        if (other.is_object()) continue;
        EXPECT_EQ(findMember(other, "a"), nullptr);
        EXPECT_EQ(findObject(other, "a"), nullptr);
        EXPECT_EQ(findArray(other, "a"), nullptr);
        EXPECT_EQ(findText(other, "a"), nullptr);
    }
}

TEST(JsonMembers, textsAreReadFromStringsOnly) {
    for (const Json& json : kAny) {
        EXPECT_EQ(jsonText(json) != nullptr, json.is_string());
        EXPECT_EQ(stringOrEmpty(json), json.is_string() ? "text" : "");
    }
}

TEST(JsonMembers, floatsAreReadUpToTheirLargestNumber) {
    EXPECT_EQ(floatOf(Json(1.5)), 1.5f);
    EXPECT_EQ(floatOf(Json(-3)), -3.0f);
    for (const float sign : {1.0f, -1.0f}) {
        EXPECT_EQ(floatOf(Json(double{sign * kMax})), sign * kMax);
        EXPECT_FALSE(floatOf(Json(sign * std::nextafter(double{kMax}, 1e300))).has_value());
    }
    EXPECT_FALSE(floatOf(Json(std::numeric_limits<double>::quiet_NaN())).has_value());
    for (const Json& json : kAny) EXPECT_EQ(floatOf(json).has_value(), json.is_number());
}

TEST(JsonMembers, integersAreReadUpToTheirLimitsAndWithoutFractions) {
    constexpr int kLow = std::numeric_limits<int>::min(), kHigh = std::numeric_limits<int>::max();
    for (const int value : {kLow, kLow + 1, -1, 0, 1, kHigh - 1, kHigh}) {
        EXPECT_EQ(intOf(Json(value)), value);
        EXPECT_EQ(intOf(Json(double{static_cast<double>(value)})), value);
        EXPECT_FALSE(intOf(Json(value + 0.5)).has_value()) << value;
    }
    EXPECT_FALSE(intOf(Json(std::int64_t{kHigh} + 1)).has_value());
    EXPECT_FALSE(intOf(Json(std::int64_t{kLow} - 1)).has_value());
    EXPECT_FALSE(intOf(Json(1e300)).has_value());
    for (const Json& json : kAny) EXPECT_EQ(intOf(json).has_value(), json == 1);
}

TEST(JsonMembers, hexIdsAreReadFromStringsOfHexDigits) {
    EXPECT_EQ(hexIdOf(Json("00000000000000ab")), 0xabu);
    EXPECT_EQ(hexIdOf(Json("xyz")), 0u);
    EXPECT_EQ(hexIdOf(Json(12)), 0u);
    const Json json{{"id", "ff"}, {"other", 3}};
    EXPECT_EQ(hexIdIn(json, "id"), 0xffu);
    EXPECT_EQ(hexIdIn(json, "other"), 0u);
    EXPECT_EQ(hexIdIn(json, "none"), 0u);
}

TEST(JsonMembers, objectsAreMadeWhereTheyAreMissing) {
    for (Json json : kAny) {
        const bool wasObject = json.is_object();
        makeObject(json, "made")["b"] = 2;
        makeObject(json, "made")["c"] = 3;
        EXPECT_EQ(json.dump(), wasObject ? R"({"a":1,"made":{"b":2,"c":3}})" : R"({"made":{"b":2,"c":3}})");
        makeObject(json["made"], "b")["d"] = 4;
        EXPECT_EQ(json["made"].dump(), R"({"b":{"d":4},"c":3})") << "a number is replaced";
    }
}

TEST(JsonMembers, compactTextIsOneLineAndReplacesInvalidBytes) {
    EXPECT_EQ(compactText(Json{{"a", {1, 2}}, {"b", "x\ny"}}), R"({"a":[1,2],"b":"x\ny"})");
    EXPECT_EQ(compactText(Json("\xff")), "\"\xef\xbf\xbd\"");
}

}  // namespace
}  // namespace plumb
