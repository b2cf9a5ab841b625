#include "editor/ui/panels/tile_layer_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/model/actions.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_layer_edit.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"
#include "scene/components/drawing/tile_layer.hpp"
#include "scene/components/transform.hpp"

namespace plumb::editor::ui {
namespace {

/// Draws a small icon button. @return true if it was clicked
bool iconButton(Ui& ui, Icon icon, bool strong, const std::string& path, const std::string& words) {
    const float side = ImGui::GetFrameHeight() * 0.85f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton(path.c_str(), {side, ImGui::GetFrameHeight()});
    ui.widgets.mark(path, strong ? "on" : "off");
    const ImU32 color = ImGui::IsItemHovered() ? palette::kText
                        : strong               ? palette::kAccent
                                               : palette::kTextDim;
    drawIcon(*ImGui::GetWindowDrawList(), icon, {at.x + side * 0.5f, at.y + ImGui::GetFrameHeight() * 0.5f},
             side * 0.72f, color);
    tooltip(words);
    return clicked;
}

void drawRow(Ui& ui, ObjectId layer, bool active) {
    Workspace& workspace = ui.workspace;
    EntityView& view = workspace.document.view;
    const std::string name = workspace.document.nameOf(layer);
    const std::string path = "Tiles/layers/" + name;
    ImGui::PushID(static_cast<int>(layer.value ^ (layer.value >> 32)));
    const auto keyed = [&](std::string_view words, std::string_view action) {
        return workspace.settings.keys.labelOf(*findAction(action), words);
    };
    const float height = ImGui::GetFrameHeight();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 to{from.x + ImGui::GetContentRegionAvail().x, from.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (active) {
        list.AddRectFilled(from, to, palette::kAccentSoft, ui.px(3.0f));
    } else if (ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(from, to)) {
        list.AddRectFilled(from, to, palette::kHover, ui.px(3.0f));
    }
    const bool hidden = view.isHidden(layer);
    const bool unseen = view.hides(layer);  // also while another layer is shown alone
    if (iconButton(ui, hidden ? Icon::EyeClosed : Icon::Eye, !unseen, path + "/seen",
                   keyed("Hides or shows this layer", "layer.hide")))
        view.toggleHidden(layer);
    ImGui::SameLine(0.0f, 0.0f);
    if (iconButton(ui, Icon::Solo, view.solo() == layer, path + "/solo",
                   keyed("Shows this layer alone", "layer.solo")))
        view.toggleSolo(layer);
    ImGui::SameLine(0.0f, 0.0f);
    const bool locked = view.locks(layer);
    if (iconButton(ui, locked ? Icon::Lock : Icon::Unlocked, locked, path + "/lock",
                   keyed("Locked layers cannot be painted on", "layer.lock")))
        view.toggleLocked(layer);
    ImGui::SameLine(0.0f, ui.px(4.0f));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("name", {std::max(to.x - at.x, 1.0f), height})) {
        workspace.tiles.layer = layer;
        workspace.document.selection.set({layer});
    }
    ui.widgets.mark(path, active ? "in hand" : "");
    list.PushClipRect(at, to, true);
    list.AddText({at.x, std::floor(at.y + (height - ImGui::GetTextLineHeight()) * 0.5f)},
                 unseen ? palette::kTextDim : palette::kText, name.c_str());
    list.PopClipRect();
    ImGui::PopID();
}

void orderButton(Ui& ui, const char* label, std::string_view action) {
    if (ImGui::SmallButton(label)) runAction(ui.workspace, action);
    ui.widgets.mark(std::string{"Tiles/"} + std::string{action});
    const Action& row = *findAction(action);
    tooltip(ui.workspace.settings.keys.labelOf(row));
}

/// Draws two numbers beside each other. @return true if they were changed
bool editPair(Ui& ui, const char* label, Vec2& value, float speed, const char* shown,
              const std::string& path) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", label);
    ImGui::SameLine(ui.px(62.0f));
    ImGui::SetNextItemWidth(-1.0f);
    std::array<float, 2> numbers{value.x, value.y};
    const bool changed =
        ImGui::DragFloat2(format("##{}", label).c_str(), numbers.data(), speed, 0.0f, 0.0f, shown);
    ui.widgets.mark(path, format("{} {}", value.x, value.y));
    if (ImGui::IsItemDeactivated()) ui.workspace.undo.endGesture();
    if (changed) value = {numbers[0], numbers[1]};
    return changed;
}

void drawSolid(Ui& ui, ObjectId layer) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Solid");
    ImGui::SameLine(ui.px(62.0f));
    bool solid = isSolidLayer(ui.workspace, layer);
    if (ImGui::Checkbox("##solid", &solid)) setLayerSolid(ui.workspace, layer, solid);
    ui.widgets.mark("Tiles/layer/solid", solid ? "on" : "off");
    tooltip("Adds a TileCollider: bodies collide with the tiles that have a collision shape (K shows them).");
}

void drawLook(Ui& ui, ObjectId layer) {
    Workspace& workspace = ui.workspace;
    const World& world = workspace.document.world;
    const TileLayer& tiles = world.get<TileLayer>(workspace.document.find(layer));
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("Opacity");
    ImGui::SameLine(ui.px(62.0f));
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight() - ui.px(4.0f));
    float opacity = static_cast<float>(tiles.tint.a) / 2.55f;
    if (ImGui::SliderFloat("##opacity", &opacity, 0.0f, 100.0f, "%.0f %%", ImGuiSliderFlags_AlwaysClamp))
        setLayerOpacity(workspace, layer, opacity / 100.0f);
    ui.widgets.mark("Tiles/layer/opacity", format("{}", static_cast<int>(opacity + 0.5f)));
    if (ImGui::IsItemDeactivated()) workspace.undo.endGesture();
    ImGui::SameLine(0.0f, ui.px(4.0f));
    const auto part = [](std::uint8_t value) { return static_cast<float>(value) / 255.0f; };
    std::array<float, 3> tint{part(tiles.tint.r), part(tiles.tint.g), part(tiles.tint.b)};
    if (ImGui::ColorEdit3("##tint", tint.data(), ImGuiColorEditFlags_NoInputs)) {
        const auto byte = [](float value) { return static_cast<std::uint8_t>(value * 255.0f + 0.5f); };
        setLayerTint(workspace, layer, {byte(tint[0]), byte(tint[1]), byte(tint[2]), tiles.tint.a});
    }
    ui.widgets.mark("Tiles/layer/tint");
    tooltip("Tint: multiplies the colors of the tiles.");
    if (ImGui::IsItemDeactivated()) workspace.undo.endGesture();

    drawSolid(ui, layer);
    Vec2 parallax = layerParallax(workspace, layer);
    if (editPair(ui, "Parallax", parallax, 0.01f, "%.2f", "Tiles/layer/parallax"))
        setLayerParallax(workspace, layer, parallax);
    tooltip(
        "Scroll speed relative to the camera, horizontal and vertical: 1 moves with the world, 0 is fixed "
        "to the screen.");
    if (const auto* place = world.find<Transform>(workspace.document.find(layer))) {
        Vec2 offset = place->position;
        if (editPair(ui, "Offset", offset, 1.0f, "%.0f", "Tiles/layer/offset"))
            setLayerOffset(workspace, layer, offset);
        tooltip("Position of the layer's upper left corner, px.");
    }
}

}  // namespace

void drawTileLayerList(Ui& ui) {
    Workspace& workspace = ui.workspace;
    const ObjectId active = activeTileLayer(workspace.document, workspace.tiles);
    ImGui::TextDisabled("Layers");
    float width = ui.px(6.0f);
    for (const char* label : {" + ", "up", "down"})
        width += ImGui::CalcTextSize(label).x + ImGui::GetStyle().FramePadding.x * 2.0f;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    orderButton(ui, " + ", "layer.add");
    ImGui::SameLine(0.0f, ui.px(3.0f));
    orderButton(ui, "up", "layer.raise");
    ImGui::SameLine(0.0f, ui.px(3.0f));
    orderButton(ui, "down", "layer.lower");
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4.0f), ui.px(1.0f)});
    for (const ObjectId layer : tileLayers(workspace.document)) drawRow(ui, layer, layer == active);
    ImGui::PopStyleVar();
    ImGui::Spacing();
    drawLook(ui, active);
}

}  // namespace plumb::editor::ui
