#include <algorithm>
#include <array>

#include "editor/model/tiles/tileset_edit.hpp"
#include "editor/ui/panels/tileset_panel.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/tile_picture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::array<std::uint8_t, 9> kBits{128, 1, 2, 64, 0, 4, 32, 16, 8};
constexpr std::array<const char*, 3> kModeWords{"Edges (16)", "Blob (47)", "Corners (16)"};

Terrain* terrainIn(Tileset& tileset, int id) {
    const auto found = std::find_if(tileset.terrains.begin(), tileset.terrains.end(),
                                    [&](const Terrain& terrain) { return terrain.id == id; });
    return found == tileset.terrains.end() ? nullptr : &*found;
}

template <class Change>
void changeTerrain(Ui& ui, const char* label, int id, Change change) {
    changeTileset(ui.workspace, label, [&](Tileset& set) {
        if (Terrain* terrain = terrainIn(set, id)) change(*terrain, set);
    });
    ui.workspace.undo.endGesture();
}

void drawList(Ui& ui, const Tileset& tileset, int& chosen) {
    for (const Terrain& terrain : tileset.terrains) {
        ImGui::PushID(terrain.id);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float side = ImGui::GetTextLineHeight();
        ImGui::GetWindowDrawList()->AddRectFilled(
            at, {at.x + side, at.y + side}, IM_COL32(terrain.color.r, terrain.color.g, terrain.color.b, 255),
            3.0f);
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        const std::string words =
            format("{}  -  {}, {} tiles", terrain.name,
                   terrainModeNames()[static_cast<std::size_t>(terrain.mode)], terrain.tiles.size());
        if (ImGui::Selectable(words.c_str(), terrain.id == chosen)) chosen = terrain.id;
        ui.widgets.mark("Tileset/terrain/" + terrain.name, terrain.id == chosen ? "chosen" : "");
        ImGui::PopID();
    }
    for (std::size_t mode = 0; mode < kModeWords.size(); ++mode) {
        if (mode > 0) ImGui::SameLine(0.0f, ui.px(4.0f));
        if (ImGui::Button(format("+ {}", kModeWords[mode]).c_str())) {
            changeTileset(ui.workspace, "add terrain",
                          [&](Tileset& set) { chosen = addTerrain(set, static_cast<TerrainMode>(mode)).id; });
            ui.workspace.undo.endGesture();
        }
        ui.widgets.mark(format("Tileset/addTerrain/{}", terrainModeNames()[mode]));
        tooltip("Adds a terrain. Then select its tiles on the left, and click their arrangement below.");
    }
}

void drawName(Ui& ui, const Terrain& terrain) {
    std::array<char, 64> name{};
    terrain.name.copy(name.data(), name.size() - 1);
    ImGui::SetNextItemWidth(ui.px(140.0f));
    ImGui::InputText("##name", name.data(), name.size());
    ui.widgets.mark("Tileset/terrainName", terrain.name);
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        changeTerrain(ui, "rename terrain", terrain.id,
                      [&](Terrain& changed, Tileset&) { changed.name = name.data(); });
    }
    ImGui::SameLine();
    if (ImGui::Button("Remove")) {
        const int id = terrain.id;
        changeTileset(ui.workspace, "remove terrain", [&](Tileset& set) {
            std::erase_if(set.terrains, [&](const Terrain& other) { return other.id == id; });
        });
        ui.workspace.undo.endGesture();
    }
    ui.widgets.mark("Tileset/removeTerrain");
}

/// Draws a button per standard arrangement; a click assigns neighbour masks to all selected tiles.
void drawLayouts(Ui& ui, const Terrain& terrain, std::span<const int> chosen) {
    ImGui::TextDisabled("Arrangement of the selected tiles");
    std::vector<int> tiles{chosen.begin(), chosen.end()};
    for (std::size_t i = 0; i < terrainLayoutNames().size(); ++i) {
        if (i > 0) ImGui::SameLine(0.0f, ui.px(4.0f));
        const std::string label{terrainLayoutNames()[i]};
        const bool clicked = ImGui::Button(label.c_str());
        ui.widgets.mark("Tileset/layout/" + label);
        tooltip(
            i == 0   ? "Standard order of most tools: first the tile without neighbours, last the tile with "
                       "neighbours on all sides."
            : i == 1 ? "A 3 x 3 block, a column one tile wide at its right, and a row one tile high below it."
                     : "A 3 x 3 block: corners, edges and the inside.");
        if (!clicked || tiles.empty()) continue;
        changeTerrain(ui, "assign terrain tiles", terrain.id, [&](Terrain& changed, Tileset& set) {
            assignMasks(changed, set, tiles, static_cast<TerrainLayout>(i));
        });
    }
}

/// Draws a 3 x 3 grid; a click toggles whether the terrain continues in that direction.
void drawMask(Ui& ui, const Terrain& terrain, const Tileset& tileset, std::span<const int> chosen) {
    const std::optional<std::uint8_t> now = maskOf(terrain, chosen.front());
    const std::vector<int> tiles{chosen.begin(), chosen.end()};
    const float cell = ui.px(30.0f);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + 3.0f * cell, from.y + 3.0f * cell}, palette::kCanvas);
    drawTile(ui, list, tileset, cellOf(chosen.front()),
             {{from.x, from.y}, {from.x + 3.0f * cell, from.y + 3.0f * cell}});
    for (int i = 0; i < 9; ++i) {
        const ImVec2 at{from.x + cell * static_cast<float>(i % 3), from.y + cell * static_cast<float>(i / 3)};
        const std::uint8_t bit = kBits[static_cast<std::size_t>(i)];
        const std::uint8_t all = countedMask(terrain.mode, 255);
        ImGui::SetCursorScreenPos(at);
        ImGui::PushID(i);
        const bool clicked = ImGui::InvisibleButton("bit", {cell, cell});
        ImGui::PopID();
        const bool on = now && (i == 4 || (*now & bit) != 0);
        ui.widgets.mark(format("Tileset/mask/{}", i), on ? "on" : "off");
        if (on)
            list.AddRectFilled(at, {at.x + cell, at.y + cell},
                               IM_COL32(terrain.color.r, terrain.color.g, terrain.color.b, 130));
        if (i == 4 || (all & bit) != 0) outline(list, at, {at.x + cell, at.y + cell}, palette::kCellLine);
        if (!clicked || (i != 4 && (all & bit) == 0)) continue;
        std::optional<std::uint8_t> next;  // a click on the middle takes a tile out, or adds it alone
        if (i != 4 || !now) next = static_cast<std::uint8_t>(i == 4 ? 0 : now.value_or(0) ^ bit);
        changeTerrain(ui, "set terrain mask", terrain.id,
                      [&](Terrain& changed, Tileset&) { setMask(changed, tiles, next); });
    }
    ImGui::SetCursorScreenPos({from.x, from.y + 3.0f * cell + ui.px(4.0f)});
    ImGui::TextDisabled("%s", !now ? "Not part of this terrain; click a cell to add the tile."
                                   : "Click the center to remove the tile from the terrain.");
}

}  // namespace

void drawTerrainPage(Ui& ui, const Tileset& tileset, std::span<const int> chosen, int& terrain) {
    drawList(ui, tileset, terrain);
    if (tileset.terrains.empty()) {
        ImGui::TextWrapped("Paint terrain with T: each cell gets the tile that fits its neighbours.");
        return;
    }
    // A click in drawList() may have written the file and replaced the tileset.
    const auto found = std::find_if(tileset.terrains.begin(), tileset.terrains.end(),
                                    [&](const Terrain& other) { return other.id == terrain; });
    if (found == tileset.terrains.end()) {
        terrain = tileset.terrains.front().id;
        return;
    }
    const Terrain edited = *found;
    ImGui::Separator();
    drawName(ui, edited);
    drawLayouts(ui, edited, chosen);
    if (!chosen.empty()) drawMask(ui, edited, tileset, chosen);
}

}  // namespace plumb::editor::ui
