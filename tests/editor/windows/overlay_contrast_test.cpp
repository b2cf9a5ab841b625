// Overlay lines are visible on scenes of any colour, by their own colour or by their outline.

#include "editor/ui/overlays/overlay_edge.hpp"
#include "editor/ui/overlays/overlay_list.hpp"
#include "tests/editor/support/contrast.hpp"
#include "tests/editor/support/editor_fixture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr ImU32 kScenes[] = {IM_COL32(0, 0, 0, 255),       IM_COL32(20, 21, 25, 255),
                             IM_COL32(128, 128, 128, 255), IM_COL32(77, 163, 255, 255),
                             IM_COL32(235, 235, 225, 255), IM_COL32(255, 255, 255, 255)};

class OverlayContrast : public EditorFixture {
protected:
    static bool isLine(const Overlay::Shape& shape) {
        return shape.kind == Overlay::Kind::Line || shape.kind == Overlay::Kind::Arrow ||
               shape.kind == Overlay::Kind::Box || shape.kind == Overlay::Kind::Circle;
    }
    /// Returns the larger contrast of the line and of its outline to the scene's colour.
    static float seen(Color line, ImU32 scene) {
        const ImU32 core = over(IM_COL32(line.r, line.g, line.b, line.a), scene);
        return std::max(contrast(core, scene), contrast(over(edgeOf(line), scene), scene));
    }
    std::size_t expectSeen(const Overlay& overlay, std::string_view name) {
        std::size_t lines = 0;
        for (const Overlay::Shape& shape : overlay.shapes()) {
            if (!isLine(shape) || shape.color.a == 0) continue;
            // the colour of the grid is set by the user
            if (shape.color == workspace.grid.color || name == "grid") continue;
            if (shape.color.r + shape.color.g + shape.color.b == 0) continue;  // the shadow below a handle
            ++lines;
            for (const ImU32 scene : kScenes) {
                EXPECT_GE(seen(shape.color, scene),
                          static_cast<float>(shape.color.a) < kFaintLine ? 1.2f : 3.0f)
                    << name << ": " << int{shape.color.r} << " " << int{shape.color.g} << " "
                    << int{shape.color.b} << " " << int{shape.color.a} << " on " << (scene & 0xffffff);
            }
        }
        return lines;
    }
};

TEST_F(OverlayContrast, linesOfAllToolsAreVisibleOnDarkAndLightScenes) {
    std::size_t lines = 0;
    for (std::size_t i = 0; i < toolTable().size(); ++i) {
        workspace.document.selection.set({named("player")});
        workspace.useTool(i);
        for (const Vec2 at : {Vec2{40.0f, 100.0f}, Vec2{8.0f, 8.0f}, Vec2{500.0f, 500.0f}}) {
            Pointer pointer;
            pointer.position = at;
            Overlay overlay;
            workspace.tool().draw(workspace.tools(), pointer, overlay);
            lines += expectSeen(overlay, toolTable()[i].name);
        }
    }
    EXPECT_GT(lines, 40u);
}

TEST_F(OverlayContrast, linesOfAllOverlaysAreVisibleOnDarkAndLightScenes) {
    workspace.document.world.get<Camera>(workspace.document.find(named("camera"))).limits = {0, 0, 400, 300};
    std::size_t lines = 0;
    for (const OverlayRow& row : overlayTable()) {
        Overlay overlay;
        row.draw(workspace, workspace.document.world, overlay);
        lines += expectSeen(overlay, row.name);
    }
    EXPECT_GE(lines, 2u);
}

TEST_F(OverlayContrast, faintLinesHaveAFaintOutline) {
    EXPECT_EQ(edgeOf({255, 255, 255, 0}) >> IM_COL32_A_SHIFT, 0u);
    EXPECT_LT(edgeOf({255, 255, 255, 16}) >> IM_COL32_A_SHIFT & 0xff, 16u);
    EXPECT_GT(edgeOf({255, 255, 255, 255}) >> IM_COL32_A_SHIFT & 0xff, 180u);
}

}  // namespace
}  // namespace plumb::editor::ui
