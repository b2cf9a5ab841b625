#include "editor/ui/widgets/scene_drop.hpp"

#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "editor/model/tools/transform_drag.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/asset_picture.hpp"

namespace plumb::editor::ui {

void dropIntoScene(Ui& ui, Vec2 corner) {
    const AABB scene{{ImGui::GetItemRectMin().x, ImGui::GetItemRectMin().y},
                     {ImGui::GetItemRectMax().x, ImGui::GetItemRectMax().y}};
    std::string hovering;
    const std::string dropped = acceptAsset(hovering);
    if (hovering.empty()) return;
    Workspace& workspace = ui.workspace;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const PlacedPicture picture = placedPicture(workspace, dropped.empty() ? hovering : dropped);
    Vec2 at = workspace.view.toWorldPoint(Vec2{mouse.x, mouse.y} - corner);
    if (workspace.grid.snap != ImGui::GetIO().KeyCtrl)
        at = placedOnGrid(at, picture, workspace.grid.step());
    if (dropped.empty()) {
        const AssetKind kind = assetKindOf(hovering);
        const Vec2 size = picture.size * workspace.view.zoom();
        const Vec2 origin = corner + workspace.view.toScreenPoint(at);
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        list.PushClipRect({scene.min.x, scene.min.y}, {scene.max.x, scene.max.y});
        const Vec2 least = origin - scaled(size, picture.pivot);
        const AABB box{least, least + size};
        if (size.x > 0.0f && canBePlaced(kind)) {
            drawAsset(ui, list, kind, hovering, box, 0.0);
            outline(list, {box.min.x, box.min.y}, {box.max.x, box.max.y}, palette::kAccent);
        } else {
            list.AddCircle({origin.x, origin.y}, ui.px(6.0f),
                           canBePlaced(kind) ? palette::kAccent : palette::kError);
        }
        list.PopClipRect();
        return;
    }
    const Result<Done> placed = placeAsset(workspace, dropped, at);
    workspace.notice = placed ? format("Added {}", dropped) : placed.error().text();
}

}  // namespace plumb::editor::ui
