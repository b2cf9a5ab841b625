// Reads the editor's own files with one value replaced by a value of another type. PLUMB_TYPE_SWAPS is the
// number of variants read for each kind of file, 0 for all.

#include <fstream>

#include "editor/model/assets/input_map_edit.hpp"
#include "editor/model/clipboard.hpp"
#include "editor/model/headless/asset_names.hpp"
#include "editor/model/prefabs/make_prefab.hpp"
#include "editor/model/prefabs/override_list.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"
#include "editor/model/project/project_habits.hpp"
#include "editor/model/project/settings.hpp"
#include "editor/model/safety/journal.hpp"
#include "editor/model/safety/scene_differences.hpp"
#include "editor/model/tiles/tile_clipboard.hpp"
#include "editor/model/view/view_file.hpp"
#include "editor/templates/project_templates.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/support/type_swaps.hpp"

namespace plumb::editor {
namespace {

using test::eachTypeSwap;
using test::expectReportedWell;

constexpr std::string_view kTorch = "prefabs/torch.prefab.json";
constexpr std::string_view kLantern = "prefabs/lantern.prefab.json";
constexpr const char* kTorchText = R"({"format": 1, "layers": [], "entities": [
    {"id": "0000000000000001", "name": "torch", "components": {"Transform": {"scale": [2, 2]},
     "Sprite": {"width": 8, "height": 16}, "Camera": {"follow": "000000000000000a"}, "FromTheFuture": {"strength": 3}}},
    {"id": "000000000000000a", "name": "flame", "parent": "0000000000000001",
     "components": {"Transform": {"position": [0, -8]}, "Sprite": {"width": 4, "height": 4}}}]})";
constexpr const char* kLanternText = R"({"format": 1, "entities": [
    {"id": "20", "name": "lantern", "components": {"Transform": {}}},
    {"id": "21", "parent": "20", "prefab": "prefabs/torch.prefab.json", "without": ["Camera"],
     "components": {"Transform": {"position": [3, 4]}}, "children": {"000000000000000a": {"name": "small",
     "components": {"Sprite": {"width": 2}}}}}]})";
constexpr const char* kInstances = R"({"format": 1, "effects": {}, "layers": [], "entities": [
    {"id": "a1", "name": "one", "prefab": "prefabs/torch.prefab.json",
     "components": {"Transform": {"position": [5, 6]}, "Sprite": {"layer": 4}},
     "children": {"000000000000000a": {"components": {"Sprite": {"height": 9}}}}},
    {"id": "a2", "name": "two", "prefab": "prefabs/lantern.prefab.json", "without": ["Transform"],
     "children": {"0000000000000021": {"removed": true}}},
    {"id": "a3", "name": "plain", "parent": "a1", "components": {"Transform": {}, "Camera": {"follow": "a1"}}}]})";

class EditorTypeSwap : public EditorFixture {
protected:
    EditorTypeSwap() {
        put(kTorch, kTorchText);
        put(kLantern, kLanternText);
    }
    [[nodiscard]] const Path& root() const { return workspace.project.root; }
    /// Writes a file without syncing it to disk.
    void put(std::string_view path, std::string_view text) const {
        std::filesystem::create_directories((root() / path).parent_path());
        std::ofstream{root() / path, std::ios::binary} << text;
    }
    /// Runs the editor operations on an entity of an open scene.
    void workWith(ObjectId id) {
        const PrefabEdit edit = workspace.prefabs();
        static_cast<void>(overrideList(edit, id));
        const std::size_t before = workspace.undo.size();
        if (const Result<Done> applied = applyToPrefab(edit, id); !applied)
            expectReportedWell(applied.error());
        if (const Result<ObjectId> made = makePrefab(workspace, {id}, prefabPath("made")); !made)
            expectReportedWell(made.error());
        const std::string copied = copyAsText(workspace.document, {id});
        static_cast<void>(pasteFromText(edit, copied));
        while (workspace.undo.size() > before && workspace.undo.undo()) {
        }
        std::filesystem::remove(root() / prefabPath("made"));
    }
    void openAndWork(std::string_view path) {
        workspace.prefabs().prefabs->forget();
        const Result<LoadReport> opened = workspace.open(std::string{path});
        if (!opened) return expectReportedWell(opened.error());
        EXPECT_TRUE(parseJson(workspace.text(), "text").ok());
        for (const ObjectId id : workspace.document.objects()) workWith(id);
    }
};

TEST_F(EditorTypeSwap, propertySettings) {
    Settings settings;
    settings.remember("/home/me/game");
    settings.keepLayout("mine");
    std::string text = settings.toText();
    const std::size_t keys = text.find("\"keys\": {}");
    ASSERT_NE(keys, std::string::npos);
    text.replace(keys, 10, R"("keys": {"edit.undo": ["Ctrl+Shift+Z", "F2"], "edit.redo": []})");
    eachTypeSwap({text}, 1000, [](std::size_t, const std::string& swapped) {
        std::vector<Error> problems;
        const Result<Settings> read = Settings::fromText(swapped, problems);
        expectReportedWell(problems);
        if (!read) return expectReportedWell(read.error());
        EXPECT_TRUE(parseJson(read->toText(), "settings").ok());
    });
}

TEST_F(EditorTypeSwap, propertyEditorStateOfAProject) {
    const std::vector<std::string> samples{
        R"({"hidden": ["0000000000000001"], "locked": ["0000000000000002", "x"]})",
        R"({"size": [16, 8], "snap": true, "to": "half grid", "snapAngles": false, "angle": 0.5, "color": [1, 2, 3, 4]})",
        R"(["edit.undo", "edit.redo"])"};
    const std::vector<std::string> files{".plumb/view/scenes/level.scene.json.view", ".plumb/grid.json",
                                         ".plumb/recent.json"};
    eachTypeSwap(samples, 1000, [&](std::size_t i, const std::string& text) {
        put(files[i], text);
        EntityView view;
        ViewFile{root()}.read(kScene, view);
        readGrid(workspace);
        EXPECT_LE(recentChoices(workspace, 5).size(), 5u);
    });
}

TEST_F(EditorTypeSwap, propertyJournals) {
    const Journal journal{workspace.document.types(), root()};
    eachTypeSwap({R"({"journal": 1, "scene": "scenes/level.scene.json"})"}, 1000,
                 [&](std::size_t, const std::string& text) {
                     std::string line = text;
                     std::replace(line.begin(), line.end(), '\n', ' ');
                     put(".plumb/session3/scenes+level.scene.json.journal", line + "\n{}");
                     EXPECT_LE(journal.lostWork().size(), 1u);
                 });
}

TEST_F(EditorTypeSwap, propertyClipboards) {
    TileStamp stamp{2, 2, {1, 2, 3, 4}};
    const std::string tiles = tilesAsText(stamp);
    const std::string entities = copyAsText(workspace.document, workspace.document.objects());
    eachTypeSwap({tiles, entities}, 1000, [&](std::size_t, const std::string& text) {
        static_cast<void>(tilesFromText(text));
        Pasted pasted = pasteFromText(workspace.prefabs(), text);
        if (!pasted.command) return;
        workspace.undo.push(std::move(pasted.command));
        EXPECT_TRUE(workspace.undo.undo());
    });
}

TEST_F(EditorTypeSwap, propertyScenes) {
    eachTypeSwap({std::string{kSceneText}, kInstances}, 30, [&](std::size_t, const std::string& text) {
        put(kScene, text);
        openAndWork(kScene);
        static_cast<void>(sceneDifferences(kInstances, text));
        AssetNames{workspace.document.types()}.read("scene", text);
    });
}

TEST_F(EditorTypeSwap, propertyPrefabs) {
    const std::vector<std::string> samples{kTorchText, kLanternText};
    eachTypeSwap(samples, 20, [&](std::size_t i, const std::string& text) {
        put(kTorch, kTorchText);
        put(i == 0 ? kTorch : kLantern, text);
        put(kScene, kInstances);
        openAndWork(kScene);
        openAndWork(i == 0 ? kTorch : kLantern);
    });
}

TEST_F(EditorTypeSwap, propertyInputMaps) {
    constexpr const char* kProject = R"({"name": "Test", "ours": [1, 2], "input": {"actions":
        {"Dash": ["X", "Pad B"], "Jump": ["Space"]}, "axes": {"Turn": {"negative": ["Q"], "positive": ["E"],
        "analog": []}}, "deadZone": 0.2}})";
    eachTypeSwap({kProject}, 20, [&](std::size_t, const std::string& text) {
        put("project.json", text);
        EXPECT_FALSE(projectNameOf(root()).empty());
        using Kind = InputMapEdit::Kind;
        InputMapEdit edit{workspace};
        edit.refresh();
        const Result<Done> tried[] = {edit.rename(Kind::Action, "Dash", "Roll"),
                                      edit.remove(Kind::Axis, "Turn"), edit.add(Kind::Action, "Shout"),
                                      edit.unbind({Kind::Action, "Jump", ""}, 0)};
        for (const Result<Done>& one : tried) {
            if (!one) expectReportedWell(one.error());
        }
    });
}

}  // namespace
}  // namespace plumb::editor
