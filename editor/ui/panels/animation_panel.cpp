#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "editor/model/assets/animation_edit.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/panels/state_machine_view.hpp"
#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/asset_picture.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/sheet_cell.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kSideWidth = 200.0f;  // px at scale 1
constexpr float kNarrow = 480.0f;
constexpr float kPreviewWidth = 190.0f;
constexpr float kFrameSide = 46.0f;
constexpr std::array kLoops{"loop", "once", "back and forth"};

/// Cuts a sprite sheet into cells, and edits clips made of the cells and a state machine that selects clips.
class AnimationPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        if (!edit_) {
            edit_ = std::make_unique<AnimationEdit>(ui.workspace);
            states_ = std::make_unique<StateMachineView>(*edit_);
        }
        if (const std::string wanted = std::exchange(ui.workspace.assetToEdit, {}); !wanted.empty())
            take(ui, wanted);
        if (edit_->path().empty()) return drawNothing(ui);
        clip_ = std::clamp(clip_, 0, std::max(static_cast<int>(edit_->set().clips.size()) - 1, 0));
        // In a narrow panel the parts are placed below each other.
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const bool narrow = room.x < ui.px(kNarrow);
        beginChild("clips", narrow ? ImVec2{0.0f, room.y * 0.35f} : ImVec2{ui.px(kSideWidth), 0.0f}, false);
        drawFile(ui);
        if (graph_) {
            states_->drawParameters(ui);
        } else {
            drawSheetSettings(ui);
        }
        drawClips(ui);
        ImGui::EndChild();
        if (!narrow) ImGui::SameLine();
        if (!graph_) {  // the graph uses the space of frames and sheet
            beginChild("middle", narrow ? ImVec2{0.0f, room.y * 0.35f} : ImVec2{-ui.px(kPreviewWidth), 0.0f},
                       false);
            drawFrames(ui);
            drawSheet(ui);
            ImGui::EndChild();
            if (!narrow) ImGui::SameLine();
        }
        beginChild("preview", {0.0f, 0.0f}, false);
        drawPreview(ui);
        ImGui::EndChild();
    }

private:
    void take(Ui& ui, const std::string& path) {
        const std::string problem = edit_->open(path);
        if (!problem.empty()) ui.workspace.notice = problem;
        clip_ = 0;
        graph_ = false;
        states_->begin();
    }

    void drawNothing(Ui& ui) {
        emptyState(ui, "Animation", "No animation is open.",
                   "Double-click an animation in the Assets panel, or drop an animation or an image here. An "
                   "image becomes a sprite sheet of equal cells; clips are made of its cells.");
        ImGui::InvisibleButton("drop", ImGui::GetContentRegionAvail());
        ui.widgets.mark("Animation/drop");
        if (const std::string dropped = acceptAsset(hovering_); !dropped.empty()) take(ui, dropped);
    }

    void drawFile(Ui& ui) const {
        ImGui::TextUnformatted(edit_->path().substr(edit_->path().rfind('/') + 1).c_str());
        ui.widgets.mark("Animation/file", edit_->path());
        tooltip(edit_->path());
    }

    void drawSheetSettings(Ui& ui) {
        const AnimationSet& set = edit_->set();
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("Cell");
        ImGui::SameLine(ui.px(40.0f));
        std::array cells{set.frameWidth, set.frameHeight};
        ImGui::SetNextItemWidth(-1.0f);
        ImGui::InputInt2("##cells", cells.data());
        ui.widgets.mark("Animation/cells", format("{} x {}", set.frameWidth, set.frameHeight));
        if (ImGui::IsItemDeactivatedAfterEdit()) edit_->setCells({cells[0], cells[1]});
        tooltip("Width and height of a cell of the sheet (px)");
        if (ImGui::Button("Find cells") && !edit_->detectCells())
            ui.workspace.notice = "No regular grid found in this sheet; enter the cell size by hand";
        ui.widgets.mark("Animation/find");
        tooltip("Detects the cell size: the smallest regular grid whose lines cross only transparent pixels");
        ImGui::SameLine();
        if (ImGui::Button("Clip of all")) edit_->addClipOfAll(), clip_ = 1 << 20;
        ui.widgets.mark("Animation/all");
        tooltip("Adds a clip of all cells that are not empty");
        ImGui::Separator();
    }

    void drawClips(Ui& ui) {
        const auto& clips = edit_->set().clips;
        ImGui::TextDisabled("Clips");
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ui.px(58.0f));
        if (ImGui::SmallButton(" + ")) edit_->addClip(), clip_ = 1 << 20;
        ui.widgets.mark("Animation/addClip");
        ImGui::SameLine();
        if (ImGui::SmallButton(" - ")) edit_->removeClip(clip_);
        ui.widgets.mark("Animation/removeClip");
        for (int i = 0; i < static_cast<int>(clips.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(clips[static_cast<std::size_t>(i)].name.c_str(), i == clip_))
                clip_ = i, since_ = ImGui::GetTime();
            ui.widgets.mark(format("Animation/clip/{}", clips[static_cast<std::size_t>(i)].name));
            ImGui::PopID();
        }
        if (clip_ >= static_cast<int>(clips.size())) return;
        const Animation& clip = clips[static_cast<std::size_t>(clip_)];
        ImGui::Separator();
        if (named_ != clip.name) name_ = named_ = clip.name;
        ImGui::SetNextItemWidth(-1.0f);
        textField("##name", name_);
        ui.widgets.mark("Animation/name", clip.name);
        if (ImGui::IsItemDeactivatedAfterEdit()) edit_->renameClip(clip_, name_), named_.clear();
        ImGui::SetNextItemWidth(-1.0f);
        int loop = static_cast<int>(edit_->set().clips[static_cast<std::size_t>(clip_)].loop);
        if (ImGui::Combo("##loop", &loop, kLoops.data(), static_cast<int>(kLoops.size())))
            edit_->setLoop(clip_, static_cast<LoopMode>(loop));
        ui.widgets.mark("Animation/loop");
    }

    [[nodiscard]] const Animation* clip() const {
        const auto& clips = edit_->set().clips;
        return clip_ < static_cast<int>(clips.size()) ? &clips[static_cast<std::size_t>(clip_)] : nullptr;
    }

    /// Draws the frames of the clip in order, and marks the frame that is playing.
    void drawFrames(Ui& ui) {
        const Animation* shown = clip();
        if (shown == nullptr) {
            ImGui::TextDisabled("Add a clip, then click cells of the sheet to put them into it.");
            return;
        }
        const Animation now = *shown;
        const int playing = frameAt(now, ImGui::GetTime() - since_);
        beginChild("frames", {0.0f, ui.px(kFrameSide + 40.0f)}, false, ImGuiWindowFlags_HorizontalScrollbar);
        const float side = ui.px(kFrameSide);
        for (int i = 0; i < static_cast<int>(now.frames.size()); ++i) {
            const AnimationFrame& frame = now.frames[static_cast<std::size_t>(i)];
            ImGui::PushID(i);
            ImGui::BeginGroup();
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::InvisibleButton("frame", {side, side});
            ui.widgets.mark(format("Animation/frame/{}", i));
            if (ImGui::IsItemClicked(1)) edit_->removeFrame(clip_, i);
            dragFrame(i);
            tooltip("Drag to reorder; right-click to remove");
            const AABB box{{at.x, at.y}, {at.x + side, at.y + side}};
            ImGui::GetWindowDrawList()->AddRectFilled(at, {box.max.x, box.max.y}, palette::kCanvas);
            drawSheetCell(ui, *edit_, frame, box);
            outline(*ImGui::GetWindowDrawList(), at, {box.max.x, box.max.y},
                    i == playing ? palette::kAccent : palette::kCellLine);
            float ms = frame.seconds * 1000.0f;
            ImGui::SetNextItemWidth(side);
            ImGui::DragFloat("##ms", &ms, 1.0f, 1.0f, 10000.0f, "%.0f", ImGuiSliderFlags_AlwaysClamp);
            ui.widgets.mark(format("Animation/ms/{}", i), shortestText(ms));
            tooltip("Duration of the frame, ms");
            if (ImGui::IsItemActive()) held_ = ms;
            if (ImGui::IsItemDeactivatedAfterEdit()) edit_->setSeconds(clip_, i, held_ / 1000.0f);
            ImGui::EndGroup();
            ImGui::SameLine();
            ImGui::PopID();
        }
        ImGui::EndChild();
    }

    void dragFrame(int index) {
        if (ImGui::BeginDragDropSource()) {
            ImGui::SetDragDropPayload("frame", &index, sizeof index);
            ImGui::Text("Frame %d", index + 1);
            ImGui::EndDragDropSource();
        }
        if (!ImGui::BeginDragDropTarget()) return;
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload("frame"))
            edit_->moveFrame(clip_, *static_cast<const int*>(payload->Data), index);
        ImGui::EndDragDropTarget();
    }

    /// Draws the whole sheet with its cells; a click appends a cell to the clip.
    void drawSheet(Ui& ui) {
        const AnimationSet& set = edit_->set();
        const Image& sheet = edit_->sheet();
        if (sheet.empty() || set.frameWidth <= 0 || set.frameHeight <= 0) {
            ImGui::TextWrapped(set.image.empty() ? "This animation has no sheet."
                                                 : "Enter the cell size, or click \"Find cells\".");
            return;
        }
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const Vec2 whole{static_cast<float>(sheet.width), static_cast<float>(sheet.height)};
        const float fit = std::min(std::max(room.x, 32.0f) / whole.x, std::max(room.y, 32.0f) / whole.y);
        const float zoom = fit > 1.0f ? std::floor(fit) : fit;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("sheet", {whole.x * zoom, whole.y * zoom});
        ui.widgets.mark("Animation/sheet");
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 end{at.x + whole.x * zoom, at.y + whole.y * zoom};
        list.AddRectFilled(at, end, palette::kCanvas);
        if (ui.picture != nullptr) {
            const TexturePart part = ui.picture->part(set.texture, {});
            quadOfPixels(list, textureId(part.texture), {at, ImVec2{end.x, at.y}, end, ImVec2{at.x, end.y}},
                         {part.from, Vec2{part.to.x, part.from.y}, part.to, Vec2{part.from.x, part.to.y}},
                         IM_COL32_WHITE);
        }
        const Vec2 cell{static_cast<float>(set.frameWidth) * zoom,
                        static_cast<float>(set.frameHeight) * zoom};
        for (int x = 0; x <= edit_->columns(); ++x)
            list.AddLine({at.x + static_cast<float>(x) * cell.x, at.y},
                         {at.x + static_cast<float>(x) * cell.x, end.y}, palette::kCellLine);
        for (int y = 0; y <= edit_->rows(); ++y)
            list.AddLine({at.x, at.y + static_cast<float>(y) * cell.y},
                         {end.x, at.y + static_cast<float>(y) * cell.y}, palette::kCellLine);
        if (!ImGui::IsItemHovered()) return;
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const int x = std::clamp(static_cast<int>((mouse.x - at.x) / cell.x), 0, edit_->columns() - 1);
        const int y = std::clamp(static_cast<int>((mouse.y - at.y) / cell.y), 0, edit_->rows() - 1);
        const ImVec2 corner{at.x + static_cast<float>(x) * cell.x, at.y + static_cast<float>(y) * cell.y};
        outline(list, corner, {corner.x + cell.x, corner.y + cell.y}, palette::kAccent, 0.0f, 2.0f);
        tooltip(format("Column {}, row {}: click to add this cell to the clip", x, y));
        if (ImGui::IsMouseClicked(0)) edit_->addFrame(clip_, x, y);
    }

    void drawPreview(Ui& ui) {
        if (ImGui::RadioButton("Preview", !graph_)) graph_ = false;
        ui.widgets.mark("Animation/preview");
        ImGui::SameLine();
        if (ImGui::RadioButton("States", graph_)) graph_ = true;
        ui.widgets.mark("Animation/states");
        if (graph_) return states_->drawGraph(ui, clip_);
        const Animation* shown = clip();
        if (shown == nullptr || shown->frames.empty()) return;
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 room = ImGui::GetContentRegionAvail();
        const int index = frameAt(*shown, ImGui::GetTime() - since_);
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + room.x, at.y + room.y}, palette::kCanvas);
        drawSheetCell(ui, *edit_, shown->frames[static_cast<std::size_t>(index)],
                      {{at.x, at.y}, {at.x + room.x, at.y + room.y}});
        ImGui::InvisibleButton("picture", {std::max(room.x, 1.0f), std::max(room.y, 1.0f)});
        ui.widgets.mark("Animation/picture", format("{}", index));
        if (ImGui::IsItemClicked()) since_ = ImGui::GetTime();
        tooltip("Click to play from the start");
    }

    std::unique_ptr<AnimationEdit> edit_;
    std::unique_ptr<StateMachineView> states_;
    int clip_ = 0;
    bool graph_ = false;
    double since_ = 0.0;
    float held_ = 0.0f;  ///< frame duration being dragged, ms
    std::string name_;
    std::string named_;
    std::string hovering_;
};

}  // namespace

std::unique_ptr<Panel> makeAnimationPanel() { return std::make_unique<AnimationPanel>(); }

}  // namespace plumb::editor::ui
