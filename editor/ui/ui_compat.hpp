#pragma once

#include <array>
#include <cstdint>

#include <imgui.h>

#include "math/vec2.hpp"
#include "platform/key.hpp"

namespace plumb::editor::ui {

// All uses of ImGui that differ between the versions 1.86 (Debian 12) and 1.92 (vcpkg, Homebrew) are here and
// in platform_feed.cpp, so that the rest of the editor needs no version checks.

inline ImTextureID textureId(std::uintptr_t native) {
#if IMGUI_VERSION_NUM >= 19140
    return static_cast<ImTextureID>(native);
#else
    return reinterpret_cast<ImTextureID>(native);
#endif
}

/// Begins a scrolling part of a window; Tab walks through the parts of a dialog as through one window.
bool beginChild(const char* id, ImVec2 size, bool border, ImGuiWindowFlags flags = 0);

/// Lets later items overlap the next item; to be called before it, together with `allowOverlapAfter`.
inline void allowOverlapBefore() {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
#endif
}
/// Lets later items overlap the last item; to be called after it. Each version of ImGui needs one of the two
/// calls.
inline void allowOverlapAfter() {
#if IMGUI_VERSION_NUM < 18970
    ImGui::SetItemAllowOverlap();
#endif
}

inline void outline(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 color, float rounding = 0.0f,
                    float thickness = 1.0f) {
#if IMGUI_VERSION_NUM >= 19280
    list.AddRect(from, to, color, rounding, thickness, 0);
#else
    list.AddRect(from, to, color, rounding, 0, thickness);
#endif
}

inline void polyline(ImDrawList& list, const ImVec2* points, int count, ImU32 color, bool closed,
                     float thickness) {
    const ImDrawFlags flags = closed ? ImDrawFlags_Closed : ImDrawFlags_None;
#if IMGUI_VERSION_NUM >= 19280
    list.AddPolyline(points, count, color, thickness, flags);
#else
    list.AddPolyline(points, count, color, flags, thickness);
#endif
}

/// Draws a texture with nearest filtering, for pixel art. From ImGui 1.92.8 on the default is linear
/// filtering.
inline void imageOfPixels(ImDrawList& list, ImTextureID texture, ImVec2 from, ImVec2 to) {
#if IMGUI_VERSION_NUM >= 19280
    const ImGuiPlatformIO& io = ImGui::GetPlatformIO();
    list.AddCallback(io.DrawCallback_SetSamplerNearest, nullptr);
    list.AddImage(texture, from, to);
    list.AddCallback(io.DrawCallback_ResetRenderState, nullptr);
#else
    list.AddImage(texture, from, to);
#endif
}

/// Draws a part of a texture as a quad with nearest filtering. @param corners  clockwise from the top left
inline void quadOfPixels(ImDrawList& list, ImTextureID texture, const std::array<ImVec2, 4>& corners,
                         const std::array<Vec2, 4>& uv, ImU32 tint) {
    const auto at = [&](std::size_t i) { return ImVec2{uv[i].x, uv[i].y}; };
#if IMGUI_VERSION_NUM >= 19280
    const ImGuiPlatformIO& io = ImGui::GetPlatformIO();
    list.AddCallback(io.DrawCallback_SetSamplerNearest, nullptr);
#endif
    list.AddImageQuad(texture, corners[0], corners[1], corners[2], corners[3], at(0), at(1), at(2), at(3),
                      tint);
#if IMGUI_VERSION_NUM >= 19280
    list.AddCallback(io.DrawCallback_ResetRenderState, nullptr);
#endif
}

inline void pushFont(ImFont* font, [[maybe_unused]] float size) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::PushFont(font, size);
#else
    ImGui::PushFont(font);
#endif
}

/// Rasterizes the glyphs of the loaded fonts; ImGui 1.92 and later does this on demand.
inline void buildFonts() {
#if IMGUI_VERSION_NUM < 19200
    ImGui::GetIO().Fonts->Build();
#endif
}

/// True if a menu, a list or a dialog is open.
bool anyPopupOpen();
/// True if a modal dialog is open.
bool dialogOpen();
/// Closes all menus, lists and dialogs.
void closePopups();

/// Begins a frame. @param walks  Tab and the arrow keys move the focus between all widgets, Space and Enter
/// press the focused one; for dialogs, as these keys are shortcuts elsewhere
void newFrame(bool walks);
/// Lets Tab walk from the widgets of the surrounding window into those of the current child window or
/// scrolling table, and out of it.
void joinFocusOrder();
/// True if an item, e.g. a text field, was active at the start of this frame. Enter ends the item of the
/// field before the frame is over.
bool itemWasActive();

/// Draws a check box. @param mixed  the box represents several values, of which only some are on
bool checkbox(const char* label, bool& on, bool mixed);

/// True if a key was pressed in this frame. Only for keys that ImGui handles as well.
/// @param repeats  true: also reports the repeated presses while the key is held
bool pressed(Key key, bool repeats = false);
/// Ends the interaction with ImGui's active item, e.g. a drag or text input.
void dropActiveItem();
/// Draws a bar between two panes; dragging it enlarges one and shrinks the other.
/// @param upright        true: vertical bar between a left and a right pane
/// @param before, after  px: sizes of the left (upper) and right (lower) pane; the drag changes them
/// @param least          px: minimum size of each pane
/// @return true while the bar is held
bool splitterBar(const char* id, ImVec2 from, ImVec2 to, bool upright, float& before, float& after,
                 float least);

/// Returns ImGui's code of a key, or ImGui's code for "no key" if the editor does not pass it to ImGui.
int imguiKey(Key key);

}  // namespace plumb::editor::ui
