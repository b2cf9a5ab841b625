#pragma once

namespace plumb::editor::ui {

/// Draws ImGui's draw data with OpenGL. @pre the ImGui and OpenGL contexts are current
class ImguiRenderer {
public:
    ImguiRenderer();
    ~ImguiRenderer();
    ImguiRenderer(const ImguiRenderer&) = delete;
    ImguiRenderer& operator=(const ImguiRenderer&) = delete;

    /// Uploads the font texture; to be called after the fonts were loaded or scaled.
    void uploadFonts();
    void draw();
};

}  // namespace plumb::editor::ui
