#include "platform/window.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <SDL.h>

#include "core/log.hpp"
#include "platform/event_translation.hpp"
#include "platform/gl_context.hpp"
#include "platform/gl_profile.hpp"

namespace plumb {
namespace {

// In the order of MouseShape.
constexpr std::array kCursors{SDL_SYSTEM_CURSOR_ARROW,    SDL_SYSTEM_CURSOR_HAND,   SDL_SYSTEM_CURSOR_IBEAM,
                              SDL_SYSTEM_CURSOR_SIZEALL,  SDL_SYSTEM_CURSOR_SIZEWE, SDL_SYSTEM_CURSOR_SIZENS,
                              SDL_SYSTEM_CURSOR_SIZENWSE, SDL_SYSTEM_CURSOR_NO};

/// Initializes SDL's video; falls back to its driver without a display, which draws into memory.
Result<Done> startVideo() {
    SDL_SetMainReady();
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) == 0) return Done{};
    const std::string reason = SDL_GetError();
    if (std::getenv("SDL_VIDEODRIVER") == nullptr) {
        SDL_SetHint(SDL_HINT_VIDEODRIVER, "offscreen");
        if (SDL_InitSubSystem(SDL_INIT_VIDEO) == 0) return Done{};
    }
    return Error{"window", "no video driver works: " + reason,
                 "start it on a desktop, or set SDL_VIDEODRIVER=offscreen to draw into memory"};
}

Uint32 windowFlags(const WindowSettings& settings) {
    Uint32 flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI;
    if (settings.resizable) flags |= SDL_WINDOW_RESIZABLE;
    if (settings.fullscreen) flags |= SDL_WINDOW_FULLSCREEN_DESKTOP;
    if (settings.hidden) flags |= SDL_WINDOW_HIDDEN;
    return flags;
}

bool drawsIntoMemory() {
    const char* driver = SDL_GetCurrentVideoDriver();
    return driver == nullptr || std::strcmp(driver, "offscreen") == 0 || std::strcmp(driver, "dummy") == 0;
}

}  // namespace

struct Window::Parts {
    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        for (SDL_Cursor* cursor : cursors) {
            if (cursor != nullptr) SDL_FreeCursor(cursor);
        }
        translation.reset();
        context = GlContext{};
        if (window != nullptr) SDL_DestroyWindow(window);
        SDL_QuitSubSystem(SDL_INIT_VIDEO | (hasPads ? SDL_INIT_GAMECONTROLLER : 0u));
    }

    SDL_Window* window = nullptr;
    bool hasPads = false;
    bool triedPads = false;
    GlContext context;
    std::optional<EventTranslation> translation;
    std::array<SDL_Cursor*, kCursors.size()> cursors{};
};

Window::Window(std::unique_ptr<Parts> parts) : parts_{std::move(parts)} {}
Window::~Window() = default;

Result<std::unique_ptr<Window>> Window::open(const WindowSettings& settings) {
    if (const Result<Done> started = startVideo(); !started) return started.error();
    auto parts = std::make_unique<Parts>();
    parts->translation.emplace();
    requestGlProfile();
    parts->window = SDL_CreateWindow(settings.title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                     settings.width, settings.height, windowFlags(settings));
    if (parts->window == nullptr) {
        return Error{"window", SDL_GetError(),
                     "set SDL_VIDEODRIVER=offscreen to draw into memory without a display"};
    }
    Result<GlContext> context = GlContext::create(parts->window);
    if (!context) return context.error();
    parts->context = std::move(*context);
    parts->context.setVsync(settings.vsync);
    if (drawsIntoMemory() && !settings.hidden) {
        logNote("Engine", "No display: drawing into memory (SDL driver {})", SDL_GetCurrentVideoDriver());
    }
    return std::unique_ptr<Window>{new Window{std::move(parts)}};
}

void Window::pollEvents(std::vector<Event>& events) {
    SDL_Event next;
    while (SDL_PollEvent(&next) != 0) {
        if (std::optional<Event> event = parts_->translation->translate(next))
            events.push_back(std::move(*event));
    }
}

void Window::waitEvents(std::vector<Event>& events, double seconds) {
    SDL_WaitEventTimeout(nullptr, static_cast<int>(seconds * 1000.0));
    pollEvents(events);
}

void Window::openPads() {
    if (std::exchange(parts_->triedPads, true)) return;
    parts_->hasPads = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    if (!parts_->hasPads) logNote("Input", "No gamepads: {}", SDL_GetError());
}

void Window::swap() { SDL_GL_SwapWindow(parts_->window); }
void Window::setVsync(bool on) { parts_->context.setVsync(on); }

PixelSize Window::size() const {
    PixelSize size;
    SDL_GetWindowSize(parts_->window, &size.width, &size.height);
    return size;
}

PixelSize Window::drawableSize() const {
    PixelSize size;
    SDL_GL_GetDrawableSize(parts_->window, &size.width, &size.height);
    return size;
}

bool Window::hasFocus() const { return (SDL_GetWindowFlags(parts_->window) & SDL_WINDOW_INPUT_FOCUS) != 0; }
bool Window::hasDisplay() const { return !drawsIntoMemory(); }

void Window::setTitle(const std::string& title) { SDL_SetWindowTitle(parts_->window, title.c_str()); }
void Window::setSize(int width, int height) {
    const PixelSize before = size();
    SDL_SetWindowSize(parts_->window, width, height);
    SDL_Rect area{};
    const int display = hasDisplay() ? SDL_GetWindowDisplayIndex(parts_->window) : -1;
    if (display < 0 || SDL_GetDisplayUsableBounds(display, &area) != 0) return;
    int x = 0, y = 0;
    SDL_GetWindowPosition(parts_->window, &x, &y);
    const int left = std::max(area.x, std::min(x + (before.width - width) / 2, area.x + area.w - width));
    const int top = std::max(area.y, std::min(y + (before.height - height) / 2, area.y + area.h - height));
    if (left != x || top != y) SDL_SetWindowPosition(parts_->window, left, top);
}
PixelSize Window::largestSize() const {
    SDL_Rect area{};
    const int display = hasDisplay() ? SDL_GetWindowDisplayIndex(parts_->window) : -1;
    if (display < 0 || SDL_GetDisplayUsableBounds(display, &area) != 0) return {};
    return {area.w, area.h};
}
void Window::setFullscreen(bool on) {
    SDL_SetWindowFullscreen(parts_->window, on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}
bool Window::fullscreen() const {
    return (SDL_GetWindowFlags(parts_->window) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
           SDL_WINDOW_FULLSCREEN_DESKTOP;
}

void Window::setMouseShape(MouseShape shape) {
    const auto index = static_cast<std::size_t>(shape);
    SDL_Cursor*& cursor = parts_->cursors[index];
    if (cursor == nullptr) cursor = SDL_CreateSystemCursor(kCursors[index]);
    if (cursor != nullptr) SDL_SetCursor(cursor);
}
void Window::setMouseVisible(bool visible) { SDL_ShowCursor(visible ? SDL_ENABLE : SDL_DISABLE); }

std::string Window::clipboardText() const {
    char* text = SDL_GetClipboardText();
    std::string copy = text != nullptr ? text : "";
    SDL_free(text);
    return copy;
}
void Window::setClipboardText(const std::string& text) { SDL_SetClipboardText(text.c_str()); }

}  // namespace plumb
