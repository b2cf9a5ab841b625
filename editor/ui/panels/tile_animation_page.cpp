#include <optional>

#include "editor/model/tiles/tileset_edit.hpp"
#include "editor/ui/panels/tileset_panel.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/tile_picture.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kSeconds = 0.15f;  // duration of a new frame

void setFrames(Ui& ui, int tile, const std::vector<TileFrame>& frames) {
    changeTileset(ui.workspace, "animate tile", [&](Tileset& set) { tileIn(set, tile).animation = frames; });
}

void drawPreview(Ui& ui, const Tileset& tileset, int tile) {
    const float side = ui.px(56.0f);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + side, at.y + side}, palette::kCanvas);
    drawTile(ui, list, tileset, cellOf(tileset.shownTile(tile, ImGui::GetTime())),
             {{at.x, at.y}, {at.x + side, at.y + side}});
    ImGui::Dummy({side, side});
}

/// Draws one frame. @return false if the user removed it
bool drawFrame(Ui& ui, const Tileset& tileset, TileFrame& frame, std::size_t index, bool& changed) {
    ImGui::PushID(static_cast<int>(index));
    const float side = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    drawTile(ui, *ImGui::GetWindowDrawList(), tileset, cellOf(frame.tile),
             {{at.x, at.y}, {at.x + side, at.y + side}});
    ImGui::Dummy({side, side});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(format("tile {}", frame.tile).c_str());
    ImGui::SameLine(ui.px(96.0f));
    ImGui::SetNextItemWidth(ui.px(80.0f));
    auto milliseconds = static_cast<int>(frame.seconds * 1000.0f + 0.5f);
    if (ImGui::InputInt("ms", &milliseconds, 0, 0))
        frame.seconds = static_cast<float>(std::clamp(milliseconds, 1, 60000)) / 1000.0f;
    ui.widgets.mark(format("Tileset/frame/{}/ms", index), format("{}", milliseconds));
    changed |= ImGui::IsItemDeactivatedAfterEdit();
    ImGui::SameLine();
    const bool stays = !ImGui::SmallButton("x");
    ui.widgets.mark(format("Tileset/frame/{}/remove", index));
    ImGui::PopID();
    return stays;
}

class TileAnimationPage final : public TilesetPage {
public:
    void draw(Ui& ui, const Tileset& tileset, std::span<const int> chosen) override {
        if (chosen.empty()) {
            ImGui::TextWrapped("Select the tile to animate, then Shift+click its other frames in order.");
            return;
        }
        const int tile = chosen.front();
        const Tile* known = tileset.find(tile);
        const bool typing = ImGui::IsAnyItemActive() && edited_ == tile;
        if (!typing) frames_ = known == nullptr ? std::vector<TileFrame>{} : known->animation;
        edited_ = tile;
        drawPreview(ui, tileset, tile);
        ImGui::SameLine();
        ImGui::BeginGroup();
        ImGui::TextUnformatted(format("Tile {}, {} frames", tile, frames_.size()).c_str());
        ui.widgets.mark("Tileset/frames", format("{}", frames_.size()));
        const bool make = ImGui::Button("Use selected tiles as frames");
        ui.widgets.mark("Tileset/makeFrames");
        tooltip("The selected tiles, in order of selection, become the frames of the first selected tile.");
        ImGui::EndGroup();
        bool changed = false;
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            if (drawFrame(ui, tileset, frames_[i], i, changed)) continue;
            frames_.erase(frames_.begin() + static_cast<std::ptrdiff_t>(i));
            changed = true;
            break;
        }
        if (make) {
            frames_.clear();
            for (const int frame : chosen) frames_.push_back({frame, kSeconds});
            changed = true;
        }
        if (!changed) return;
        setFrames(ui, tile, frames_);
        ui.workspace.undo.endGesture();
    }

private:
    std::vector<TileFrame> frames_;  // with unfinished typing
    std::optional<int> edited_;      // tile whose frames are edited
};

}  // namespace

std::unique_ptr<TilesetPage> makeTileAnimationPage() { return std::make_unique<TileAnimationPage>(); }

}  // namespace plumb::editor::ui
