#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "assets/asset_store.hpp"
#include "core/clock.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/document/bounds.hpp"
#include "editor/model/document/root_place.hpp"
#include "editor/model/document/scene_boxes.hpp"
#include "editor/model/document/visibility.hpp"
#include "editor/model/prefabs/go_inside.hpp"
#include "editor/model/problems.hpp"
#include "editor/model/tools/motion_paths.hpp"
#include "editor/ui/overlays/overlay_edge.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/missing_camera.hpp"
#include "editor/ui/widgets/particle_bar.hpp"
#include "editor/ui/widgets/scene_drop.hpp"
#include "editor/ui/widgets/tile_picture.hpp"
#include "editor/ui/widgets/timeline.hpp"
#include "gameplay/components/controls/mouse_drag.hpp"
#include "render/view.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/physics/soft_sync.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kTitleRoom = 96.0f;       // px at scale 1
constexpr float kReach = 3.0f;            // px on screen, picking radius of the mouse
constexpr ImU32 kLeastEdge = 8;           // minimum alpha of a visible halo
constexpr std::size_t kMostBoxes = 2000;  // maximum number of selection boxes drawn
constexpr std::size_t kMostAlone = 500;   // maximum number of selection boxes recomputed in each frame
constexpr Color kSelected{77, 163, 255, 255};
constexpr Color kCollider{120, 230, 160, 120};
constexpr Color kHovered{255, 255, 255, 110};

ImU32 toImgui(Color color) { return IM_COL32(color.r, color.g, color.b, color.a); }

/// Shows the scene; handles camera movement, selection and the tools.
class ViewportPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ImVec2 size = ImGui::GetContentRegionAvail();
        const float timeline = ui.workspace.play.running() ? timelineHeight(ui) : 0.0f;
        size.y -= timeline;
        if (size.x < 8.0f || size.y < 8.0f) return;
        if (timeline > 0.0f) drawTimeline(ui, {from.x, from.y + size.y}, {size.x, timeline});
        ImGui::SetCursorScreenPos(from);
        place(ui, from, size);
        ImGui::InvisibleButton("scene", size,
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                                   ImGuiButtonFlags_MouseButtonRight);
        ui.widgets.mark("Viewport");
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
            ImGui::SetWindowFocus();  // focus, so that keys act on the scene
        from_ = {from.x, from.y};
        dropIntoScene(ui, from_);
        offerMenu(ui);
        followGame(ui);
        lookAround(ui);
        useTool(ui);
        advancePreview(ui, particles_);
        drawScene(ui, from, size);
        drawParticleBar(ui, particles_, from, size);
    }

private:
    static void place(Ui& ui, ImVec2, ImVec2 size) {
        ViewCamera& view = ui.workspace.view;
        view.resize({size.x, size.y});
        if (!ui.viewReady) ui.workspace.showStart();
        ui.viewReady = true;
    }

    /// Shows a running game through its own camera at the largest
    /// whole-number zoom; restores the editor's view when the game stops.
    void followGame(Ui& ui) {
        Workspace& workspace = ui.workspace;
        const bool running = workspace.play.running();
        if (running != playing_) {
            playing_ = running;
            workspace.followsGame = true;
            if (!running) {
                workspace.view.show(before_.center, before_.zoom);
                return;
            }
            before_ = workspace.view.view();
        }
        if (!running || !workspace.followsGame) return;
        const Vec2 picture = workspace.project.picture;
        const View game = cameraView(workspace.play.world(), picture, ui.playAlpha);
        workspace.view.show(game.center, workspace.view.zoomFor(picture) * game.zoom);
    }

    /// Opens the context menu of the entity under the mouse.
    /// While painting tiles the right button picks tiles instead.
    void offerMenu(Ui& ui) const {
        Workspace& workspace = ui.workspace;
        if (!workspace.canEdit() || workspace.paintsTiles() || workspace.document.scenePath.empty()) return;
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            const ObjectId under = pickFirst(workspace.document, pointer_.position, pointer_.reach);
            if (under && !workspace.document.selection.has(under)) workspace.document.selection.set({under});
        }
        if (!ImGui::BeginPopupContextItem("scene menu")) return;
        selectionMenu(ui, "Viewport/menu");
        ImGui::EndPopup();
    }

    void lookAround(Ui& ui) {
        ViewCamera& view = ui.workspace.view;
        const ImGuiIO& io = ImGui::GetIO();
        const Vec2 mouse = Vec2{io.MousePos.x, io.MousePos.y} - from_;
        ui.mouseOverScene = ImGui::IsItemHovered();
        if (ui.mouseOverScene && io.MouseWheel != 0.0f) {
            view.zoomAt(mouse, io.MouseWheel);
            ui.workspace.followsGame = false;
        }
        panning_ = ImGui::IsItemActive() && (ImGui::IsMouseDown(2) || (ui.panHeld && ImGui::IsMouseDown(0)));
        if (panning_) {
            view.pan({io.MouseDelta.x, io.MouseDelta.y});
            ui.workspace.followsGame = false;
        }
        if (panning_ || (ui.panHeld && ui.mouseOverScene)) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
        ui.mouseInScene = view.toWorldPoint(mouse);
    }

    void useTool(Ui& ui) {
        Workspace& workspace = ui.workspace;
        const ImGuiIO& io = ImGui::GetIO();
        pointer_.position = ui.mouseInScene;
        pointer_.modifiers = {io.KeyShift, io.KeyCtrl, io.KeyAlt};
        pointer_.snap = workspace.grid.snap != io.KeyCtrl;
        pointer_.grid = workspace.grid.step();
        pointer_.angle = workspace.grid.snapAngles ? workspace.grid.angle : 0.0f;
        // Handles have a constant size on screen, scaled like the rest of the interface.
        pointer_.reach = ui.px(kReach) / workspace.view.zoom();
        pointer_.pixel = ui.scale / workspace.view.zoom();
        if (!workspace.canEdit() || workspace.document.scenePath.empty()) {
            if (ImGui::IsItemActivated() && workspace.play.running()) inspectRunning(workspace);
            return;
        }
        const ToolContext context = workspace.tools();
        const bool right = io.MouseClicked[1] && workspace.paintsTiles();
        if (ImGui::IsItemActivated() && (io.MouseClicked[0] || right) && !ui.panHeld) {
            pointer_.secondary = right;
            workspace.tool().press(context, pointer_);
            if (const auto why = whyNotPainted(workspace, pointer_.position); !why.empty())
                workspace.notice = why;
            pressed_ = true;
            const std::string_view tool = toolTable()[workspace.toolIndex()].action;
            const bool scales = tool == "tool.scale" || workspace.paintsTiles();
            onRoot_ = !scales && pointer_.modifiers == Modifiers{} && onlyRootSelected(workspace.document);
            twice_ = io.MouseDoubleClicked[0] && pointer_.modifiers == Modifiers{};
            moved_ = pointer_.position;
        } else if (pressed_ && !io.MouseDown[pointer_.secondary ? 1 : 0]) {
            workspace.tool().release(context, pointer_);
            pressed_ = pointer_.secondary = false;
            if (const std::string_view next = workspace.tool().next(); !next.empty()) workspace.useTool(next);
            if (std::exchange(twice_, false) && !workspace.paintsTiles())
                handleDoubleClick(workspace, pointer_.position, pointer_.reach);
        } else if (pressed_ && pointer_.position != moved_) {
            const std::size_t steps = workspace.undo.size();
            workspace.tool().drag(context, pointer_);
            const bool changed = workspace.undo.size() != steps || workspace.undo.inGesture();
            if (onRoot_ && !changed) workspace.notice = kRootCannotMove;
            moved_ = pointer_.position;
            twice_ = false;
        }
    }

    /// Selects the smallest entity of the running game under the mouse, at its present position.
    void inspectRunning(Workspace& workspace) const {
        ObjectId hit;
        float smallest = 1e30f;
        for (const ObjectId id : workspace.document.objects()) {
            const EntityId entity = workspace.play.find(id);
            const World& played = workspace.play.world();
            // An entity that follows the mouse is always under it.
            if (!hasTransform(played, entity) || played.has<MouseDrag>(entity)) continue;
            const AABB box = boundsOf(played, entity);
            const float area = box.size().x * box.size().y;
            if (contains(box, pointer_.position) && area < smallest) smallest = area, hit = id;
        }
        if (hit) workspace.document.selection.set({hit});
    }

    void drawScene(Ui& ui, ImVec2 from, ImVec2 size) {
        Workspace& workspace = ui.workspace;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{from.x + size.x, from.y + size.y};
        list.PushClipRect(from, to, true);
        if (workspace.document.scenePath.empty()) {
            list.PopClipRect();
            drawHint(ui, from, size);
            return;
        }
        World& world = workspace.shownWorld();
        previewBodies(workspace);
        if (ui.picture != nullptr) drawPicture(ui, list, world, from, size);
        overlay_.clear();
        for (const OverlayRow& row : overlayTable()) {
            if (workspace.shows(row.name)) row.draw(workspace, world, overlay_);
        }
        drawEmitterShapes(world, particles_, overlay_);
        drawSelection(ui, world);
        if (workspace.canEdit()) workspace.tool().draw(workspace.tools(), pointer_, overlay_);
        const AABB picture = pictureOf(workspace, {from.x, from.y}, {size.x, size.y});
        list.PushClipRect({picture.min.x, picture.min.y}, {picture.max.x, picture.max.y}, true);
        for (const Overlay::Shape& shape : overlay_.shapes()) {
            drawShape(ui, list, shape);
        }
        list.PopClipRect();
        if (workspace.play.running()) drawPlayFrame(ui, list, from, to);
        if (workspace.play.running()) drawMissingCameraWarning(ui, world, picture);
        list.PopClipRect();
    }

    /// Creates physics bodies for drawing after a change of the scene, if a physics layer or a soft body
    /// needs them: the world of the document is never stepped, so it has none of its own.
    void previewBodies(Workspace& workspace) {
        if (workspace.play.running()) return;
        if (workspace.physics.shown().any() == 0 && !hasSoftBodies(workspace.document.world)) return;
        if (std::exchange(previewed_, workspace.document.sceneRevision) != workspace.document.sceneRevision)
            previewPhysics(workspace.document.world);
    }

    /// True if a running game is shown through its own camera, as in the player.
    static bool shownAsGame(const Workspace& workspace) {
        return workspace.play.running() && workspace.followsGame;
    }

    /// Rectangle of the scene image, px on screen: the whole panel, or for a game viewed through its camera a
    /// centered rectangle of the game's resolution.
    static AABB pictureOf(const Workspace& workspace, Vec2 from, Vec2 size) {
        if (!shownAsGame(workspace)) return {from, from + size};
        const Vec2 picture = workspace.project.picture;
        const Vec2 room = min(workspace.view.view().size, picture * workspace.view.zoomFor(picture));
        const Vec2 corner =
            from + Vec2{std::floor((size.x - room.x) * 0.5f), std::floor((size.y - room.y) * 0.5f)};
        return {corner, corner + room};
    }

    void drawPicture(const Ui& ui, ImDrawList& list, World& world, ImVec2 from, ImVec2 size) {
        Workspace& workspace = ui.workspace;
        const AABB box = pictureOf(workspace, {from.x, from.y}, {size.x, size.y});
        View view = workspace.view.view();
        const bool asGame = shownAsGame(workspace);
        if (asGame) {
            list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, palette::kCanvas);
            view.size = box.size();
            from = {box.min.x, box.min.y};
        }
        const PixelSize pixels{static_cast<int>(view.size.x), static_cast<int>(view.size.y)};
        ui.picture->preview = previewOf(workspace);
        const double start = workspace.profiler.measures() ? threadSeconds() : 0.0;
        const std::uintptr_t texture = ui.picture->draw(world, workspace.play.assets(), view, pixels,
                                                        ui.playAlpha, asGame, shownPhysics(workspace));
        if (workspace.profiler.measures())
            workspace.profiler.drew(threadSeconds() - start, ui.picture->counts.drawCalls,
                                    ui.picture->counts.sprites);
        imageOfPixels(
            list, textureId(texture), from,
            {from.x + static_cast<float>(pixels.width), from.y + static_cast<float>(pixels.height)});
    }

    /// Returns the preview settings while no game runs: time of animated tiles, hidden entities, particles.
    SceneTexture::Preview previewOf(const Workspace& workspace) {
        SceneTexture::Preview preview;
        if (workspace.play.running()) return preview;
        preview.ahead = ImGui::GetTime();
        const Revisions now{workspace.document.view.revision(), workspace.document.treeRevision};
        if (std::exchange(hiddenAt_, now) != now) hidden_ = hiddenEntities(workspace.document);
        preview.hidden = hidden_;
        if (particles_.shows()) preview.particles = &particles_.particles();
        preview.particleBack = particles_.back();
        return preview;
    }

    PhysicsShown shownPhysics(Workspace& workspace) {
        PhysicsShown shown = workspace.physics.shown();
        selected_.clear();
        if (shown.ofSelected != 0) {
            for (const ObjectId id : workspace.document.selection.all())
                selected_.push_back(workspace.shownEntity(id));
        }
        shown.selected = selected_;
        shown.times = &workspace.physicsTimes;
        if (workspace.play.running())
            workspace.physicsTimes.watch(workspace.play.world(), (shown.any() & kPhysicsTimes) != 0);
        return shown;
    }

    /// Draws a colored frame around a running game: edits then change the game, not the scene.
    static void drawPlayFrame(const Ui& ui, ImDrawList& list, ImVec2 from, ImVec2 to) {
        const bool paused = ui.workspace.play.paused();
        const ImU32 color = paused ? palette::kWarning : palette::kPlay;
        const float width = ui.px(4.0f);
        outline(list, {from.x + width * 0.5f, from.y + width * 0.5f},
                {to.x - width * 0.5f, to.y - width * 0.5f}, color, 0.0f, width);
        const auto keys = [&](const char* action) {
            return ui.workspace.settings.keys.shownOf(*findAction(action)).text();
        };
        const std::string words =
            ui.workspace.debugger.halt() != nullptr
                ? format("AT A SCRIPT LINE - {} and {} step, {} goes on", keys("script.over"),
                         keys("script.back"), keys("run.pause"))
            : ui.workspace.play.inPast() ? format("REWOUND - {} and {} step, {} resumes from here",
                                                  keys("run.step"), keys("run.stepBack"), keys("run.pause"))
            : paused ? format("PAUSED - {} steps, {} resumes, {} stops", keys("run.step"), keys("run.pause"),
                              keys("run.play"))
                     : format("PLAYING - {} stops and asks which of your changes to keep", keys("run.play"));
        const ImVec2 extent = ImGui::CalcTextSize(words.c_str());
        // The text is in the title bar of the panel, as it would cover the game's image elsewhere.
        const float middle = from.x + (to.x - from.x - extent.x) * 0.5f;
        const ImVec2 at{std::floor(std::max(middle, from.x + ui.px(kTitleRoom))),
                        from.y - extent.y - ui.px(4.0f)};
        const ImVec2 margin{ui.px(10.0f), ui.px(4.0f)};
        list.PushClipRect({from.x, at.y - margin.y}, to);
        list.AddRectFilled({at.x - margin.x, at.y - margin.y}, {at.x + extent.x + margin.x, from.y}, color,
                           ui.px(5.0f), ImDrawFlags_RoundCornersTop);
        list.AddText(at, palette::kOnStatus, words.c_str());
        list.PopClipRect();
    }

    void drawSelection(Ui& ui, const World& world) {
        const Document& document = ui.workspace.document;
        if (ui.mouseOverScene && !pressed_ && ui.workspace.canEdit() && !ui.workspace.paintsTiles()) {
            const ObjectId under = pickFirst(document, pointer_.position, pointer_.reach);
            if (under && !document.selection.has(under))
                overlay_.box(boundsOf(world, document.find(under)), kHovered);
        }
        if (ui.workspace.canEdit() && document.selection.size() > kMostAlone)
            return drawManySelected(document, visibleBox(ui.workspace.view.view()));
        for (const ObjectId id : document.selection.all()) {
            const EntityId entity = ui.workspace.shownEntity(id);
            if (hasTransform(world, entity)) overlay_.box(boundsOf(world, entity), kSelected, 2.0f);
            if (const auto way = motionPathOf(world, entity); way && !ui.workspace.shows("ways"))
                drawSetWay(*way, pointer_.pixel, overlay_);
        }
        if (ui.workspace.canEdit()) drawColliders(document);
    }

    /// Draws the collider outline of a single selected entity, faint: the shape tool draws it strongly.
    void drawColliders(const Document& document) {
        if (document.selection.size() != 1) return;
        for (const ShapeEdge& edge : edgesOf(document, document.selection.all().front()))
            overlay_.line(edge.from, edge.to, kCollider, 1.0f);
    }

    /// Draws the boxes of a part of the visible selected
    /// entities, and a cached box around the whole selection.
    void drawManySelected(const Document& document, const AABB& seen) {
        const std::vector<ObjectId>& all = document.objects();
        const SceneBoxes& boxes = document.boxes();
        many_.clear();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (intersects(boxes.at(i), seen) && document.selection.has(all[i])) many_.push_back(i);
        }
        // If there are too many boxes, draws every n-th of the list, so that no region looks unselected.
        const std::size_t step = (many_.size() + kMostBoxes - 1) / kMostBoxes;
        for (std::size_t i = 0; i < many_.size(); i += step)
            overlay_.box(boxes.at(many_[i]), kSelected, step > 1 ? 1.0f : 2.0f);
        const Revisions now{document.selection.revision(), document.sceneRevision};
        if (std::exchange(wholeAt_, now) != now) {
            whole_.reset();
            for (const ObjectId id : document.selection.all()) {
                const AABB& box = boxes.of(document.find(id));
                if (isFinite(box.min)) whole_ = whole_ ? merged(*whole_, box) : box;
            }
        }
        if (whole_) overlay_.box(*whole_, kSelected, 2.0f);
    }

    [[nodiscard]] ImVec2 onScreen(const Ui& ui, Vec2 world) const {
        const Vec2 at = ui.workspace.view.toScreenPoint(world) + from_;
        return {at.x, at.y};
    }

    /// Thickness of a line, px on screen, scaled like the text beside it.
    static float thicknessOf(const Ui& ui, const Overlay::Shape& shape) {
        return std::max(shape.thickness * ui.scale, std::min(shape.thickness, 1.0f));
    }

    void drawShape(Ui& ui, ImDrawList& list, const Overlay::Shape& shape) const {
        const ImVec2 a = onScreen(ui, shape.from);
        const ImVec2 b = onScreen(ui, shape.to);
        const ImU32 color = toImgui(shape.color);
        const float thickness = thicknessOf(ui, shape);
        drawHalo(ui, list, shape, a, b);
        switch (shape.kind) {
            case Overlay::Kind::Line: list.AddLine(a, b, color, thickness); break;
            case Overlay::Kind::Arrow: drawArrow(ui, list, a, b, color, thickness); break;
            case Overlay::Kind::Box: outline(list, a, b, color, 0.0f, thickness); break;
            case Overlay::Kind::FilledBox: list.AddRectFilled(a, b, color); break;
            case Overlay::Kind::Circle:
                list.AddCircle(a, shape.radius * ui.workspace.view.zoom(), color, 0, thickness);
                break;
            case Overlay::Kind::Tile:
                if (const Tileset* tileset = ui.workspace.assets.find(shape.tileset))
                    drawTile(ui, list, *tileset, shape.cell, {{a.x, a.y}, {b.x, b.y}}, color);
                break;
            case Overlay::Kind::Text:
                for (const ImVec2 side :
                     {ImVec2{-1.0f, 0.0f}, ImVec2{1.0f, 0.0f}, ImVec2{0.0f, -1.0f}, ImVec2{0.0f, 1.0f}})
                    list.AddText({a.x + side.x, a.y + side.y - ui.fonts.size - 1.0f}, palette::kHaloText,
                                 shape.text.c_str());
                list.AddText({a.x, a.y - ui.fonts.size - 1.0f}, color, shape.text.c_str());
                break;
        }
    }

    static void drawHalo(const Ui& ui, ImDrawList& list, const Overlay::Shape& shape, ImVec2 a, ImVec2 b) {
        const float thickness = thicknessOf(ui, shape) + ui.px(2.0f);
        const ImU32 color = edgeOf(shape.color);
        if (color >> IM_COL32_A_SHIFT < kLeastEdge) return;
        switch (shape.kind) {
            case Overlay::Kind::Line:
            case Overlay::Kind::Arrow: list.AddLine(a, b, color, thickness); break;
            case Overlay::Kind::Box: outline(list, a, b, color, 0.0f, thickness); break;
            case Overlay::Kind::Circle:
                list.AddCircle(a, shape.radius * ui.workspace.view.zoom(), color, 0, thickness);
                break;
            case Overlay::Kind::FilledBox:
            case Overlay::Kind::Tile:
            case Overlay::Kind::Text: break;
        }
    }

    static void drawArrow(const Ui& ui, ImDrawList& list, ImVec2 a, ImVec2 b, ImU32 color, float thickness) {
        list.AddLine(a, b, color, thickness);
        const Vec2 along = normalized(Vec2{b.x - a.x, b.y - a.y});
        const Vec2 side = perpendicular(along);
        const Vec2 back = Vec2{b.x, b.y} - along * ui.px(9.0f);
        const Vec2 wing = side * ui.px(4.5f);
        list.AddTriangleFilled(b, {back.x + wing.x, back.y + wing.y}, {back.x - wing.x, back.y - wing.y},
                               color);
    }

    static void drawHint(Ui& ui, ImVec2 from, ImVec2 size) {
        const float width = std::min(ui.px(360.0f), size.x);
        ImGui::SetCursorScreenPos(
            {from.x + std::floor((size.x - width) * 0.5f), from.y + std::floor(size.y * 0.4f)});
        beginChild("hint", {width, ui.px(200.0f)}, false);
        const std::string& problem = problemsOf(ui.workspace).load;
        emptyState(ui, "Viewport", "No scene is open.",
                   problem.empty() ? "A scene is a level, a title screen or a menu." : problem.c_str(),
                   {"file.open", "file.new"});
        ImGui::EndChild();
    }

    Vec2 from_;
    Vec2 moved_;
    Pointer pointer_;
    View before_;                      ///< the editor's view before the game was started
    std::uint64_t previewed_ = ~0ull;  ///< document revision of the preview bodies
    std::vector<std::size_t> many_;    ///< indices of the visible selected entities among all objects
    bool panning_ = false;
    bool pressed_ = false;
    bool onRoot_ = false;  ///< true if the mouse was pressed on the root of a prefab, which cannot be moved
    bool twice_ = false;   ///< true during the second press of a double-click, until a drag
    bool playing_ = false;
    Overlay overlay_;
    std::vector<EntityId> selected_;
    ParticlePreview particles_;

    /// Two revision numbers that a cached value was computed from.
    struct Revisions {
        std::uint64_t first = ~0ull;
        std::uint64_t second = ~0ull;
        bool operator==(const Revisions&) const = default;
    };
    Revisions wholeAt_;             ///< revisions of selection and scene, for `whole_`
    std::optional<AABB> whole_;     ///< box around all selected entities, world px
    Revisions hiddenAt_;            ///< revisions of view and tree, for `hidden_`
    std::vector<EntityId> hidden_;  ///< entities not drawn while editing
};

}  // namespace

std::unique_ptr<Panel> makeViewportPanel() { return std::make_unique<ViewportPanel>(); }

}  // namespace plumb::editor::ui
