#include "editor/ui/theme.hpp"

#include <array>
#include <cmath>
#include <string>

namespace plumb::editor::ui {
namespace {

constexpr float kTextSize = 14.0f;  ///< px at scale 1
/// Western letters, the dash that stands for values that are not the same, and the three dots. Pairs, ended
/// by 0.
constexpr std::array<ImWchar, 7> kLetters{0x20, 0xff, 0x2013, 0x2014, 0x2026, 0x2026, 0};

ImFont* loadFont(const Path& file, float size) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) return nullptr;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.string().c_str(), size, &config, kLetters.data());
}

Fonts loadFonts(const Path& folder, float scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    Fonts fonts;
    fonts.size = std::round(kTextSize * scale);
    fonts.text = loadFont(folder / "b612.otf", fonts.size);
    if (fonts.text == nullptr) fonts.text = atlas.AddFontDefault();
    fonts.strong = loadFont(folder / "b612_bold.otf", fonts.size);
    if (fonts.strong == nullptr) fonts.strong = fonts.text;
    fonts.mono = loadFont(folder / "b612_mono.otf", fonts.size);
    if (fonts.mono == nullptr) fonts.mono = fonts.text;
    ImGui::GetIO().FontDefault = fonts.text;
    return fonts;
}

void setColors(ImGuiStyle& style) {
    const struct {
        ImGuiCol slot;
        ImU32 color;
    } colors[] = {
        {ImGuiCol_Text, palette::kText},
        {ImGuiCol_TextDisabled, palette::kTextDim},
        {ImGuiCol_WindowBg, palette::kPanel},
        {ImGuiCol_ChildBg, IM_COL32(0, 0, 0, 0)},
        {ImGuiCol_PopupBg, IM_COL32(43, 46, 53, 252)},
        {ImGuiCol_Border, IM_COL32(58, 62, 71, 255)},
        {ImGuiCol_FrameBg, palette::kField},
        {ImGuiCol_FrameBgHovered, IM_COL32(33, 36, 42, 255)},
        {ImGuiCol_FrameBgActive, IM_COL32(33, 36, 42, 255)},
        {ImGuiCol_TitleBg, palette::kHeader},
        {ImGuiCol_TitleBgActive, palette::kHeader},
        {ImGuiCol_MenuBarBg, palette::kChrome},
        {ImGuiCol_ScrollbarBg, IM_COL32(0, 0, 0, 0)},
        {ImGuiCol_ScrollbarGrab, IM_COL32(68, 73, 84, 255)},
        {ImGuiCol_ScrollbarGrabHovered, IM_COL32(86, 92, 105, 255)},
        {ImGuiCol_ScrollbarGrabActive, IM_COL32(100, 107, 122, 255)},
        {ImGuiCol_CheckMark, palette::kAccent},
        {ImGuiCol_SliderGrab, IM_COL32(77, 163, 255, 150)},
        {ImGuiCol_SliderGrabActive, palette::kAccent},
        {ImGuiCol_Button, IM_COL32(56, 60, 69, 255)},
        {ImGuiCol_ButtonHovered, IM_COL32(68, 73, 84, 255)},
        {ImGuiCol_ButtonActive, IM_COL32(77, 163, 255, 120)},
        {ImGuiCol_Header, palette::kAccentSoft},
        {ImGuiCol_HeaderHovered, IM_COL32(255, 255, 255, 18)},
        {ImGuiCol_HeaderActive, IM_COL32(77, 163, 255, 100)},
        {ImGuiCol_Separator, IM_COL32(58, 62, 71, 255)},
        {ImGuiCol_Tab, palette::kChrome},
        {ImGuiCol_TabHovered, IM_COL32(58, 62, 71, 255)},
        {ImGuiCol_TextSelectedBg, IM_COL32(77, 163, 255, 90)},
        {ImGuiCol_DragDropTarget, palette::kAccent},
        {ImGuiCol_ModalWindowDimBg, IM_COL32(10, 11, 13, 150)},
    };
    for (const auto& [slot, color] : colors) {
        style.Colors[slot] = colorOf(color);
    }
}

}  // namespace

ImVec4 colorOf(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

Fonts applyTheme(const Path& fontFolder, float scale) {
    // Scaling a scaled style drifts, so each change starts from a fresh one.
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    setColors(style);
    style.WindowPadding = {8.0f, 8.0f};
    style.FramePadding = {7.0f, 4.0f};
    style.ItemSpacing = {7.0f, 5.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.IndentSpacing = 16.0f;
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 8.0f;
    style.WindowBorderSize = 0.0f;
    style.ChildBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.FrameBorderSize = 0.0f;
    style.WindowRounding = 0.0f;
    style.ChildRounding = 0.0f;
    style.FrameRounding = 4.0f;
    style.PopupRounding = 4.0f;
    style.ScrollbarRounding = 6.0f;
    style.GrabRounding = 3.0f;
    style.TabRounding = 4.0f;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
    return loadFonts(fontFolder, scale);
}

}  // namespace plumb::editor::ui
