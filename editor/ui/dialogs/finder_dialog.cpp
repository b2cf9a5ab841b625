#include "editor/ui/dialogs/finder_dialog.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.hpp"
#include "editor/ui/icons.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr const char* kName = "finder";
constexpr float kWidth = 560.0f;     // px at scale 1: width of the dialog
constexpr float kRowHeight = 24.0f;  // px at scale 1: height of a row
constexpr int kPage = 10;            // rows skipped by Page Up and Page Down
constexpr std::size_t kRowsShown = 12;

constexpr const char* kNoLetters = "No name contains these letters.";

/// One kind of search and the request that opens it.
struct WhatRow {
    WindowRequest request;
    Finder::What what;
    const char* asks;  ///< hint in the empty search field
    const char* none;  ///< text shown if the list is empty before the user types
};
constexpr std::array kWhats{
    WhatRow{WindowRequest::FindFile, Finder::What::Files,
            "A scene, prefab, asset or entity   (>: only commands, @: only entities)", kNoLetters},
    WhatRow{WindowRequest::FindCommand, Finder::What::Commands, "What do you want to do?", kNoLetters},
    WhatRow{WindowRequest::ChooseScene, Finder::What::Scenes, "Which scene?",
            "This project has no scenes. Scenes are files in its folder scenes/ that end in .scene.json."},
    WhatRow{WindowRequest::ChoosePrefab, Finder::What::Prefabs,
            "Which prefab?   (its instance is added in the center of the view)",
            "This project has no prefabs. Prefabs are files that end in .prefab.json."},
};

const WhatRow* rowOf(WindowRequest request) {
    const auto* found = std::find_if(kWhats.begin(), kWhats.end(),
                                     [&](const WhatRow& row) { return row.request == request; });
    return found == kWhats.end() ? nullptr : found;
}

const WhatRow& rowOf(Finder::What what) {
    return *std::find_if(kWhats.begin(), kWhats.end(), [&](const WhatRow& row) { return row.what == what; });
}

Icon iconOfItem(const Workspace& workspace, const FinderItem& item) {
    switch (item.kind) {
        case FinderItem::Kind::Scene: return Icon::Layers;
        case FinderItem::Kind::Prefab: return Icon::Star;
        case FinderItem::Kind::Entity:
            return iconOf(workspace.document.world, workspace.document.find(item.object));
        case FinderItem::Kind::Command: return iconOfAction(item.id);
        case FinderItem::Kind::Asset: break;
    }
    switch (item.asset) {
        case AssetKind::Tileset: return Icon::Tiles;
        case AssetKind::Animation: return Icon::Watch;
        case AssetKind::Sound: return Icon::Play;
        case AssetKind::Font: return Icon::Text;
        default: return Icon::Picture;
    }
}

std::string kindName(const FinderItem& item) {
    switch (item.kind) {
        case FinderItem::Kind::Entity: return "entity";
        case FinderItem::Kind::Command: return {};
        default: return std::string{nameOfKind(item.asset)};
    }
}

}  // namespace

std::string FinderDialog::draw(Ui& ui) {
    WindowRequest& request = ui.workspace.request;
    if (const WhatRow* row = rowOf(request); row != nullptr) {
        finder_.open(ui.workspace, row->what);
        request = WindowRequest::None;
        typed_.clear();
        scroll_ = true;
        ImGui::OpenPopup(kName);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = std::min(ui.px(kWidth), display.x * 0.9f);
    ImGui::SetNextWindowPos({std::floor((display.x - width) * 0.5f), std::floor(display.y * 0.12f)});
    ImGui::SetNextWindowSize({width, 0.0f});
    if (!ImGui::BeginPopup(kName, ImGuiWindowFlags_NoMove)) return {};
    done_ = false;
    drawField(ui);
    drawRows(ui);
    if (pressed(Key::Escape)) ImGui::CloseCurrentPopup();
    std::string scene;
    if (done_) {
        ImGui::CloseCurrentPopup();
        scene = finder_.choose(ui.workspace);
    }
    ImGui::EndPopup();
    return scene;
}

void FinderDialog::drawField(Ui& ui) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const std::string before = typed_;
    done_ = textField("##typed", typed_, ImGuiInputTextFlags_EnterReturnsTrue, rowOf(finder_.what()).asks);
    ui.widgets.mark("Finder/typed", typed_);
    if (typed_ != before && !pressed(Key::Escape)) {
        finder_.search(ui.workspace, typed_);
        scroll_ = true;
    }
    const int step = pressed(Key::Down, true)       ? 1
                     : pressed(Key::Up, true)       ? -1
                     : pressed(Key::PageDown, true) ? kPage
                     : pressed(Key::PageUp, true)   ? -kPage
                                                    : 0;
    if (step == 0) return;
    finder_.step(step);
    scroll_ = true;
}

void FinderDialog::drawRows(Ui& ui) {
    const std::size_t count = finder_.rows().size();
    if (count == 0) {
        const char* none = typed_.empty() ? rowOf(finder_.what()).none : kNoLetters;
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
        ImGui::TextWrapped("%s", none);
        ImGui::PopStyleColor();
        ui.widgets.mark("Finder/nothing", none);
        return;
    }
    const float height = ui.px(kRowHeight);
    const float whole = height * static_cast<float>(std::min(count, kRowsShown));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
    beginChild("rows", {0.0f, whole}, false);
    const float width = ImGui::GetContentRegionAvail().x;
    if (std::exchange(scroll_, false)) {
        const float top = height * static_cast<float>(finder_.chosen);
        if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
        if (top + height > ImGui::GetScrollY() + whole) ImGui::SetScrollY(top + height - whole);
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), height);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            drawRow(ui, static_cast<std::size_t>(i), width);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    if (finder_.found() > count)
        ImGui::TextDisabled("%zu more results; type more to narrow the search", finder_.found() - count);
}

void FinderDialog::drawRow(Ui& ui, std::size_t index, float width) {
    const FinderRow& row = finder_.rows()[index];
    const FinderItem& item = finder_.item(row);
    const float height = ui.px(kRowHeight);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("row", {width, height});
    ImGui::PopID();
    const std::string_view name = std::string_view{item.text}.substr(item.name);
    ui.widgets.mark(format("Finder/{}", index), item.text);
    ui.widgets.mark(format("Finder/{}", name), item.possible ? "" : "greyed");
    if (clicked) finder_.chosen = index, done_ = true;

    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to{at.x + width, at.y + height};
    if (index == finder_.chosen) {
        list.AddRectFilled(at, to, palette::kAccentSoft, ui.px(4.0f));
    } else if (ImGui::IsItemHovered()) {
        list.AddRectFilled(at, to, palette::kHover, ui.px(4.0f));
    }
    const float line = at.y + std::floor((height - ImGui::GetTextLineHeight()) * 0.5f);
    float x = at.x + ui.px(8.0f);
    if (const Icon icon = iconOfItem(ui.workspace, item);
        item.kind != FinderItem::Kind::Command || icon != Icon::Entity)
        drawIcon(list, icon, {x + ui.px(8.0f), at.y + height * 0.5f}, ui.px(13.0f),
                 item.possible ? palette::kText : palette::kTextDim);
    x += ui.px(26.0f);
    list.PushClipRect(at, {to.x - ui.px(90.0f), to.y}, true);
    if (item.kind == FinderItem::Kind::Command) {
        x = drawLetters(ui, row, item, 0, item.name, {x, line}, true);
        drawLetters(ui, row, item, item.name, item.text.size(), {x, line}, !item.possible);
    } else {
        x = drawLetters(ui, row, item, item.name, item.text.size(), {x, line}, false);
        drawLetters(ui, row, item, 0, item.name == 0 ? 0 : item.name - 1, {x + ui.px(12.0f), line}, true);
    }
    list.PopClipRect();
    const std::string right = item.detail.empty() ? kindName(item) : item.detail;
    const float wide = ImGui::CalcTextSize(right.c_str()).x;
    list.AddText({to.x - wide - ui.px(8.0f), line}, palette::kTextDim, right.c_str());
}

float FinderDialog::drawLetters(const Ui& ui, const FinderRow& row, const FinderItem& item, std::size_t from,
                                std::size_t to, ImVec2 at, bool dim) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto meant = [&](std::size_t i) {
        return std::binary_search(row.match.at.begin(), row.match.at.end(), static_cast<std::uint32_t>(i));
    };
    // Draws runs of letters of equal style at once, to keep the kerning of the font.
    for (std::size_t i = from; i < to;) {
        std::size_t end = i + 1;
        while (end < to && meant(end) == meant(i)) ++end;
        const char* first = item.text.data() + i;
        const char* last = item.text.data() + end;
        const ImU32 color = meant(i) ? palette::kAccent : dim ? palette::kTextDim : palette::kText;
        ImFont* font = meant(i) ? ui.fonts.strong : ui.fonts.text;
        list.AddText(font, ui.fonts.size, at, color, first, last);
        at.x += font->CalcTextSizeA(ui.fonts.size, 1e9f, 0.0f, first, last).x;
        i = end;
    }
    return at.x;
}

}  // namespace plumb::editor::ui
