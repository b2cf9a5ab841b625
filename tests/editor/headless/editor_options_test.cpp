#include "editor/model/project/editor_options.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

TEST(EditorOptionsTest, exportOptionsAreParsedAndListedInTheHelp) {
    const std::vector<const char*> words{"mine", "--export", "to"};
    const auto options = parseEditorOptions(words);
    ASSERT_TRUE(options.ok());
    EXPECT_EQ(options->exportTo, "to");
    EXPECT_EQ(options->project, "mine");
    for (const char* option : {"--validate", "--export", "--screenshot"})
        EXPECT_NE(editorUsage().find(option), std::string::npos);
    const std::vector<const char*> cut{"--export"};
    EXPECT_FALSE(parseEditorOptions(cut).ok());
    const std::vector<const char*> jpeg{"--screenshot", "a.jpg"};
    EXPECT_FALSE(parseEditorOptions(jpeg).ok());
}

TEST(EditorOptionsTest, wrongOptionsAreReportedWithTheExpectedOnes) {
    const auto said = [](const std::vector<const char*>& words) {
        const auto options = parseEditorOptions(words);
        return options.ok() ? std::string{} : options.error().text();
    };
    EXPECT_EQ(said({"--validat"}), "command line: unknown option \"--validat\"; did you mean --validate?");
    EXPECT_EQ(
        said({"--theme", "pink"}),
        "command line: invalid value \"pink\" for --theme; write --theme NAME: color theme, dark or light");
    EXPECT_EQ(said({"--size", "12"}),
              "command line: invalid value \"12\" for --size; write --size WxH: window size in px, "
              "320x240 to 8192x8192, e.g. 1600x900");
    EXPECT_EQ(
        said({"--scale"}),
        "command line: --scale needs a value; write --scale RATIO: scale of the user interface, 0.75 to 3");
    EXPECT_EQ(said({"one", "two"}), "command line: \"two\" is a second project; name one project");
    EXPECT_EQ(said({"one", "--import", "level.tmx", "out.scene.json", "--theme=light"}), "");
}

TEST(EditorOptionsTest, theHelpStandsInColumnsThatFitATerminal) {
    const std::string usage = editorUsage();
    const std::vector<std::string_view> lines =
        split(trimmed(std::string_view{usage}.substr(usage.find("\n\n"))), '\n');
    EXPECT_GT(lines.size(), 12u);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_LE(lines[i].size(), 80u) << lines[i];
        ASSERT_GT(lines[i].size(), 26u) << lines[i];
        EXPECT_EQ(lines[i][25], ' ') << lines[i];
        EXPECT_NE(lines[i][26], ' ') << lines[i];
    }
}

}  // namespace
}  // namespace plumb::editor
