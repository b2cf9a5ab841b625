#include "editor/ui/ui_compat.hpp"

#include <array>

#include <imgui_internal.h>

namespace plumb::editor::ui {
namespace {

struct KeyPair {
    Key ours;
    int theirs;
};

#if IMGUI_VERSION_NUM >= 18700
constexpr int kNone = ImGuiKey_None;
constexpr int kPadEnter = ImGuiKey_KeypadEnter;
#else
constexpr int kNone = -1;
constexpr int kPadEnter = ImGuiKey_KeyPadEnter;
#endif

// Keys that ImGui handles itself, for text editing and navigation. The editor's shortcuts are in the action
// table.
constexpr std::array kKeys{
    KeyPair{Key::Tab, ImGuiKey_Tab},
    KeyPair{Key::Left, ImGuiKey_LeftArrow},
    KeyPair{Key::Right, ImGuiKey_RightArrow},
    KeyPair{Key::Up, ImGuiKey_UpArrow},
    KeyPair{Key::Down, ImGuiKey_DownArrow},
    KeyPair{Key::PageUp, ImGuiKey_PageUp},
    KeyPair{Key::PageDown, ImGuiKey_PageDown},
    KeyPair{Key::Home, ImGuiKey_Home},
    KeyPair{Key::End, ImGuiKey_End},
    KeyPair{Key::Insert, ImGuiKey_Insert},
    KeyPair{Key::Delete, ImGuiKey_Delete},
    KeyPair{Key::Backspace, ImGuiKey_Backspace},
    KeyPair{Key::Space, ImGuiKey_Space},
    KeyPair{Key::Enter, ImGuiKey_Enter},
    KeyPair{Key::Escape, ImGuiKey_Escape},
    KeyPair{Key::PadEnter, kPadEnter},
    KeyPair{Key::A, ImGuiKey_A},
    KeyPair{Key::C, ImGuiKey_C},
    KeyPair{Key::V, ImGuiKey_V},
    KeyPair{Key::X, ImGuiKey_X},
    KeyPair{Key::Y, ImGuiKey_Y},
    KeyPair{Key::Z, ImGuiKey_Z},
};

#if IMGUI_VERSION_NUM < 18940
/// Before 1.89.4, Tab stops only at fields for input, and Enter presses no button.
void walkThroughAll() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    const bool shown = g.NavId != 0 && !g.NavDisableHighlight;
    const bool tabbed = g.NavMoveSubmitted && (g.NavMoveFlags & ImGuiNavMoveFlags_Tabbing) != 0;
    // These flags make the request stop at items of all kinds. Those that cannot be pressed, and the cross in
    // the title bar, are left again.
    constexpr ImGuiNavMoveFlags kAll = ImGuiNavMoveFlags_Tabbing | ImGuiNavMoveFlags_FocusApi;
    constexpr ImGuiItemFlags kLeft = ImGuiItemFlags_Disabled | ImGuiItemFlags_NoNavDefaultFocus;
    const bool back = g.NavTabbingDir < 0;
    if (tabbed) {
        g.NavMoveFlags |= kAll;
        if (g.NavTabbingDir == 0 && shown) g.NavTabbingDir = 1;
    } else if (g.NavJustMovedToId != 0) {
        const ImGuiNavItemData& reached =
            g.NavTabbingResultFirst.ID == g.NavJustMovedToId ? g.NavTabbingResultFirst : g.NavMoveResultLocal;
        if ((reached.InFlags & kLeft) != 0) {
            ImGui::NavMoveRequestSubmit(
                ImGuiDir_None, back ? ImGuiDir_Up : ImGuiDir_Down, kAll,
                ImGuiScrollFlags_KeepVisibleEdgeX | ImGuiScrollFlags_KeepVisibleEdgeY);
            g.NavTabbingDir = back ? -1 : 1;
            g.NavTabbingResultFirst.Clear();
            g.NavTabbingCounter = -1;
        }
    }
    const bool entered = pressed(Key::Enter) || pressed(Key::PadEnter);
    if (entered && shown && g.ActiveId == 0) ImGui::ActivateItem(g.NavId);
}
#endif

}  // namespace

bool beginChild(const char* id, ImVec2 size, bool border, ImGuiWindowFlags flags) {
#if IMGUI_VERSION_NUM >= 19110
    const bool seen =
        ImGui::BeginChild(id, size, border ? ImGuiChildFlags_Borders : ImGuiChildFlags_None, flags);
#elif IMGUI_VERSION_NUM >= 19000
    const bool seen =
        ImGui::BeginChild(id, size, border ? ImGuiChildFlags_Border : ImGuiChildFlags_None, flags);
#else
    const bool seen = ImGui::BeginChild(id, size, border, flags);
#endif
    if (dialogOpen()) joinFocusOrder();
    return seen;
}

void newFrame(bool walks) {
    ImGuiIO& io = ImGui::GetIO();
    if (walks) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
    ImGui::NewFrame();
#if IMGUI_VERSION_NUM < 18940
    if (walks) walkThroughAll();
#endif
}

void joinFocusOrder() {
    ImGuiWindow* child = ImGui::GetCurrentWindow();
#if IMGUI_VERSION_NUM >= 19090
    child->ChildFlags |= ImGuiChildFlags_NavFlattened;
#else
    child->Flags |= ImGuiWindowFlags_NavFlattened;
#endif
    child->RootWindowForNav = child->ParentWindow->RootWindowForNav;
}

bool itemWasActive() { return ImGui::GetCurrentContext()->ActiveIdPreviousFrame != 0; }

bool anyPopupOpen() { return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0; }
bool dialogOpen() { return ImGui::GetTopMostPopupModal() != nullptr; }
void closePopups() {
    if (anyPopupOpen()) ImGui::ClosePopupToLevel(0, true);
}

bool checkbox(const char* label, bool& on, bool mixed) {
    ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, mixed);
    const bool changed = ImGui::Checkbox(label, &on);
    ImGui::PopItemFlag();
    return changed;
}

bool pressed(Key key, bool repeats) {
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(static_cast<ImGuiKey>(imguiKey(key)), repeats);
#else
    return ImGui::IsKeyPressed(static_cast<int>(key), repeats);  // PlatformFeed passes these codes to ImGui
#endif
}
void dropActiveItem() { ImGui::ClearActiveID(); }

bool splitterBar(const char* id, ImVec2 from, ImVec2 to, bool upright, float& before, float& after,
                 float least) {
    ImGui::PushStyleColor(ImGuiCol_Separator, ImVec4{});  // the gap is already drawn in its color
    const bool held = ImGui::SplitterBehavior(
        {from, to}, ImGui::GetID(id), upright ? ImGuiAxis_X : ImGuiAxis_Y, &before, &after, least, least);
    ImGui::PopStyleColor();
    return held;
}

int imguiKey(Key key) {
    for (const KeyPair& pair : kKeys) {
        if (pair.ours == key) return pair.theirs;
    }
    return kNone;
}

}  // namespace plumb::editor::ui
