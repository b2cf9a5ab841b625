#include "editor/ui/theme.hpp"

#include <array>
#include <cmath>
#include <string>

namespace plumb::editor::ui {
namespace {

/// io.UserData points to this constant while the light theme is in use; with the dark theme it is null.
constexpr bool kLightInUse = true;

/// Ranges of loaded characters: Latin with accents, and punctuation.
constexpr std::array<ImWchar, 5> kLetters{0x20, 0x17f, 0x2010, 0x2044, 0};

ImFont* loadFont(const Path& file, float size) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) return nullptr;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.string().c_str(), size, &config, kLetters.data());
}

Fonts loadFonts(const Path& folder, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    Fonts fonts;
    fonts.size = std::round(size);
    fonts.text = loadFont(folder / "b612.otf", fonts.size);
    if (fonts.text == nullptr) fonts.text = atlas.AddFontDefault();
    fonts.strong = loadFont(folder / "b612_bold.otf", fonts.size);
    if (fonts.strong == nullptr) fonts.strong = fonts.text;
    fonts.mono = loadFont(folder / "b612_mono.otf", fonts.size);
    if (fonts.mono == nullptr) fonts.mono = fonts.text;
    fonts.titleSize = std::round(fonts.size * 2.0f);
    fonts.title = loadFont(folder / "b612_bold.otf", fonts.titleSize);
    if (fonts.title == nullptr) fonts.title = fonts.strong;
    ImGui::GetIO().FontDefault = fonts.text;
    return fonts;
}

void setColors(ImGuiStyle& style) {
    const struct {
        ImGuiCol slot;
        ThemeColor color;
    } colors[] = {
        {ImGuiCol_Text, palette::kText},
        {ImGuiCol_TextDisabled, palette::kTextDim},
        {ImGuiCol_WindowBg, palette::kPanel},
        {ImGuiCol_ChildBg, palette::kNothing},
        {ImGuiCol_PopupBg, palette::kPopup},
        {ImGuiCol_Border, palette::kBorder},
        {ImGuiCol_FrameBg, palette::kField},
        {ImGuiCol_FrameBgHovered, palette::kFieldHovered},
        {ImGuiCol_FrameBgActive, palette::kFieldHovered},
        {ImGuiCol_TitleBg, palette::kHeader},
        {ImGuiCol_TitleBgActive, palette::kHeader},
        {ImGuiCol_MenuBarBg, palette::kChrome},
        {ImGuiCol_ScrollbarBg, palette::kNothing},
        {ImGuiCol_ScrollbarGrab, palette::kScroll},
        {ImGuiCol_ScrollbarGrabHovered, palette::kScrollHovered},
        {ImGuiCol_ScrollbarGrabActive, palette::kScrollActive},
        {ImGuiCol_CheckMark, palette::kAccent},
        {ImGuiCol_SliderGrab, palette::kAccentGrab},
        {ImGuiCol_SliderGrabActive, palette::kAccent},
        {ImGuiCol_Button, palette::kButton},
        {ImGuiCol_ButtonHovered, palette::kButtonHovered},
        {ImGuiCol_ButtonActive, palette::kAccentPressed},
        {ImGuiCol_Header, palette::kAccentSoft},
        {ImGuiCol_HeaderHovered, palette::kHover},
        {ImGuiCol_HeaderActive, palette::kAccentPressed},
        {ImGuiCol_Separator, palette::kBorder},
        {ImGuiCol_SeparatorHovered, palette::kAccentSoft},
        {ImGuiCol_SeparatorActive, palette::kAccent},
        {ImGuiCol_Tab, palette::kChrome},
        {ImGuiCol_TabHovered, palette::kButtonHovered},
        {ImGuiCol_TabActive, palette::kPanel},
        {ImGuiCol_TableHeaderBg, palette::kHeader},
        {ImGuiCol_TableBorderStrong, palette::kBorder},
        {ImGuiCol_TableBorderLight, palette::kBorder},
        {ImGuiCol_TableRowBgAlt, palette::kCard},
        {ImGuiCol_PlotHistogram, palette::kAccent},
        {ImGuiCol_TextSelectedBg, palette::kAccentPressed},
        {ImGuiCol_DragDropTarget, palette::kAccent},
        {ImGuiCol_NavHighlight, palette::kAccent},
        {ImGuiCol_ModalWindowDimBg, palette::kShade},
    };
    for (const auto& [slot, color] : colors) {
        style.Colors[slot] = colorOf(color);
    }
}

}  // namespace

ImVec4 colorOf(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

ThemeColor::operator ImU32() const { return ImGui::GetIO().UserData == &kLightInUse ? light : dark; }

void applyColors(Theme theme) {
    const bool light = theme == Theme::Light;
    ImGui::GetIO().UserData = light ? const_cast<bool*>(&kLightInUse) : nullptr;
    ImGuiStyle& style = ImGui::GetStyle();
    light ? ImGui::StyleColorsLight(&style) : ImGui::StyleColorsDark(&style);
    style.FrameBorderSize = light ? 1.0f : 0.0f;  // white fields on a light panel need an edge
    setColors(style);
}

Fonts applyTheme(const Path& fontFolder, Theme theme, float scale, float textSize) {
    // Each change starts from an unscaled style, because scaling repeatedly accumulates rounding errors.
    ImGuiStyle style;
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
    applyColors(theme);
    return loadFonts(fontFolder, textSize * scale);
}

}  // namespace plumb::editor::ui
