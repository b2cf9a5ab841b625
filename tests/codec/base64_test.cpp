#include "codec/base64.hpp"

#include <string>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// The encoding by its definition in RFC 4648, section 4: groups of six bits, from the highest.
std::string encodedByBits(std::string_view bytes) {
    std::string bits;
    for (const char c : bytes) {
        for (int bit = 7; bit >= 0; --bit)
            bits += (static_cast<unsigned char>(c) >> bit & 1) != 0 ? '1' : '0';
    }
    while (bits.size() % 6 != 0) bits += '0';
    std::string text;
    for (std::size_t at = 0; at < bits.size(); at += 6)
        text += kDigits[std::stoul(bits.substr(at, 6), nullptr, 2)];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

/// The bytes, or the text of the error.
std::string decoded(std::string_view text) {
    const Result<std::string> bytes = bytesFromBase64(text, "map.tmx");
    return bytes.ok() ? *bytes : bytes.error().text();
}

std::string brokenText(std::string_view what) {
    return format("map.tmx: {}; export the file again; base64 text is damaged easily by editors", what);
}

TEST(Base64Test, theExamplesOfTheSpecificationAreEncodedAndDecoded) {
    const struct {
        const char* bytes;
        const char* text;
    } cases[] = {{"", ""},
                 {"f", "Zg=="},
                 {"fo", "Zm8="},
                 {"foo", "Zm9v"},
                 {"foob", "Zm9vYg=="},
                 {"fooba", "Zm9vYmE="},
                 {"foobar", "Zm9vYmFy"}};
    for (const auto& test : cases) {  // RFC 4648, section 10
        EXPECT_STREQ(toBase64(test.bytes).c_str(), test.text);
        EXPECT_EQ(decoded(test.text), test.bytes);
        const std::string_view text{test.text};
        EXPECT_EQ(decoded(text.substr(0, text.find('='))), test.bytes) << "without padding";
    }
}

TEST(Base64Property, theTextEqualsTheDefinitionAndReadsBack) {
    Random random = Random::seeded(5);
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    for (int length = 0; length < 200; ++length) {
        SCOPED_TRACE(length);
        const std::string text = toBase64(bytes);
        ASSERT_STREQ(text.c_str(), encodedByBits(bytes).c_str());
        ASSERT_EQ(text.size(), (bytes.size() + 2) / 3 * 4);
        ASSERT_EQ(decoded(text), bytes);
        bytes.clear();
        for (int i = 0; i <= length; ++i) bytes += static_cast<char>(random.below(256));
    }
}

TEST(Base64Test, onlyTheGivenBytesAndBitsCount) {
    const std::string_view all = "foobar";
    EXPECT_EQ(toBase64(all.substr(0, 4)), "Zm9vYg==") << "not what follows them in memory";
    EXPECT_EQ(toBase64(all.substr(0, 5)), "Zm9vYmE=");
    EXPECT_STREQ(bytesFromBase64("Zv", "test")->c_str(), "f") << "bits beyond the last byte";
    EXPECT_STREQ(bytesFromBase64("Zm/", "test")->c_str(), "fo");
}

TEST(Base64Test, whiteSpaceIsSkippedAtEveryPlace) {
    for (const char* space : {" ", "\n", "\r", "\t", "\r\n\t  "}) {
        for (std::size_t at = 0; at <= 8; ++at) {
            std::string text = "Zm9vYg==";
            text.insert(at, space);
            EXPECT_EQ(decoded(text), "foob") << at;
        }
    }
    EXPECT_EQ(decoded(" \n"), "");
}

TEST(Base64Test, everyOtherCharacterIsReportedWithItsPosition) {
    for (int code = 0; code < 256; ++code) {
        const char c = static_cast<char>(code);
        if (kDigits.find(c) != std::string_view::npos) continue;
        if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
        for (std::size_t at = 0; at < 7; ++at) {
            SCOPED_TRACE(testing::Message() << code << " at " << at);
            std::string text = "Zm9vYmFy";
            text[at] = c;
            ASSERT_EQ(decoded(text),
                      brokenText(c == '=' ? std::string{"the base64 text continues after its padding"}
                                          : format("character {} is not a base64 digit", at + 1)));
        }
    }
}

TEST(Base64Test, aWrongLengthIsReported) {
    const std::string_view length = "the base64 text has an invalid length";
    const std::string_view padding = "the base64 text continues after its padding";
    EXPECT_EQ(decoded("Z"), brokenText(length));
    EXPECT_EQ(decoded("Z=="), brokenText(length));
    EXPECT_EQ(decoded("Zm9vY"), brokenText(length));
    EXPECT_EQ(decoded("Zm9v==="), brokenText(length)) << "at most two characters are padding";
    EXPECT_EQ(decoded("Z==="), brokenText(padding));
    EXPECT_EQ(decoded("===="), brokenText(padding));
    EXPECT_EQ(decoded("Zg==Zm9v"), brokenText(padding));
    EXPECT_EQ(decoded("Zm9v=Zm9v"), brokenText(length));
}

}  // namespace
}  // namespace plumb
