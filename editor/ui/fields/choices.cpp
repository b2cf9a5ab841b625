#include "editor/ui/fields/choices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "core/text.hpp"
#include "editor/model/document/tile_stamp.hpp"
#include "editor/model/workspace.hpp"
#include "editor/ui/ui_compat.hpp"
#include "math/color.hpp"

namespace plumb::editor::ui {
namespace {

int enumValue(const FieldInfo& field, const FieldValue& value) {
    if (field.size == 1) return std::to_integer<int>(value.bytes[0]);
    int number = 0;
    std::memcpy(&number, value.bytes.data(), sizeof number);
    return number;
}

std::string layerName(const Workspace& workspace, unsigned layer) {
    const std::vector<std::string>& names = workspace.project.layers;
    return layer < names.size() && !names[layer].empty() ? names[layer] : format("layer {}", layer + 1);
}

/// Returns a text for a set of layers: "all", "none", "player, enemies" or "5 layers".
std::string layersText(const FieldRow& row, std::uint32_t bits) {
    constexpr int kNamed = 2;  // maximum number of layers shown by name
    if (row.mixed()) return kMixed;
    if (bits == ~0u) return "all";
    if (bits == 0) return "none";
    if (std::popcount(bits) > kNamed) return format("{} layers", std::popcount(bits));
    std::string text;
    for (unsigned layer = 0; layer < 32; ++layer) {
        if ((bits >> layer & 1u) == 0) continue;
        text += text.empty() ? "" : ", ";
        text += layerName(row.ui.workspace, layer);
    }
    return text;
}

void setBits(const FieldRow& row, std::uint32_t mask, bool on) {
    row.change([=](FieldValue& value, std::size_t) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, value.bytes.data(), sizeof bits);
        bits = on ? bits | mask : bits & ~mask;
        std::memcpy(value.bytes.data(), &bits, sizeof bits);
    });
}

constexpr int kMostCells = 4096;  // maximum cells along one side, to limit the memory after a typing error

/// Edits the width or height of a grid. The value is applied when the field loses the focus (Enter, Tab,
/// mouse); Esc restores it. @return true if `cells` was changed
bool editSide(const FieldRow& row, const char* letter, int& cells, float width, const std::string& path) {
    const Ui& ui = row.ui;
    ImGui::PushID(letter);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", letter);
    ImGui::SameLine(0.0f, ui.px(5.0f));
    ImGui::SetNextItemWidth(width - ui.px(14.0f));
    int typed = cells;
    ImGui::InputInt("##side", &typed, 0, 0);
    // The last typed value is stored, because ImGui resets it in the frame in which the field loses the
    // focus.
    int* last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("typed"), cells);
    const bool left = ImGui::IsItemDeactivatedAfterEdit() && !pressed(Key::Escape);
    if (left) typed = *last;
    *last = ImGui::IsItemActive() ? typed : cells;
    row.ui.widgets.mark(path, format("{}", cells));
    tooltip("Size in cells. The layer grows or is cut at its right and lower edges.");
    ImGui::PopID();
    if (!left || typed == cells) return false;
    cells = std::clamp(typed, 1, kMostCells);
    return true;
}

std::array<float, 4> partsOf(Color color) {
    return {static_cast<float>(color.r) / 255.0f, static_cast<float>(color.g) / 255.0f,
            static_cast<float>(color.b) / 255.0f, static_cast<float>(color.a) / 255.0f};
}

std::byte byteOf(float part) { return static_cast<std::byte>(std::clamp(part, 0.0f, 1.0f) * 255.0f + 0.5f); }

}  // namespace

void chooseBool(const FieldRow& row) {
    bool on = row.value<bool>();
    const bool changed = checkbox("##on", on, row.mixed());
    row.ui.widgets.mark(row.path, row.mixed() ? kMixed : row.value<bool>() ? "true" : "false");
    if (!changed) return;
    if (row.mixed()) on = true;  // the first click on different values turns all of them on
    row.set(FieldValue::of(on));
}

void chooseEnum(const FieldRow& row) {
    const auto& names = row.target.field.names;
    const int value = enumValue(row.target.field, row.shared.value);
    const auto now =
        std::find_if(names.begin(), names.end(), [&](const EnumName& name) { return name.value == value; });
    const std::string shown = row.mixed()          ? kMixed
                              : now == names.end() ? format("{}", value)
                                                   : std::string{now->name};
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##enum", shown.c_str());
    row.ui.widgets.mark(row.path, shown);
    if (!open) return;
    for (const EnumName& name : names) {
        const bool same = !row.mixed() && name.value == value;
        if (ImGui::Selectable(std::string{name.name}.c_str(), same)) {
            row.set(row.target.field.size == 1 ? FieldValue::of(static_cast<std::uint8_t>(name.value))
                                               : FieldValue::of(name.value));
        }
        row.ui.widgets.mark(format("{}/{}", row.path, name.name));
    }
    ImGui::EndCombo();
}

void chooseLayers(const FieldRow& row) {
    const auto bits = row.value<std::uint32_t>();
    const std::string shown = layersText(row, bits);
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##layers", shown.c_str(), ImGuiComboFlags_HeightLarge);
    row.ui.widgets.mark(row.path, shown);
    if (!open) return;
    if (ImGui::Button("All")) setBits(row, ~0u, true);
    row.ui.widgets.mark(row.path + "/all");
    ImGui::SameLine();
    if (ImGui::Button("None")) setBits(row, ~0u, false);
    row.ui.widgets.mark(row.path + "/none");
    const std::size_t named = row.ui.workspace.project.layers.size();
    for (unsigned layer = 0; layer < 32; ++layer) {
        const bool used = layer < named || row.shared.mixed.bit(layer) ||
                          ((bits >> layer & 1u) != 0 && bits != ~0u) || layer < 8;
        if (!used) continue;
        const bool mixed = row.shared.mixed.bit(layer);
        bool on = (bits >> layer & 1u) != 0;
        if (checkbox(layerName(row.ui.workspace, layer).c_str(), on, mixed))
            setBits(row, 1u << layer, mixed || on);
        row.ui.widgets.mark(format("{}/{}", row.path, layer + 1), mixed                       ? kMixed
                                                                  : (bits >> layer & 1u) != 0 ? "on"
                                                                                              : "off");
    }
    ImGui::EndCombo();
}

void chooseTiles(const FieldRow& row) {
    Ui& ui = row.ui;
    TileStore& tiles = ui.workspace.shownWorld().tiles();
    const TileGrid* grid = tiles.find(row.value<TilesId>());
    int width = grid == nullptr ? 0 : grid->width();
    int height = grid == nullptr ? 0 : grid->height();
    const float half = (ImGui::GetContentRegionAvail().x - ui.px(4.0f)) * 0.5f;
    const bool wider = editSide(row, "w", width, half, row.path + ".width");
    ImGui::SameLine(0.0f, ui.px(4.0f));
    const bool higher = editSide(row, "h", height, half, row.path + ".height");
    if ((!wider && !higher) || !ui.workspace.canEdit()) return;
    // Each layer keeps its tiles and its other side length. The old grid stays in the store of grids, so
    // undo only has to restore its id.
    row.change([&](FieldValue& value, std::size_t) {
        TilesId id;
        std::memcpy(&id, value.bytes.data(), sizeof id);
        const TileGrid* old = tiles.find(id);
        const TileGrid from = old == nullptr ? TileGrid{} : *old;
        value = FieldValue::of(tiles.add(resized(from, std::max(wider ? width : from.width(), 1),
                                                 std::max(higher ? height : from.height(), 1))));
    });
}

void chooseColor(const FieldRow& row) {
    const std::array<float, 4> parts = partsOf(row.value<Color>());
    const float side = ImGui::GetFrameHeight();
    const ImVec4 shown{parts[0], parts[1], parts[2], parts[3]};
    if (ImGui::ColorButton("##swatch", shown,
                           ImGuiColorEditFlags_AlphaPreviewHalf | ImGuiColorEditFlags_NoDragDrop |
                               ImGuiColorEditFlags_NoTooltip,
                           {side * 1.4f, side}))
        ImGui::OpenPopup("picker");
    row.ui.widgets.mark(row.path);
    if (!ImGui::BeginPopup("picker")) return;
    std::array<float, 4> picked = parts;
    ImGui::SetNextItemWidth(row.ui.px(220.0f));
    const bool changed =
        ImGui::ColorPicker4("##picked", picked.data(),
                            ImGuiColorEditFlags_AlphaBar | ImGuiColorEditFlags_AlphaPreviewHalf |
                                ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoOptions);
    row.ui.widgets.mark(row.path + "/picker");
    if (changed) {
        // Changes only the edited channels, as the entities may differ in others. A drag is one undo step.
        editFields(row.ui.workspace, row.target, [&](FieldValue& value, std::size_t) {
            for (std::size_t i = 0; i < parts.size(); ++i) {
                if (byteOf(picked[i]) != byteOf(parts[i])) value.bytes[i] = byteOf(picked[i]);
            }
        });
    }
    ImGui::EndPopup();
}

void chooseLength(const FieldRow& row, std::uint32_t count) {
    const FieldInfo& field = row.target.field;
    const auto resize = [&](std::uint32_t length) {
        row.change([&](FieldValue& value, std::size_t) {
            // A new entry is a copy of the last one; bytes of removed entries are zeroed.
            const std::size_t at = std::min(count, length) * field.elementSize;
            if (length < count) std::fill_n(&value.bytes[at], field.elementSize, std::byte{});
            if (length > count && count > 0)
                std::copy_n(&value.bytes[at - field.elementSize], field.elementSize, &value.bytes[at]);
            field.countOf(value.bytes.data()) = length;
        });
    };
    ImGui::BeginDisabled(count >= field.capacity);
    if (ImGui::SmallButton("+")) resize(count + 1);
    ImGui::EndDisabled();
    row.ui.widgets.mark(row.path + "/more");
    tooltip("Add an entry");
    ImGui::SameLine(0.0f, row.ui.px(4.0f));
    ImGui::BeginDisabled(count == 0);
    if (ImGui::SmallButton("-")) resize(count - 1);
    ImGui::EndDisabled();
    row.ui.widgets.mark(row.path + "/less");
    tooltip("Remove the last entry");
    ImGui::SameLine();
    ImGui::TextDisabled("%u of %u", count, static_cast<unsigned>(field.capacity));
}

}  // namespace plumb::editor::ui
