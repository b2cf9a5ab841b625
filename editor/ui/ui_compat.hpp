#pragma once

#include <array>
#include <cstdint>

#include <imgui.h>

#include "math/vec2.hpp"
#include "platform/key.hpp"

namespace plumb::editor::ui {

// Every use of ImGui that differs between 1.86 (Debian 12) and 1.92 (vcpkg, Homebrew) stands here and in
// platform_feed.cpp, so that the rest of the editor is written once.

inline ImTextureID textureId(std::uintptr_t native) {
#if IMGUI_VERSION_NUM >= 19140
    return static_cast<ImTextureID>(native);
#else
    return reinterpret_cast<ImTextureID>(native);
#endif
}

inline bool beginChild(const char* id, ImVec2 size, bool border, ImGuiWindowFlags flags = 0) {
#if IMGUI_VERSION_NUM >= 19110
    return ImGui::BeginChild(id, size, border ? ImGuiChildFlags_Borders : ImGuiChildFlags_None, flags);
#elif IMGUI_VERSION_NUM >= 19000
    return ImGui::BeginChild(id, size, border ? ImGuiChildFlags_Border : ImGuiChildFlags_None, flags);
#else
    return ImGui::BeginChild(id, size, border, flags);
#endif
}

/// Before an item that others may lie on.
inline void allowOverlapBefore() {
#if IMGUI_VERSION_NUM >= 18970
    ImGui::SetNextItemAllowOverlap();
#endif
}
/// After that item; each version needs one of the two.
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

/// From 1.92.8 on the back end filters every texture; pixel art asks for its own pixels back.
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

/// A part of a texture on four corners, clockwise from the top left, each with its place in the texture.
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

/// Makes the glyphs of the loaded fonts; newer versions make them when they are drawn.
inline void buildFonts() {
#if IMGUI_VERSION_NUM < 19200
    ImGui::GetIO().Fonts->Build();
#endif
}

/// Whether a menu, a list or a question is open; and closes them all.
bool anyPopupOpen();
void closePopups();

/// A check box; mixed: it stands for several things, of which some are on.
bool checkbox(const char* label, bool& on, bool mixed);

/// Whether a key went down in this frame, for what ImGui acts on too.
/// @param repeats  also again and again while it is held
bool pressed(Key key, bool repeats = false);
/// Takes the mouse and the keyboard from the item that has them.
void dropActiveItem();
/// A bar that divides two panes; a drag gives the one what it takes of the other.
/// @param least  px that each keeps
/// @return whether it is held
bool splitterBar(const char* id, ImVec2 from, ImVec2 to, bool upright, float& before, float& after,
                 float least);

/// ImGui's name of a key, or none.
int imguiKey(Key key);

}  // namespace plumb::editor::ui
