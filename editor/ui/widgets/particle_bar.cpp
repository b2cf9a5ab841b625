#include "editor/ui/widgets/particle_bar.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "editor/ui/ui_compat.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

constexpr Color kShape{232, 200, 120, 200};
constexpr float kSecondsShown = 0.35f;  // s of a particle's flight that a direction line covers
constexpr float kShortest = 12.0f;      // px, minimum length of an arrow

void drawArea(const ParticleEmitter& emitter, const Pose& pose, Overlay& overlay) {
    if (emitter.area == EmitterArea::Circle) {
        overlay.circle(pose.position, emitter.areaRadius * std::fabs(pose.scale.x), kShape);
    } else if (emitter.area == EmitterArea::Box) {
        const Vec2 half = emitter.areaSize * 0.5f;
        const Vec2 corners[] = {-half, {half.x, -half.y}, half, {-half.x, half.y}};
        const auto at = [&](int i) {
            return pose.position + rotated(scaled(corners[i % 4], pose.scale), pose.rotation);
        };
        for (int i = 0; i < 4; ++i) overlay.line(at(i), at(i + 1), kShape);
    }
}

void drawFan(const ParticleEmitter& emitter, const Pose& pose, Overlay& overlay) {
    const float reach = std::max(std::fabs(emitter.speed) * kSecondsShown, kShortest);
    const float turned = emitter.direction + pose.rotation + (emitter.speed < 0.0f ? kPi : 0.0f);
    const auto along = [&](float angle) {
        const SinCos way = sinCos(turned + angle);
        return pose.position + Vec2{way.cos, way.sin} * reach;
    };
    overlay.arrow(pose.position, along(0.0f), kShape);
    if (emitter.spread <= 0.01f || emitter.spread >= kTau - 0.01f) return;
    overlay.line(pose.position, along(-emitter.spread * 0.5f), kShape);
    overlay.line(pose.position, along(emitter.spread * 0.5f), kShape);
}

}  // namespace

void advancePreview(const Ui& ui, ParticlePreview& preview) {
    if (ui.workspace.play.running() || ui.workspace.document.scenePath.empty()) return preview.clear();
    preview.advance(ui.workspace.document, double{ImGui::GetIO().DeltaTime});
}

void drawEmitterShapes(const World& world, const ParticlePreview& preview, Overlay& overlay) {
    for (const EntityId entity : preview.emitters()) {
        const auto* emitter = world.find<ParticleEmitter>(entity);
        if (emitter == nullptr) continue;
        const Pose pose = worldPose(world, entity);
        drawArea(*emitter, pose, overlay);
        drawFan(*emitter, pose, overlay);
    }
}

void drawParticleBar(Ui& ui, ParticlePreview& preview, ImVec2 from, ImVec2 size) {
    if (!preview.shows()) return;
    const std::string count = format("{} particles", preview.particles().alive());
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto button = [&](const char* label) {
        return ImGui::CalcTextSize(label).x + style.FramePadding.x * 2.0f;
    };
    const float gap = ui.px(6.0f);
    const float margin = ui.px(8.0f);
    // Wide enough for the largest count, so that the buttons do not move.
    const float words = ImGui::CalcTextSize("100000 particles").x;
    const float width = margin * 2.0f + words + gap * 2.0f + button("Restart") + button("Burst");
    const float height = ImGui::GetFrameHeight() + margin;
    if (size.x < width || size.y < height * 3.0f) return;
    const ImVec2 at{from.x + std::floor((size.x - width) * 0.5f), from.y + size.y - height - margin};
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPopup);
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, ui.px(5.0f));
    beginChild("particles", {width, height}, false,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPos({margin, margin * 0.5f});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(count.c_str());
    ui.widgets.mark("Viewport/particles", format("{}", preview.particles().alive()));
    tooltip("Preview of the selected emitters. The scene is not changed.");
    ImGui::SameLine(margin + words + gap, 0.0f);
    if (ImGui::Button("Restart")) preview.restart();
    ui.widgets.mark("Viewport/particles/restart");
    tooltip("Restarts the preview as at the start of the game");
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("Burst")) preview.burst(ui.workspace.document);
    ui.widgets.mark("Viewport/particles/burst");
    tooltip("Emits the burst of the emitter; if it has none, a few particles");
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
}

}  // namespace plumb::editor::ui
