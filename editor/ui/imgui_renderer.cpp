#include "editor/ui/imgui_renderer.hpp"

#include <imgui.h>
#if __has_include(<backends/imgui_impl_opengl3.h>)
#include <backends/imgui_impl_opengl3.h>
#else
#include <imgui_impl_opengl3.h>
#endif

namespace plumb::editor::ui {

ImguiRenderer::ImguiRenderer() {
    ImGui_ImplOpenGL3_Init("#version 330");
    ImGui_ImplOpenGL3_NewFrame();
}

ImguiRenderer::~ImguiRenderer() { ImGui_ImplOpenGL3_Shutdown(); }

void ImguiRenderer::uploadFonts() {
#if IMGUI_VERSION_NUM < 19200
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void ImguiRenderer::draw() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace plumb::editor::ui
