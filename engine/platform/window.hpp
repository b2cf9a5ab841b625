#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "platform/events.hpp"

namespace plumb {

struct WindowSettings {
    std::string title = "Plumb";
    int width = 1280;  ///< px
    int height = 720;  ///< px
    bool resizable = true;
    bool fullscreen = false;
    bool hidden = false;  ///< for tests and tools: rendered, never shown
    bool vsync = true;
};

/// A size in whole pixels.
struct PixelSize {
    int width = 0;
    int height = 0;

    friend bool operator==(PixelSize, PixelSize) = default;
};

enum class MouseShape : unsigned char {
    Arrow,
    Hand,
    Text,
    Move,
    SizeHorizontal,
    SizeVertical,
    SizeDiagonal,
    Forbidden
};

/// A window with an OpenGL 3.3 core context, current on the thread that opened it; also the source of
/// events. Without a display it renders into memory and logs a note, so servers need no X server.
class Window {
public:
    /// @error no video driver, no OpenGL 3.3
    static Result<std::unique_ptr<Window>> open(const WindowSettings& settings);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Appends the events since the last call to `events`, oldest first.
    void pollEvents(std::vector<Event>& events);
    /// Like pollEvents(), but waits up to `seconds` if there are no events yet.
    void waitEvents(std::vector<Event>& events, double seconds);

    /// Opens gamepads and reports their events from now on. Calling it once is enough.
    void openPads();

    /// Shows the rendered frame. Its pixels are undefined afterwards, so read them before.
    void swap();
    void setVsync(bool on);

    [[nodiscard]] PixelSize size() const;          ///< in the units of mouse positions
    [[nodiscard]] PixelSize drawableSize() const;  ///< in pixels: larger than size() on dense screens
    /// Largest size() for which the window without its frame fits on its display; {} if that is unknown.
    [[nodiscard]] PixelSize largestSize() const;
    [[nodiscard]] bool hasFocus() const;
    [[nodiscard]] bool hasDisplay() const;  ///< false if it only draws into memory

    void setTitle(const std::string& title);
    /// The window keeps its centre unless it would leave its display.
    void setSize(int width, int height);
    void setFullscreen(bool on);
    [[nodiscard]] bool fullscreen() const;
    void setMouseShape(MouseShape shape);
    void setMouseVisible(bool visible);

    [[nodiscard]] std::string clipboardText() const;
    void setClipboardText(const std::string& text);

private:
    struct Parts;
    explicit Window(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

}  // namespace plumb
