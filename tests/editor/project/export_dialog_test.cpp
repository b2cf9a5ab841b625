// The menu item Export...: it runs the editor's own command. A script that notes its arguments stands for it.

#include <filesystem>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/project/export_task.hpp"
#include "editor/model/project/program.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

#if !defined(_WIN32)

namespace plumb::editor::ui {
namespace {

class ExportWindow : public EditorFixture {
protected:
    ExportWindow() : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        hands.click("Menu/File");
        hands.click("Menu/File/Export...");
        hands.rest(3);
    }
    /// Puts a shell script in the place of the editor's program.
    void standIn(std::string_view lines) {
        putFile("stand-in", std::string{"#!/bin/sh\n"} + std::string{lines});
        workspace.program = workspace.project.root / "stand-in";
        std::filesystem::permissions(workspace.program, std::filesystem::perms::owner_all);
    }
    [[nodiscard]] std::string valueOf(std::string_view widget) const {
        const WidgetMap::Widget* found = window.widgets().find(widget);
        return found == nullptr ? "not on the screen" : found->value;
    }
    /// Types a folder, presses Enter and waits for the result.
    void exportTo(std::string_view folder) {
        hands.key(Key::A, {.control = true});
        hands.type(folder);
        hands.key(Key::Enter);
        for (int i = 0; i < 100000 && valueOf("Export/report").empty(); ++i) hands.rest();
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(ExportWindow, theProjectIsExportedByTheCommandAndTheSceneStaysAsItIs) {
    standIn("printf '%s\\n' \"$@\" > \"$0.words\"\necho checked\necho 'Exported 3 files'\n");
    const std::string offered = valueOf("Export/folder");
    const Path root = std::filesystem::absolute(workspace.project.root);
    EXPECT_EQ(Path{offered}.parent_path(), root.parent_path()) << "beside the project, not inside it";
    exportTo("/tmp/my game");
    EXPECT_EQ(fileText("stand-in.words"), workspace.project.root.string() + "\n--export\n/tmp/my game\n");
    EXPECT_EQ(valueOf("Export/report"), "checked\nExported 3 files\n");
    EXPECT_EQ(workspace.notice, "Exported 3 files");
    EXPECT_EQ(workspace.text(), kSceneText);
    hands.click("Export/Close");
    hands.rest(2);
    EXPECT_EQ(valueOf("Export/report"), "not on the screen");
}

/// A checkout with a stand-in for the script, and the editor in its build folder.
class ExportFromSources : public ExportWindow {
protected:
    ExportFromSources() {
        putFile("sources/player/targets/export.sh", "");
        putFile("sources/build/release/bin/plumb-editor", "");
        workspace.program = workspace.project.root / "sources/build/release/bin/plumb-editor";
        hands.rest();
    }
    void script(std::string_view lines) {
        putFile("sources/plumb", std::string{"#!/bin/sh\n"} + std::string{lines});
        std::filesystem::permissions(workspace.project.root / "sources/plumb",
                                     std::filesystem::perms::owner_all);
        hands.rest();
    }
    void choose(std::string_view label) {
        hands.click("Export/target");
        hands.rest(2);
        hands.click(format("Export/target/{}", label));
        hands.rest(2);
    }
    [[nodiscard]] std::string offered() const { return Path{valueOf("Export/folder")}.filename().string(); }
};

TEST_F(ExportFromSources, otherSystemsAreThoseOfTheScriptAndTheFolderIsNamedLikeThem) {
    script("printf '%s\\n' \"$@\" > \"$0.words\"\necho 'Exported for Windows'\n");
    const std::string project = workspace.project.root.filename().string();
    choose("Web browsers");
    EXPECT_EQ(offered(), project + "-web");
    choose("Windows");
    EXPECT_EQ(offered(), project + "-windows");
    hands.click("Export/folder");
    exportTo("/tmp/my game");
    EXPECT_EQ(fileText("sources/plumb.words"),
              format("export\n{}\n/tmp/my game\n--to\nwindows\n", workspace.project.root.string()));
    EXPECT_EQ(valueOf("Export/report"), "Exported for Windows\n");
    EXPECT_NE(valueOf("Export/Open folder"), "not on the screen");
}

TEST_F(ExportFromSources, aFolderThatTheUserWroteStaysWhenTheSystemIsChanged) {
    script("");
    hands.click("Export/folder");
    hands.key(Key::A, {.control = true});
    hands.type("/tmp/mine");
    choose("Linux");
    EXPECT_EQ(valueOf("Export/folder"), "/tmp/mine");
}

TEST_F(ExportFromSources, withoutTheScriptThereIsOnlyThisComputer) {
    EXPECT_EQ(plumbScript(workspace.program), Path{});
    hands.click("Export/target");
    hands.rest(2);
    EXPECT_NE(valueOf("Export/target/This computer"), "not on the screen");
    EXPECT_EQ(valueOf("Export/target/Windows"), "not on the screen");
    script("");
    EXPECT_EQ(plumbScript(workspace.program),
              std::filesystem::canonical(workspace.project.root) / "sources/plumb");
}

TEST_F(ExportFromSources, aRunningExportIsStoppedWithAllThatItStarted) {
    script("sleep 60 &\necho $! > \"$0.child\"\necho started\nwait\n");
    choose("Windows");
    hands.click("Export/folder");
    hands.key(Key::A, {.control = true});
    hands.type("/tmp/none");
    hands.key(Key::Enter);
    const auto waitFor = [&](const auto& done) {
        for (int i = 0; i < 100000 && !done(); ++i) hands.rest();
        return done();
    };
    const Path childFile = workspace.project.root / "sources/plumb.child";
    ASSERT_TRUE(waitFor([&] { return fileExists(childFile) && !readFile(childFile)->empty(); }));
    hands.click("Export/Stop");
    ASSERT_TRUE(waitFor([&] { return !valueOf("Export/report").empty(); }));
    EXPECT_EQ(valueOf("Export/Open folder"), "not on the screen");
    const std::string child{trimmed(fileText("sources/plumb.child"))};
    EXPECT_TRUE(waitFor([&] { return !runProgram({"kill", "-0", child}).succeeded; })) << "it still runs";
}

TEST_F(ExportWindow, whatGoesWrongIsSaidInTheDialogAndTheConsole) {
    standIn("echo 'plumb-editor: nothing was exported' >&2\nexit 1\n");
    exportTo("anywhere");
    EXPECT_EQ(valueOf("Export/report"), "plumb-editor: nothing was exported\n");
    ASSERT_FALSE(log.lines().empty());
    EXPECT_EQ(log.lines().back().level, LogLevel::Error);
}

TEST(Programs, areHeardWhileTheyRun) {
    std::stop_source source;
    std::string heard;
    const ProgramEnd end = runProgram(
        {"sh", "-c", "echo one; exec sleep 60"},
        [&](std::string_view text) {
            heard += text;
            source.request_stop();  // long before its end
        },
        source.get_token());
    EXPECT_EQ(heard, "one\n");
    EXPECT_EQ(end.text, heard);
    EXPECT_FALSE(end.succeeded);
}

TEST(Programs, getTheirWordsUnchangedAndAMissingOneIsAnError) {
    const std::vector<std::string> odd{"a b", "$HOME", "'\"", "*", ";", ""};
    std::vector<std::string> words{"printf", "%s|"};
    words.insert(words.end(), odd.begin(), odd.end());
    const ProgramEnd end = runProgram(words);
    EXPECT_TRUE(end.succeeded);
    EXPECT_EQ(end.text, "a b|$HOME|'\"|*|;||");
    EXPECT_FALSE(runProgram({"false"}).succeeded);
    EXPECT_FALSE(runProgram({"/no/such/program"}).succeeded);
    const Result<Done> started = startProgram({"/no/such/program"});
    ASSERT_FALSE(started.ok());
    EXPECT_EQ(started.error().where, "/no/such/program");
}

}  // namespace
}  // namespace plumb::editor::ui

#endif
