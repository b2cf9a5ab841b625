#include "import/loaders/xml.hpp"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/limits.hpp"
#include "core/random.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::string_view kDocument = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE map SYSTEM "http://mapeditor.org/dtd/1.0/map.dtd">
<!-- a map -->
<map version='1.5' name="a &lt;b&gt; &#65;&#x42; &amp;&quot;&apos;">
 <layer id="1"/>
 <layer id="2">one<![CDATA[ <two> ]]>three</layer>
 <?target nothing?>
 <größe/>
</map>
)";

TEST(XmlTest, elementsAttributesTextAndLinesAreRead) {
    const Result<XmlElement> root = parseXml(kDocument, "map.tmx");

    ASSERT_TRUE(root.ok()) << root.error().text();
    EXPECT_EQ(root->name, "map");
    EXPECT_EQ(root->line, 4);
    EXPECT_EQ(*root->find("version"), "1.5");
    EXPECT_EQ(*root->find("name"), "a <b> AB &\"'");
    EXPECT_EQ(root->find("none"), nullptr);
    ASSERT_EQ(root->children.size(), 3u);
    EXPECT_EQ(root->children[1].text, "one <two> three");
    EXPECT_EQ(root->children[1].line, 6);
    EXPECT_EQ(root->child("größe"), &root->children[2]);
    EXPECT_EQ(root->child("image"), nullptr);
}

TEST(XmlTest, lineEndsAndSpacesInAttributesAreNormalized) {
    const Result<XmlElement> root = parseXml("\xef\xbb\xbf<a b='1\t2\r\n3'>x\r\ny\rz</a>", "test");

    ASSERT_TRUE(root.ok()) << root.error().text();
    EXPECT_EQ(root->text, "x\ny\nz");
    EXPECT_EQ(*root->find("b"), "1 2 3");
}

TEST(XmlTest, malformedTextIsRejectedWithItsLine) {
    const struct {
        const char* text;
        const char* where;
    } cases[] = {{"", "f:1"},
                 {"no element", "f:1"},
                 {"<a>", "f:1"},
                 {"<a>\n<b>\n</a>", "f:3"},
                 {"<a\nb=1/>", "f:2"},
                 {"<a b='1' b='2'/>", "f:1"},
                 {"<a b='1'c='2'/>", "f:1"},
                 {"<a b='<'/>", "f:1"},
                 {"<a>\n&nbsp;</a>", "f:2"},
                 {"<a>&#0;</a>", "f:1"},
                 {"<a>&#xD800;</a>", "f:1"},
                 {"<a>&#x110000;</a>", "f:1"},
                 {"<a>& b</a>", "f:1"},
                 {"<a/>\n<b/>", "f:2"},
                 {"<a><!-- never ends</a>", "f:1"},
                 {"<a><![CDATA[ never ends</a>", "f:1"},
                 {"<?xml", "f:1"},
                 {"<a>\x01</a>", "f:1"},
                 {"<a>\xff</a>", "f:1"}};
    for (const auto& test : cases) {
        SCOPED_TRACE(test.text);
        const Result<XmlElement> root = parseXml(test.text, "f");
        ASSERT_FALSE(root.ok());
        EXPECT_EQ(root.error().where, test.where);
        EXPECT_FALSE(root.error().what.empty());
        EXPECT_FALSE(root.error().remedy.empty());
    }
}

TEST(XmlTest, exponentiallyExpandingEntitiesAreRejected) {
    const char* bomb =
        "<!DOCTYPE lolz [<!ENTITY lol \"lol\"><!ENTITY lol2 \"&lol;&lol;&lol;\">]>\n<lolz>&lol2;</lolz>";

    EXPECT_FALSE(parseXml(bomb, "f").ok());
    EXPECT_FALSE(parseXml("<a>&lol2;</a>", "f").ok());
}

std::string errorOf(std::string_view document) {
    const Result<XmlElement> root = parseXml(document, "map.tmx");
    return root.ok() ? "no error" : root.error().text();
}

std::string nested(int depth) {
    std::string open, close;
    for (int i = 0; i < depth; ++i) {
        open += "<a>\n";
        close += "</a>";
    }
    return open + close;
}

TEST(XmlTest, depthIsLimitedSoThatTheStackIsSafe) {
    EXPECT_EQ(errorOf(nested(limits::kXmlDepth)), "no error");
    const std::string tooDeep =
        format("map.tmx:{}: elements are nested too deep; reduce the nesting", limits::kXmlDepth + 1);
    EXPECT_EQ(errorOf(nested(limits::kXmlDepth + 1)), tooDeep);
    EXPECT_EQ(errorOf(nested(100'000)), tooDeep);
}

std::string withAttributes(int count) {
    std::string document = "\n<a";
    for (int i = 0; i < count; ++i) document += format(" a{}='{}'", i, i * i);
    return document + "/>";
}

TEST(XmlTest, anElementHasAtMost256Attributes) {
    const Result<XmlElement> root = parseXml(withAttributes(256), "map.tmx");
    ASSERT_TRUE(root.ok()) << root.error().text();
    ASSERT_EQ(root->attributes.size(), 256u);
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(root->attributes[static_cast<std::size_t>(i)].name, format("a{}", i));
        EXPECT_EQ(*root->find(format("a{}", i)), format("{}", i * i));
    }
    EXPECT_EQ(errorOf(withAttributes(257)), "map.tmx:2: too many attributes; remove some");
}

TEST(XmlTest, theFirstElementBeyondTheLimitIsReported) {
    std::string group = "<a>";
    for (int i = 1; i < 1024; ++i) group += "<b/>";
    group += "</a>";
    std::string document = "<m>";
    for (std::size_t i = 1; i < limits::kXmlElements / 1024; ++i) document += group;
    for (int i = 2; i < 1024; ++i) document += "<b/>";  // with <m>, all of the last 1024 but one
    document += "\n<b/>\n<b/></m>";
    EXPECT_EQ(errorOf(document), "map.tmx:3: too many elements; split the file, or use csv data");
}

TEST(XmlTest, aFileThatIsTooLargeIsNotRead) {
    // Its characters are never touched, so that the memory is only reserved.
    const std::size_t size = limits::kFileBytes + 1;
    const std::unique_ptr<char[]> memory{new char[size]};
    EXPECT_EQ(errorOf({memory.get(), size}), "map.tmx:1: the file is too large; split it");
}

TEST(XmlTest, errorsNameTheLineTheReasonAndTheRemedy) {
    const std::string remedy = "; correct the line, or export the file again";
    EXPECT_EQ(errorOf(""), "map.tmx:1: no element found" + remedy);
    EXPECT_EQ(errorOf("<a>\n\n</b>"), "map.tmx:3: mismatched tag" + remedy);
    EXPECT_EQ(errorOf("<a x='1'\nx='2'/>"), "map.tmx:2: duplicate attribute" + remedy);
    EXPECT_EQ(errorOf("<a>\n&b;</a>"), "map.tmx:2: undefined entity" + remedy);
    EXPECT_EQ(errorOf("<!DOCTYPE a SYSTEM 'a.dtd'>\n<a>\n&nbsp;&copy;</a>"),
              "map.tmx:3: the entity &nbsp; is unknown; write the character itself");
    EXPECT_EQ(errorOf("\n<!DOCTYPE a [<!ENTITY b 'c'>]>\n<a/>"),
              "map.tmx:2: a DOCTYPE with declarations is not supported; remove it");
    EXPECT_EQ(errorOf("<!DOCTYPE a>\n<a/>"), "no error");
}

TEST(XmlTest, theFirstAttributeAndChildOfANameAreFound) {
    const Result<XmlElement> root =
        parseXml("<a x='1' y='2'>\n 1<b n='1'/>2<c/>\n<b n='2'>x</b>3\n</a>", "map.tmx");
    ASSERT_TRUE(root.ok()) << root.error().text();
    ASSERT_EQ(root->children.size(), 3u);
    EXPECT_EQ(*root->find("x"), "1");
    EXPECT_EQ(*root->find("y"), "2");
    EXPECT_EQ(root->find("z"), nullptr);
    EXPECT_EQ(root->child("b"), &root->children[0]);
    EXPECT_EQ(root->child("c"), &root->children[1]);
    EXPECT_EQ(root->child("a"), nullptr);
    EXPECT_EQ(root->text, "\n 12\n3\n") << "not the text of its children";
    EXPECT_EQ(root->children[2].text, "x");
    EXPECT_EQ(root->children[1].line, 2);
    EXPECT_EQ(root->children[2].line, 3);
}

TEST(XmlTest, everyTruncationAndManyMutationsAreReadOrRejected) {
    for (std::size_t length = 0; length + 8 < kDocument.size(); ++length) {
        EXPECT_FALSE(parseXml(kDocument.substr(0, length), "f").ok()) << length;
    }
    Random random = Random::seeded(11);
    for (int i = 0; i < 5000; ++i) {
        std::string text{kDocument};
        for (std::uint32_t change = 0; change <= random.below(3); ++change) {
            text[random.below(static_cast<std::uint32_t>(text.size()))] =
                "<>&;\"'/! \xff"
                "ab["[random.below(13)];
        }
        const Result<XmlElement> root = parseXml(text, "f");
        EXPECT_TRUE(root.ok() || !root.error().what.empty());
    }
}

}  // namespace
}  // namespace plumb
