#include "codec/xml.hpp"

#include <gtest/gtest.h>

#include "core/limits.hpp"
#include "core/random.hpp"

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

TEST(XmlTest, depthIsLimitedSoThatTheStackIsSafe) {
    std::string deep;
    for (int i = 0; i < limits::kXmlDepth; ++i) deep += "<a>";
    std::string closed = deep;
    for (int i = 0; i < limits::kXmlDepth; ++i) closed += "</a>";

    EXPECT_TRUE(parseXml(closed, "f").ok());
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    EXPECT_FALSE(parseXml(deep, "f").ok());
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
