#include "editor/ui/dialogs/image_dialog.hpp"

#include <utility>

#include <imgui.h>

#include "core/text.hpp"
#include "editor/model/assets/make_tileset.hpp"
#include "editor/ui/widgets/asset_picture.hpp"
#include "editor/ui/widgets/dialog.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kTitle = "Image";

/// Draws the image over the room above the buttons.
void drawWhole(Ui& ui, const std::string& path) {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::Dummy({room.x, room.y - ui.px(40.0f)});
    ui.widgets.mark("Image/picture", path);
    const ImVec2 to = ImGui::GetItemRectMax();
    drawImage(ui, *ImGui::GetWindowDrawList(), path, {{from.x, from.y}, {to.x, to.y}});
}

}  // namespace

void makeTilesetOf(Ui& ui, AssetBrowser& browser, const std::string& image) {
    const Result<std::string> made = makeTileset(ui.workspace, image);
    if (made) browser.selected = *made;
    ui.workspace.notice =
        made ? format("{} created: drag it into the scene, or select it as the tileset of a layer", *made)
             : made.error().text();
}

void ImageDialog::draw(Ui& ui, AssetBrowser& browser) {
    if (!wanted_.empty()) {
        path_ = std::exchange(wanted_, {});
        ImGui::OpenPopup(kTitle);
    }
    if (!beginDialog(ui, kTitle, {720.0f, 540.0f})) return;
    const AssetItem item{.path = path_, .kind = AssetKind::Texture};
    ImGui::Text("%s, %s", path_.c_str(), browser.describe(item).c_str());
    drawWhole(ui, path_);
    dialogFoot(ui);
    ImGui::BeginDisabled(!ui.workspace.canEdit());
    const bool animation = footButton(ui, "Make animation", 130.0f, "Image/animation");
    tooltip("Opens the animation of this sheet; the file is created if it does not exist");
    ImGui::SameLine();
    const bool tileset = footButton(ui, "Make tileset", 130.0f, "Image/tileset");
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool close = defaultButton(ui, "Close", 110.0f, "Image/close");
    if (animation) ui.workspace.assetToEdit = path_;
    if (tileset) makeTilesetOf(ui, browser, path_);
    if (animation || tileset || close) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace plumb::editor::ui
