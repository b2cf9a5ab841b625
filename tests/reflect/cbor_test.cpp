#include "reflect/cbor.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

std::string bytesOf(std::string_view hex) {
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes += static_cast<char>(static_cast<unsigned char>(*parseHex(hex.substr(i, 2))));
    return bytes;
}

/// The JSON text of CBOR that is given as hex digits; "error" if it is refused.
std::string read(std::string_view hex, const JsonLimits& limits = {}) {
    const Result<Json> json = readCbor(bytesOf(hex), "x", limits);
    return json ? json->dump() : "error";
}

std::string errorOf(std::string_view bytes, const JsonLimits& limits = {}) {
    const Result<Json> json = readCbor(bytes, "save.dat", limits);
    return json ? "" : json.error().text();
}

TEST(Cbor, readsTheExamplesOfItsStandard) {
    // Source: RFC 8949, appendix A.
    const std::vector<std::pair<std::string_view, std::string_view>> examples{
        {"00", "0"},
        {"17", "23"},
        {"1818", "24"},
        {"1903e8", "1000"},
        {"1a000f4240", "1000000"},
        {"1bffffffffffffffff", "18446744073709551615"},
        {"20", "-1"},
        {"3903e7", "-1000"},
        {"f93c00", "1.0"},
        {"fa47c35000", "100000.0"},
        {"fb3ff199999999999a", "1.1"},
        {"f4", "false"},
        {"f5", "true"},
        {"f6", "null"},
        {"60", "\"\""},
        {"6449455446", "\"IETF\""},
        {"62c3bc", "\"\xc3\xbc\""},
        {"80", "[]"},
        {"83010203", "[1,2,3]"},
        {"8301820203820405", "[1,[2,3],[4,5]]"},
        {"a0", "{}"},
        {"a26161016162820203", R"({"a":1,"b":[2,3]})"},
        {"826161a161626163", R"(["a",{"b":"c"}])"},
        {"9fff", "[]"},
        {"9f018202039f0405ffff", "[1,[2,3],[4,5]]"},
        {"bf61610161629f0203ffff", R"({"a":1,"b":[2,3]})"}};
    for (const auto& [hex, json] : examples) EXPECT_EQ(read(hex), json) << hex;
}

TEST(Cbor, refusesWhatJsonCannotHave) {
    for (const char* hex : {"f97e00", "f97c00", "fa7f800000", "fb7ff0000000000000", "8201f97e00"})
        EXPECT_EQ(read(hex), "error") << hex << ": not finite";
    EXPECT_EQ(errorOf(bytesOf("f97e00")), "save.dat: a number that is not finite; save the file again");
    EXPECT_EQ(errorOf(bytesOf("4401020304")), "save.dat: binary data is not supported; save the file again");
    EXPECT_EQ(errorOf(bytesOf("61ff")), "save.dat: a string is not UTF-8; save the file again");
    EXPECT_EQ(errorOf(bytesOf("a161ff01")), "save.dat: a string is not UTF-8; save the file again");
    EXPECT_EQ(read("a10102"), "error") << "a key that is no string";
}

TEST(Cbor, refusesEveryPartOfAFileAndNamesTheByte) {
    const std::string whole = writeCbor(Json{{"name", "door"}, {"at", {1, 2.5, -300}}, {"open", true}});
    ASSERT_TRUE(readCbor(whole, "x").ok());
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_NE(errorOf(whole.substr(0, size)).find("save.dat: byte "), std::string::npos) << size;
    EXPECT_FALSE(readCbor(whole + "x", "x").ok()) << "more than one value";
}

TEST(Cbor, limitsAreAcceptedExactlyAndOneMoreIsRefused) {
    const std::string list = writeCbor(Json{1, "abc", {{"key", 2}}});  // 5 values
    EXPECT_TRUE(readCbor(list, "x", {.bytes = list.size()}).ok());
    EXPECT_EQ(
        errorOf(list, {.bytes = list.size() - 1}),
        format("save.dat: the file has {} bytes, the limit is {}; split it", list.size(), list.size() - 1));
    EXPECT_TRUE(readCbor(list, "x", {.values = 5}).ok());
    for (std::size_t values = 0; values < 5; ++values)
        EXPECT_EQ(errorOf(list, {.values = values}),
                  format("save.dat: more than {} values; split the file", values));
    EXPECT_TRUE(readCbor(list, "x", {.textBytes = 3}).ok());
    EXPECT_EQ(errorOf(list, {.textBytes = 2}), "save.dat: a string longer than 2 bytes; shorten it");
    EXPECT_EQ(errorOf(writeCbor(Json{{"long", 1}}), {.textBytes = 3}),
              "save.dat: a string longer than 3 bytes; shorten it")
        << "keys too";
    for (const int depth : {0, 1, 2, 5, 64}) {
        const std::string inner = std::string(static_cast<std::size_t>(depth), '\x81') + '\x01';
        EXPECT_TRUE(readCbor(inner, "x", {.depth = depth}).ok()) << depth;
        EXPECT_EQ(errorOf('\x81' + inner, {.depth = depth}),
                  format("save.dat: nested deeper than {} levels; flatten the file", depth));
        std::string objects;
        for (int i = 0; i < depth; ++i) objects += bytesOf("a16161");
        EXPECT_TRUE(readCbor(objects + '\x01', "x", {.depth = depth}).ok()) << depth;
        EXPECT_FALSE(readCbor(bytesOf("a16161") + objects + '\x01', "x", {.depth = depth}).ok()) << depth;
    }
    EXPECT_TRUE(readCbor(bytesOf("828101820203"), "x", {.depth = 2}).ok()) << "closed ones do not count";
    EXPECT_TRUE(readCbor(bytesOf("8380a080"), "x", {.depth = 2}).ok());
}

// NOLINTNEXTLINE(misc-no-recursion)
Json randomValue(Random& random, int depth) {
    switch (random.below(depth > 3 ? 6 : 8)) {
        case 0: return nullptr;
        case 1: return random.below(2) == 1;
        case 2: return static_cast<std::int64_t>(random.next64()) >> random.below(64);
        case 3: return random.next64() >> random.below(64);
        case 4: return random.between(-1e6f, 1e6f) * (random.below(2) == 0 ? 1.0 : 1.0 / 3.0);
        case 5: return std::string(random.below(300), 'a');
        case 6: {
            Json array = Json::array();
            for (std::uint32_t n = random.below(30); n > 0; --n)
                array.push_back(randomValue(random, depth + 1));
            return array;
        }
        default: {
            Json object = Json::object();
            for (std::uint32_t n = random.below(6); n > 0; --n)
                object["key" + std::to_string(n)] = randomValue(random, depth + 1);
            return object;
        }
    }
}

TEST(CborProperty, writtenValuesReadBackInTheirOrder) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        Random random = Random::seeded(seed);
        const Json json = randomValue(random, 0);
        const std::string bytes = writeCbor(json);
        const Result<Json> read = readCbor(bytes, "x");
        ASSERT_TRUE(read.ok()) << seed;
        ASSERT_EQ(read->dump(), json.dump()) << seed;
        ASSERT_EQ(writeCbor(*read), bytes) << seed;
    }
}

TEST(Cbor, numbersThatFitIntoAFloatTakeFourBytes) {
    EXPECT_EQ(writeCbor(0.5), bytesOf("fa3f000000"));
    EXPECT_EQ(writeCbor(double{0.1f}), bytesOf("fa3dcccccd"));
    EXPECT_EQ(writeCbor(0.1), bytesOf("fb3fb999999999999a"));
}

}  // namespace
}  // namespace plumb
