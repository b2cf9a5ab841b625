#include "editor/ui/platform_feed.hpp"

#include <algorithm>

#include "editor/ui/ui_compat.hpp"

namespace plumb::editor::ui {
namespace {

bool changesKeyOrButton(const Event& event) {
    switch (event.kind) {
        case EventKind::KeyDown: return !event.repeated;
        case EventKind::KeyUp:
        case EventKind::MouseDown:
        case EventKind::MouseUp: return true;
        default: return false;
    }
}

bool sameKeyOrButton(const Event& a, const Event& b) {
    const auto ofKey = [](const Event& event) {
        return event.kind == EventKind::KeyDown || event.kind == EventKind::KeyUp;
    };
    if (ofKey(a) != ofKey(b)) return false;
    return ofKey(a) ? a.key == b.key : a.mouseButton == b.mouseButton;
}

int buttonIndex(MouseButton button) {
    // ImGui's order of buttons is left, right, middle.
    switch (button) {
        case MouseButton::Left: return 0;
        case MouseButton::Right: return 1;
        case MouseButton::Middle: return 2;
        case MouseButton::X1: return 3;
        default: return 4;
    }
}

}  // namespace

PlatformFeed::PlatformFeed() {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendPlatformName = "plumb";
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
#if IMGUI_VERSION_NUM < 18700
    for (std::size_t i = 0; i < kKeyCount; ++i) {
        const int key = imguiKey(static_cast<Key>(i));
        if (key >= 0) io.KeyMap[key] = static_cast<int>(i);
    }
#endif
}

std::span<const Event> PlatformFeed::beginFrame(const FrameInput& input) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(input.size.width), static_cast<float>(input.size.height)};
    if (input.size.width > 0 && input.size.height > 0) {
        io.DisplayFramebufferScale = {
            static_cast<float>(input.drawable.width) / static_cast<float>(input.size.width),
            static_cast<float>(input.drawable.height) / static_cast<float>(input.size.height)};
    }
    io.DeltaTime = std::max(input.seconds, 1e-4f);

    waiting_.insert(waiting_.end(), input.events.begin(), input.events.end());
    now_.clear();
    while (!waiting_.empty()) {
        const Event& next = waiting_.front();
        const bool again =
            changesKeyOrButton(next) && std::any_of(now_.begin(), now_.end(), [&](const Event& event) {
                return changesKeyOrButton(event) && sameKeyOrButton(event, next);
            });
        // A move after a press belongs to the next frame, so that the press keeps its position.
        const bool movesAfterPress =
            next.kind == EventKind::MouseMoved &&
            std::any_of(now_.begin(), now_.end(), [](const Event& event) {
                return event.kind == EventKind::MouseDown || event.kind == EventKind::MouseUp;
            });
        if (again || movesAfterPress) break;
        feed(next);
        now_.push_back(next);
        waiting_.pop_front();
    }
    return now_;
}

void PlatformFeed::feed(const Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
        case EventKind::FocusLost: releaseAll(); break;
        case EventKind::KeyDown:
        case EventKind::KeyUp:
            modifiers_ = event.modifiers;
            feedModifiers();
            feedKey(event.key, event.kind == EventKind::KeyDown);
            break;
        case EventKind::TextInput: io.AddInputCharactersUTF8(event.text.c_str()); break;
        case EventKind::MouseMoved: mouse_ = event.position;
#if IMGUI_VERSION_NUM >= 18700
            io.AddMousePosEvent(mouse_.x, mouse_.y);
#else
            io.MousePos = {mouse_.x, mouse_.y};
#endif
            break;
        case EventKind::MouseDown:
        case EventKind::MouseUp:
            modifiers_ = event.modifiers;
            feedModifiers();
            feedButton(event.mouseButton, event.kind == EventKind::MouseDown);
            break;
        case EventKind::MouseWheel: modifiers_ = event.modifiers; feedModifiers();
#if IMGUI_VERSION_NUM >= 18700
            io.AddMouseWheelEvent(event.motion.x, event.motion.y);
#else
            io.MouseWheelH += event.motion.x;
            io.MouseWheel += event.motion.y;
#endif
            break;
        default: break;
    }
}

void PlatformFeed::feedKey(Key key, bool down) {
    keys_[static_cast<std::size_t>(key)] = down;
    // Outside of text fields and dialogs Tab hides the panels, so that ImGui must not move the focus.
    if (key == Key::Tab && down && !ImGui::GetIO().WantTextInput && !dialogOpen()) return;
#if IMGUI_VERSION_NUM >= 18700
    const auto theirs = static_cast<ImGuiKey>(imguiKey(key));
    if (theirs != ImGuiKey_None) ImGui::GetIO().AddKeyEvent(theirs, down);
#else
    ImGui::GetIO().KeysDown[static_cast<std::size_t>(key)] = down;
#endif
}

void PlatformFeed::feedButton(MouseButton button, bool down) {
    buttons_[static_cast<std::size_t>(button)] = down;
#if IMGUI_VERSION_NUM >= 18700
    ImGui::GetIO().AddMouseButtonEvent(buttonIndex(button), down);
#else
    ImGui::GetIO().MouseDown[buttonIndex(button)] = down;
#endif
}

void PlatformFeed::feedModifiers() {
    ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
    io.AddKeyEvent(ImGuiMod_Ctrl, modifiers_.control);
    io.AddKeyEvent(ImGuiMod_Shift, modifiers_.shift);
    io.AddKeyEvent(ImGuiMod_Alt, modifiers_.alt);
#elif IMGUI_VERSION_NUM >= 18700
    io.AddKeyEvent(ImGuiKey_ModCtrl, modifiers_.control);
    io.AddKeyEvent(ImGuiKey_ModShift, modifiers_.shift);
    io.AddKeyEvent(ImGuiKey_ModAlt, modifiers_.alt);
#else
    io.KeyCtrl = modifiers_.control;
    io.KeyShift = modifiers_.shift;
    io.KeyAlt = modifiers_.alt;
#endif
}

void PlatformFeed::releaseAll() {
    for (std::size_t i = 0; i < kKeyCount; ++i) {
        if (keys_[i]) feedKey(static_cast<Key>(i), false);
    }
    for (std::size_t i = 0; i < kMouseButtonCount; ++i) {
        if (buttons_[i]) feedButton(static_cast<MouseButton>(i), false);
    }
    modifiers_ = {};
    feedModifiers();
}

}  // namespace plumb::editor::ui
