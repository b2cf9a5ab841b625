#include <imgui.h>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/animation_edit.hpp"
#include "editor/model/assets/make_tileset.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "editor/model/assets/sheet_slicer.hpp"
#include "platform/image_file.hpp"
#include "scene/components/drawing/animator.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/hands.hpp"
#include "tests/support/places.hpp"

namespace plumb::editor::ui {
namespace {

/// An image with one shape in each of five cells of 8 x 8 px; the sixth cell is empty.
Image sheet() {
    Image image{16, 24, std::vector<std::uint8_t>(16 * 24 * 4, 0)};
    for (const auto& [left, top] : {std::pair{1, 1}, {10, 2}, {2, 9}, {9, 10}, {1, 17}}) {
        for (int y = top; y < top + 5; ++y) {
            for (int x = left; x < left + 5; ++x)
                image.rgba[static_cast<std::size_t>(y * 16 + x) * 4 + 3] = 255;
        }
    }
    return image;
}

class AssetsPanelTest : public EditorFixture {
protected:
    AssetsPanelTest()
        : window{workspace, log, nullptr, test::sourceFolder() / "assets/fonts"}, hands{window} {
        putFile("assets/hero.png", *encodePng(sheet()));
        putFile("assets/use.tileset.json", R"({"format": 1, "image": "assets/hero.png"})");
        show("Assets");
    }
    void show(const char* panel) {
        hands.click(std::string{"Tab/"} + panel);
        hands.rest(40);  // the browser checks for new files twice per second
    }
    [[nodiscard]] const std::string& valueOf(std::string_view widget) const {
        static const std::string none;
        const auto* found = window.widgets().find(widget);
        EXPECT_NE(found, nullptr) << widget;
        return found == nullptr ? none : found->value;
    }
    void doubleClick(std::string_view widget) {
        hands.click(widget);
        hands.clickAt(hands.middleOf(widget));
    }

    LogBook log;
    EditorWindow window;
    Hands hands;
};

TEST_F(AssetsPanelTest, filesAreFoundByTheirNameAndFoldersEntered) {
    hands.click("Assets/search");
    hands.type("use");
    hands.rest(2);
    EXPECT_EQ(valueOf("Assets/assets/use.tileset.json"), "tileset");
    EXPECT_EQ(window.widgets().find("Assets/assets/hero.png"), nullptr);
    hands.click("Assets/folder/scenes");
    hands.rest(2);
    EXPECT_EQ(valueOf("Assets/scenes/level.scene.json"), "scene");
}

TEST_F(AssetsPanelTest, wholeRowsAreSeenAndNamesAreCutOnlyWhereThereIsNoRoom) {
    for (int i = 0; i < 40; ++i) putFile(format("assets/many/picture{}.png", i), *encodePng(sheet()));
    putFile("assets/many/a_very_long_name_of_a_picture.png", *encodePng(sheet()));
    hands.rest(60);
    hands.click("Assets/folder/assets/many");
    hands.rest(2);
    EXPECT_EQ(valueOf("Assets/name/assets/many/picture0.png"), "picture0.png");
    EXPECT_NE(valueOf("Assets/name/assets/many/a_very_long_name_of_a_picture.png").find(".."),
              std::string::npos);
    // The panel ends 12 px above the notice, up to rounding. No row may begin inside the panel and end below
    // it.
    const float end = window.widgets().find("Status/notice")->box.min.y;
    int seen = 0;
    for (const auto& [path, widget] : window.widgets().all()) {
        if (path.find("Assets/assets/many/") != 0 || widget.box.min.y >= end - 14.0f) continue;
        ++seen;
        EXPECT_LE(widget.box.max.y, end) << path;
    }
    EXPECT_GT(seen, 10);
}

TEST_F(AssetsPanelTest, anImageDraggedIntoTheSceneIsPlacedWhereItIsDropped) {
    workspace.grid.snap = false;
    const Vec2 target = hands.middleOf("Viewport");
    hands.drag(hands.middleOf("Assets/assets/hero.png"), target);
    hands.rest(2);
    ASSERT_EQ(workspace.undo.size(), 1u) << workspace.notice;
    const EntityId made = workspace.document.find(workspace.document.selection.all().at(0));
    EXPECT_EQ(std::as_const(workspace.document.world).get<Sprite>(made).height, 24);
    EXPECT_LT(distance(workspace.view.toScreenPoint(positionOf(workspace.document.selection.all()[0])),
                       target - window.widgets().find("Viewport")->box.min),
              2.0f);
    workspace.undo.undo();
    EXPECT_EQ(workspace.text(), kSceneText);
}

TEST_F(AssetsPanelTest, renamingAFileByItsMenuUpdatesAllReferences) {
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.click("Assets/menu/Rename...");
    hands.rest(2);
    EXPECT_EQ(valueOf("Rename/path"), "assets/hero.png");
    hands.key(Key::A, {.control = true});
    hands.type("assets/villain.png");
    hands.click("Rename/Rename");
    hands.rest(2);
    EXPECT_NE(fileText("assets/use.tileset.json").find("assets/villain.png"), std::string::npos);
    EXPECT_EQ(workspace.undo.size(), 1u);
}

TEST_F(AssetsPanelTest, afterTheMenuWasLeftTheKeysMeanTheFile) {
    workspace.document.selection.set({named("crate")});
    hands.clickAt(hands.middleOf("Viewport"), MouseButton::Right);
    hands.key(Key::Escape);
    workspace.document.selection.set({named("crate")});
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.key(Key::Escape);
    ASSERT_EQ(window.widgets().find("Assets/menu/Open"), nullptr);
    hands.key(Key::F2);
    hands.rest(2);
    EXPECT_EQ(valueOf("Rename/path"), "assets/hero.png");
    EXPECT_EQ(window.widgets().find("Scene/rename"), nullptr) << "not the entity too";
    hands.click("Rename/Cancel");
    hands.rest(2);
    hands.key(Key::Delete);
    hands.rest(2);
    hands.click("Delete/Keep");
    hands.rest(2);
    EXPECT_TRUE(named("crate")) << "what is selected in the scene is not meant";
    EXPECT_EQ(workspace.undo.size(), 0u);

    // With the focus in the scene tree, Delete applies to the selected entities.
    hands.clickAt(hands.middleOf("Scene/crate"), MouseButton::Right);
    hands.key(Key::Escape);
    hands.key(Key::Delete);
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Delete/Keep"), nullptr);
    EXPECT_FALSE(named("crate"));
}

TEST_F(AssetsPanelTest, deletingAsksForConfirmation) {
    hands.click("Assets/assets/hero.png");
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.click("Assets/menu/Delete...");
    hands.rest(2);
    hands.click("Delete/Keep");
    hands.rest(2);
    EXPECT_EQ(workspace.undo.size(), 0u);
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.click("Assets/menu/Delete...");
    hands.rest(2);
    hands.click("Delete/Delete");
    hands.rest(2);
    EXPECT_FALSE(std::filesystem::exists(workspace.project.root / "assets/hero.png"));
    workspace.undo.undo();
    EXPECT_TRUE(std::filesystem::exists(workspace.project.root / "assets/hero.png"));
}

TEST_F(AssetsPanelTest, aMapIsChosenImportedAndItsReportShown) {
    putFile("maps/cave.tmx",
            R"(<map orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
        <tileset firstgid="1" name="t" tilewidth="16" tileheight="16"><image source="gone.png" width="16" height="16"/></tileset>
        <layer name="a" width="1" height="1"><data encoding="csv">1</data></layer></map>)");
    workspace.importFrom = (workspace.project.root / "maps").generic_string();
    runAction(workspace, "file.import");
    hands.rest(2);
    hands.click("Import/cave.tmx");
    hands.rest(2);
    EXPECT_EQ(valueOf("Import/target"), "scenes/cave.scene.json");
    hands.click("Import/Import");
    hands.rest(2);
    EXPECT_NE(valueOf("Import/summary").find("1 layer, 1 tile"), std::string::npos);
    hands.click("Import/Copy");
    EXPECT_NE(workspace.clipboard.find("gone.png"), std::string::npos)
        << "the missing picture is in the report";
    hands.click("Import/Open");
    hands.rest(2);
    EXPECT_EQ(workspace.document.scenePath, "scenes/cave.scene.json");
}

TEST_F(AssetsPanelTest, aFileDroppedOntoTheWindowIsOfferedForImport) {
    putFile("maps/cave.tmx", "<map/>");
    window.frame({std::vector<Event>{{.kind = EventKind::FileDropped,
                                      .text = (workspace.project.root / "maps/cave.tmx").generic_string()}}});
    hands.rest(2);
    EXPECT_EQ(valueOf("Import/target"), "scenes/cave.scene.json");
}

TEST_F(AssetsPanelTest, aDoubleClickOnAnImageShowsItAndWritesNoFile) {
    doubleClick("Assets/assets/hero.png");
    hands.rest(3);
    EXPECT_EQ(valueOf("Image/picture"), "assets/hero.png");
    EXPECT_FALSE(std::filesystem::exists(workspace.project.root / "assets/hero.anim.json"));
    EXPECT_EQ(workspace.undo.size(), 0u);
    hands.key(Key::Escape);
    hands.rest(2);
    EXPECT_EQ(window.widgets().find("Image/picture"), nullptr);
    hands.rest(30);  // so that the next click is not counted as a third click
    doubleClick("Assets/assets/hero.png");
    hands.rest(3);
    hands.click("Image/animation");
    hands.rest(3);
    EXPECT_EQ(valueOf("Animation/file"), "assets/hero.anim.json") << "only when it is asked for";
    EXPECT_TRUE(std::filesystem::exists(workspace.project.root / "assets/hero.anim.json"));
}

TEST_F(AssetsPanelTest, aPictureIsCutIntoCellsAndClipsAndUndone) {
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.rest(2);
    hands.click("Assets/menu/Make animation");
    hands.rest(3);
    EXPECT_EQ(valueOf("Animation/file"), "assets/hero.anim.json");
    EXPECT_EQ(valueOf("Animation/cells"), "8 x 8") << "found by what is drawn";
    hands.click("Animation/all");
    hands.rest(2);
    const AnimationId id = workspace.assets.loadAnimation("assets/hero.anim.json");
    ASSERT_EQ(workspace.assets.animation(id).clips.size(), 1u);
    EXPECT_EQ(workspace.assets.animation(id).clips[0].frames.size(), 5u) << "without the empty cell";
    hands.clickAt(hands.middleOf("Animation/sheet"));
    hands.rest(2);
    EXPECT_EQ(workspace.assets.animation(id).clips[0].frames.size(), 6u);
    hands.clickAt(hands.middleOf("Animation/frame/0"), MouseButton::Right);
    hands.rest(2);
    EXPECT_EQ(workspace.assets.animation(id).clips[0].frames.size(), 5u);
    EXPECT_EQ(workspace.assets.animation(id).clips[0].frames[0].cellX, 1);
    workspace.undo.jumpTo(0);
    EXPECT_FALSE(std::filesystem::exists(workspace.project.root / "assets/hero.anim.json"));
    workspace.undo.jumpTo(workspace.undo.total());
    EXPECT_EQ(workspace.assets.animation(id).clips[0].frames.size(), 5u);
}

TEST_F(AssetsPanelTest, statesAreAddedAndJoinedInTheGraph) {
    AnimationEdit edit{workspace};
    ASSERT_EQ(edit.open("assets/hero.png"), "");
    edit.addClipOfAll();
    edit.addClip();
    workspace.assetToEdit = "assets/hero.anim.json";
    show("Animation");
    hands.click("Animation/states");
    hands.rest(2);
    hands.click("Animation/clip/all");
    hands.click("Animation/addState");
    hands.rest(2);
    hands.click("Animation/clip/clip");
    hands.click("Animation/addState");
    hands.rest(2);
    ASSERT_EQ(edit.set().states.size(), 2u);
    hands.drag(hands.middleOf("Animation/state/all"), hands.middleOf("Animation/state/clip"));
    hands.rest(2);
    ASSERT_EQ(edit.set().transitions.size(), 1u);
    EXPECT_EQ(edit.set().transitions[0].to, 1);
    edit.removeClip(0);
    EXPECT_EQ(edit.set().states.size(), 1u) << "what played it goes with it";
    EXPECT_TRUE(edit.set().transitions.empty());
    EXPECT_EQ(edit.set().states[0].clip, 0);
}

TEST(SheetSlicerTest, shapesAndCellsAreFoundByOpaquePixels) {
    const Image image = sheet();
    const std::vector<Rect> shapes = shapesIn(image);
    ASSERT_EQ(shapes.size(), 5u);
    EXPECT_EQ(shapes[1], (Rect{10.0f, 2.0f, 5.0f, 5.0f}));
    EXPECT_EQ(guessCells(image), (CellSize{8, 8}));
    EXPECT_FALSE(hasContent(image, {8.0f, 16.0f, 8.0f, 8.0f}));
    EXPECT_EQ(guessCells(Image{}), CellSize{});
}

TEST(AnimationEditTest, theShownFrameFollowsDurationsAndTheLoopMode) {
    Animation clip;
    clip.frames = {{0, 0, 0.1f, ""}, {1, 0, 0.3f, ""}};
    EXPECT_EQ(frameAt(clip, 0.05), 0);
    EXPECT_EQ(frameAt(clip, 0.25), 1);
    EXPECT_EQ(frameAt(clip, 0.45), 0);
    clip.loop = LoopMode::Once;
    EXPECT_EQ(frameAt(clip, 9.0), 1);
    clip.loop = LoopMode::PingPong;
    EXPECT_EQ(frameAt(clip, 0.45), 1);
    EXPECT_EQ(frameAt(clip, 0.75), 0);
    EXPECT_EQ(frameAt(Animation{}, 1.0), 0);
}

TEST_F(AssetsPanelTest, anImageBecomesATilesetWithTilesOfTheGridSize) {
    workspace.grid.size = {8.0f, 8.0f};
    const Result<std::string> made = makeTileset(workspace, "assets/hero.png");
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(*made, "assets/hero.tileset.json");
    const Tileset& set = workspace.assets.tileset(workspace.assets.loadTileset(*made));
    EXPECT_EQ(set.image, "assets/hero.png");
    EXPECT_EQ(set.tileWidth, 8);
    EXPECT_EQ(set.columns, 2);
    EXPECT_EQ(set.count, 6);
    EXPECT_EQ(workspace.undo.size(), 1u);
    EXPECT_EQ(*makeTileset(workspace, "assets/hero.png"), *made) << "it is used as it is";
    EXPECT_EQ(workspace.undo.size(), 1u);
    workspace.undo.undo();
    EXPECT_FALSE(std::filesystem::exists(workspace.project.root / *made));
    workspace.grid.size = {64.0f, 64.0f};
    EXPECT_FALSE(makeTileset(workspace, "assets/hero.png").ok()) << "no such tile fits";
    EXPECT_FALSE(makeTileset(workspace, "assets/use.tileset.json").ok());
}

TEST_F(AssetsPanelTest, theMenuOfAnImageCreatesATilesetWhoseTileSizeCanBeChanged) {
    workspace.grid.size = {8.0f, 8.0f};
    hands.clickAt(hands.middleOf("Assets/assets/hero.png"), MouseButton::Right);
    hands.rest(2);
    hands.click("Assets/menu/Make tileset");
    hands.rest(2);
    ASSERT_TRUE(std::filesystem::exists(workspace.project.root / "assets/hero.tileset.json"));
    ASSERT_TRUE(placeAsset(workspace, "assets/hero.tileset.json", {}).ok());
    show("Tileset");
    EXPECT_EQ(valueOf("Tileset/size"), "8 x 8");
    hands.click("Tileset/size");
    hands.key(Key::A, {.control = true});
    hands.type("4");
    hands.key(Key::Enter);
    hands.rest(2);
    EXPECT_EQ(valueOf("Tileset/size"), "8 x 4") << "the field in the middle is the height";
    const auto id = workspace.assets.loadTileset("assets/hero.tileset.json");
    EXPECT_EQ(workspace.assets.tileset(id).count, 12);
}

}  // namespace
}  // namespace plumb::editor::ui
