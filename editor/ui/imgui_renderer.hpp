#pragma once

namespace plumb::editor::ui {

/// Puts what ImGui made on the screen, with OpenGL. @pre contexts of both are current
class ImguiRenderer {
public:
    ImguiRenderer();
    ~ImguiRenderer();
    ImguiRenderer(const ImguiRenderer&) = delete;
    ImguiRenderer& operator=(const ImguiRenderer&) = delete;

    /// After the fonts were loaded or scaled.
    void uploadFonts();
    void draw();
};

}  // namespace plumb::editor::ui
