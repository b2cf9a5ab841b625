#include <algorithm>
#include <cmath>
#include <functional>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "editor/model/assets/asset_browser.hpp"
#include "editor/model/assets/place_asset.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/ui/dialogs/image_dialog.hpp"
#include "editor/ui/dialogs/import_dialog.hpp"
#include "editor/ui/panels/panels.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/asset_mark.hpp"
#include "editor/ui/widgets/asset_picture.hpp"
#include "editor/ui/widgets/dialog.hpp"
#include "editor/ui/widgets/empty_state.hpp"
#include "editor/ui/widgets/text_field.hpp"

namespace plumb::editor::ui {
namespace {

constexpr float kTreeWidth = 170.0f;  // px at scale 1
constexpr float kPictureSide = 76.0f;
constexpr float kLeastSide = 48.0f;  // px at scale 1: smallest thumbnail side
constexpr float kMostSide = 124.0f;
constexpr float kBetween = 12.0f;   // px at scale 1, between thumbnails
constexpr double kLookAgain = 0.5;  // s, between two reads of the folder

/// Shortens a name to a width by replacing its middle with "..", as beginning and end distinguish names best.
std::string fitted(std::string_view name, float width) {
    if (ImGui::CalcTextSize(name.data(), name.data() + name.size()).x <= width) return std::string{name};
    std::string text;
    for (std::size_t keep = name.size(); keep > 2; --keep) {
        text = std::string{name.substr(0, (keep + 1) / 2)} + ".." +
               std::string{name.substr(name.size() - keep / 2)};
        if (ImGui::CalcTextSize(text.c_str()).x <= width) break;
    }
    return text;
}

/// Size of the thumbnails and their number per row.
struct Rows {
    float side;  // px
    int columns;
};

/// Returns the default thumbnail size if all rows fit, else a size at which a whole number of rows fits.
/// @param room   available space, px
/// @param below  distance from a thumbnail's lower edge to the next row, px
Rows rowsFitting(std::size_t items, ImVec2 room, float below, const Ui& ui) {
    const auto across = [&](float side) {
        return std::max(static_cast<int>((room.x + ui.px(kBetween)) / (side + ui.px(kBetween))), 1);
    };
    const float usual = ui.px(kPictureSide);
    const int rows = (static_cast<int>(items) + across(usual) - 1) / across(usual);
    if (static_cast<float>(rows) * (usual + below) <= room.y) return {usual, across(usual)};
    const float seen = std::max(std::floor(room.y / (ui.px(kLeastSide) + below)), 1.0f);
    const float side = std::clamp(std::floor(room.y / seen - below), ui.px(kLeastSide), ui.px(kMostSide));
    return {side, across(side)};
}

/// File browser of the project: search, drag into the scene, rename, delete.
class AssetsPanel final : public Panel {
public:
    void draw(Ui& ui) override {
        AssetBrowser& browser = browserOf(ui);
        if (const double now = ImGui::GetTime(); now >= nextLook_) {
            browser.refresh();
            nextLook_ = now + kLookAgain;
        }
        if (!ui.workspace.assetToShow.empty()) show(browser, std::exchange(ui.workspace.assetToShow, {}));
        drawBar(ui, browser);
        beginChild("folders", {ui.px(kTreeWidth), 0.0f}, false);
        drawFolder(ui, browser, "");
        ImGui::EndChild();
        ImGui::SameLine();
        beginChild("files", {0.0f, 0.0f}, false);
        drawFiles(ui, browser);
        ImGui::EndChild();
        drawRename(ui, browser);
        drawDelete(ui, browser);
        image_.draw(ui, browser);
    }

private:
    AssetBrowser& browserOf(Ui& ui) {
        if (!browser_) browser_ = std::make_unique<AssetBrowser>(ui.workspace);
        return *browser_;
    }

    static void show(AssetBrowser& browser, const std::string& path) {
        browser.refresh();
        browser.search.clear();
        browser.enter(path.substr(0, path.find('/') == std::string::npos ? 0 : path.rfind('/')));
        browser.selected = path;
    }

    void drawBar(Ui& ui, AssetBrowser& browser) {
        ImGui::SetNextItemWidth(ui.px(kTreeWidth));
        if (textField("##search", browser.search, 0, "Search")) browser.selected.clear();
        ui.widgets.mark("Assets/search", browser.search);
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        const std::string place = !browser.search.empty()  ? "search results in the whole project"
                                  : browser.folder.empty() ? ui.workspace.project.name
                                                           : browser.folder;
        ImGui::TextDisabled("%s", place.c_str());
        ImGui::SameLine(ImGui::GetWindowWidth() - ui.px(90.0f));
        if (ImGui::Button("Import...")) runAction(ui.workspace, "file.import");
        ui.widgets.mark("Assets/Import");
        tooltip("Imports a Tiled map, an LDtk project or an Aseprite sheet");
    }

    void drawFolder(Ui& ui, AssetBrowser& browser, const std::string& folder) {
        const std::vector<AssetItem> inside = browser.catalog().in(folder);
        const bool leaf =
            std::none_of(inside.begin(), inside.end(), [](const AssetItem& item) { return item.folder; });
        ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth;
        if (leaf) flags |= ImGuiTreeNodeFlags_Leaf;
        if (folder == browser.folder && browser.search.empty()) flags |= ImGuiTreeNodeFlags_Selected;
        if (folder.empty() || folder == "assets") flags |= ImGuiTreeNodeFlags_DefaultOpen;
        const std::string name = folder.empty() ? "Project" : folder.substr(folder.rfind('/') + 1);
        const bool open = ImGui::TreeNodeEx(folder.empty() ? "/" : folder.c_str(), flags, "%s", name.c_str());
        ui.widgets.mark("Assets/folder/" + (folder.empty() ? std::string{"Project"} : folder));
        if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) browser.enter(folder);
        if (const std::string dropped = acceptAsset(hovering_); !dropped.empty())
            browser.moveInto(dropped, folder);
        if (!open) return;
        for (const AssetItem& item : inside) {
            if (item.folder) drawFolder(ui, browser, item.path);
        }
        ImGui::TreePop();
    }

    void drawFiles(Ui& ui, AssetBrowser& browser) {
        const std::vector<AssetItem> items = browser.shown();
        if (items.empty()) {
            return browser.search.empty()
                       ? emptyState(ui, "Assets", "This folder is empty.",
                                    "Save images and sounds into it with any program; they appear at once.",
                                    {"file.import"})
                       : emptyState(ui, "Assets", "No file name contains the search text.",
                                    "Try fewer letters.");
        }
        const float below = nameHeight(ui) + ImGui::GetStyle().ItemSpacing.y;
        const auto [side, columns] = rowsFitting(items.size(), ImGui::GetContentRegionAvail(), below, ui);
        const float step = side + ui.px(kBetween);
        for (int i = 0; i < static_cast<int>(items.size()); ++i) {
            if (i % columns != 0) ImGui::SameLine(static_cast<float>(i % columns) * step);
            drawItem(ui, browser, items[static_cast<std::size_t>(i)], side);
        }
        if (ImGui::IsMouseClicked(0) && ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered())
            browser.selected.clear();
        // The keys of this panel need the focus, which a right click does not set by itself.
        if (ImGui::IsMouseClicked(1) && ImGui::IsWindowHovered()) ImGui::SetWindowFocus();
        waitForKeys(ui, browser);
    }

    /// Makes the keys for rename and delete apply to the selected file, not to the selected entities.
    void waitForKeys(Ui& ui, const AssetBrowser& browser) {
        const bool wants = ImGui::IsWindowFocused() && !browser.selected.empty();
        keysSeen_ = ImGui::GetFrameCount();
        if (wants && !ui.takeEvent) {
            ui.takeEvent = [this, &workspace = ui.workspace](const Event& event) {
                return takeKey(workspace, event);
            };
            waits_ = true;
        } else if (!wants && std::exchange(waits_, false)) {
            ui.takeEvent = nullptr;
        }
    }
    bool takeKey(const Workspace& workspace, const Event& event) {
        const bool seen = ImGui::GetFrameCount() <= keysSeen_ + 1;
        if (!seen || !browser_ || anyPopupOpen() || ImGui::GetIO().WantTextInput) return false;
        const auto means = [&](const char* action) {
            return workspace.settings.keys.matches(*findAction(action), event);
        };
        if (means("entity.rename")) return rename_ = browser_->selected, true;
        if (means("edit.delete")) return delete_ = browser_->selected, true;
        return false;
    }

    [[nodiscard]] static float nameHeight(const Ui& ui) { return ImGui::GetTextLineHeight() + ui.px(4.0f); }

    void drawItem(Ui& ui, AssetBrowser& browser, const AssetItem& item, float side) {
        ImGui::PushID(item.path.c_str());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::InvisibleButton("item", {side, side + nameHeight(ui)});
        ui.widgets.mark("Assets/" + item.path, nameOfKind(item.kind));
        const bool hovered = ImGui::IsItemHovered();
        if (hovered && ImGui::IsMouseClicked(0)) browser.selected = item.path;
        if (hovered && ImGui::IsMouseDoubleClicked(0)) open(ui, browser, item);
        itemMenu(ui, browser, item);
        if (!item.folder && ImGui::BeginDragDropSource()) {
            ImGui::SetDragDropPayload(kAssetPayload, item.path.c_str(), item.path.size() + 1);
            ImGui::TextUnformatted(item.path.c_str());
            ImGui::EndDragDropSource();
        }
        if (hovered && hoveredPath_ != item.path) hoveredPath_ = item.path, hoveredSince_ = ImGui::GetTime();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 to{at.x + side, at.y + side};
        const bool chosen = item.path == browser.selected;
        list.AddRectFilled(at, to, palette::kCanvas, ui.px(4.0f));
        const float inset = ui.px(4.0f);
        const AABB box{{at.x + inset, at.y + inset}, {to.x - inset, to.y - inset}};
        const double playing = hovered ? ImGui::GetTime() - hoveredSince_ : 0.0;
        if (item.folder) {
            drawFolderSign(list, box);
        } else if (ImGui::IsRectVisible(at, to)) {
            drawAsset(ui, list, item.kind, item.path, box, playing);
            drawAssetMark(ui, list, item.kind, {to.x - ui.px(2.0f), to.y - ui.px(2.0f)});
        }
        if (chosen || hovered)
            outline(list, at, to, chosen ? palette::kAccent : palette::kCardLine, ui.px(4.0f),
                    chosen ? 2.0f : 1.0f);
        // The name may extend half way to the neighbouring thumbnails.
        const std::string name = fitted(item.title(), side + ui.px(kBetween - 2.0f));
        const float width = ImGui::CalcTextSize(name.c_str()).x;
        ui.widgets.mark(format("Assets/name/{}", item.path), name);
        const ImVec2 low = list.GetClipRectMin();
        const ImVec2 high = list.GetClipRectMax();
        list.PushClipRect({low.x - ui.px(kBetween * 0.5f), low.y}, {high.x + ui.px(kBetween * 0.5f), high.y});
        list.AddText({at.x + (side - width) * 0.5f, to.y + ui.px(2.0f)},
                     chosen ? palette::kText : palette::kTextDim, name.c_str());
        list.PopClipRect();
        if (hovered) tooltip(format("{}\n{}", item.path, item.folder ? "folder" : browser.describe(item)));
        ImGui::PopID();
    }

    static void drawFolderSign(ImDrawList& list, const AABB& box) {
        const Vec2 size = box.size();
        const Vec2 from = box.min + Vec2{size.x * 0.14f, size.y * 0.26f};
        const Vec2 to = box.max - Vec2{size.x * 0.14f, size.y * 0.22f};
        const ImU32 color = palette::kSand;
        list.AddRectFilled({from.x, from.y - size.y * 0.08f}, {from.x + size.x * 0.32f, to.y}, color, 3.0f);
        list.AddRectFilled({from.x, from.y}, {to.x, to.y}, color, 3.0f);
    }

    void itemMenu(Ui& ui, AssetBrowser& browser, const AssetItem& item) {
        if (!ImGui::BeginPopupContextItem("menu")) return;
        browser.selected = item.path;
        const auto entry = [&](const char* label, bool enabled, const std::function<void()>& then) {
            const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
            ui.widgets.mark(std::string{"Assets/menu/"} + label);
            if (chosen) then();
        };
        entry("Open",
              item.folder || item.kind == AssetKind::Scene || item.kind == AssetKind::Animation ||
                  item.kind == AssetKind::Texture || item.kind == AssetKind::Prefab,
              [&] { open(ui, browser, item); });
        entry("Add to the scene", canBePlaced(item.kind) && ui.workspace.canEdit(),
              [&] { browser.place(item.path, ui.workspace.view.view().center); });
        const bool isSheet = item.kind == AssetKind::Texture && ui.workspace.canEdit();
        entry("Make animation", isSheet, [&] { ui.workspace.assetToEdit = item.path; });
        entry("Make tileset", isSheet, [&] { makeTilesetOf(ui, browser, item.path); });
        ImGui::Separator();
        entry("Rename...", true, [&] { rename_ = item.path; });
        entry("Delete...", true, [&] { delete_ = item.path; });
        entry("Copy path", true, [&] { ui.workspace.clipboard = item.path; });
        ImGui::EndPopup();
    }

    void open(Ui& ui, AssetBrowser& browser, const AssetItem& item) {
        if (item.folder) return browser.enter(item.path);
        if (item.kind == AssetKind::Scene) return openSceneOrSay(ui, item.path);
        if (item.kind == AssetKind::Prefab) {
            askToEditPrefab(ui.workspace, item.path);
        } else if (item.kind == AssetKind::Texture) {
            image_.open(item.path);
        } else if (item.kind == AssetKind::Animation) {
            ui.workspace.assetToEdit = item.path;
        } else {
            ui.workspace.notice = format("Drag {} into the scene", item.name());
        }
    }

    void drawRename(Ui& ui, AssetBrowser& browser) {
        if (!rename_.empty() && !ImGui::IsPopupOpen("Rename file")) {
            ImGui::OpenPopup("Rename file");
            subject_ = std::exchange(rename_, {});
            newPath_ = subject_;
            uses_ = browser.usesOf(subject_);
            error_.clear();
        }
        if (!ImGui::BeginPopupModal("Rename file", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
        ImGui::TextDisabled("New path in the project");
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        ImGui::SetNextItemWidth(ui.px(380.0f));
        bool done = textField("##path", newPath_, ImGuiInputTextFlags_EnterReturnsTrue);
        ui.widgets.mark("Rename/path", newPath_);
        drawUses("No file references it.",
                 "These files reference the file and will be updated; undo reverts these updates too:");
        drawError();
        done |= ImGui::Button("Rename", {ui.px(110.0f), 0.0f});
        ui.widgets.mark("Rename/Rename");
        ImGui::SameLine();
        if (ImGui::Button("Cancel", {ui.px(110.0f), 0.0f})) ImGui::CloseCurrentPopup();
        ui.widgets.mark("Rename/Cancel");
        if (done && (error_ = browser.rename(subject_, newPath_)).empty()) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }

    void drawDelete(Ui& ui, AssetBrowser& browser) {
        if (!delete_.empty() && !ImGui::IsPopupOpen("Delete file")) {
            ImGui::OpenPopup("Delete file");
            subject_ = std::exchange(delete_, {});
            uses_ = browser.usesOf(subject_);
            error_.clear();
        }
        if (!ImGui::BeginPopupModal("Delete file", nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
        const std::string question =
            format("Delete {}?  {} restores it.", subject_, keysFor(ui.workspace, "edit.undo"));
        ImGui::TextUnformatted(question.c_str());
        ui.widgets.mark("Delete/question", question);
        drawUses("No file references it.", "These files reference the file and would show a placeholder:");
        drawError();
        const bool confirmed = ImGui::Button("Delete", {ui.px(110.0f), 0.0f}) || entersDialog();
        ui.widgets.mark("Delete/Delete");
        if (confirmed && (error_ = browser.remove(subject_)).empty()) ImGui::CloseCurrentPopup();
        ImGui::SameLine();
        if (ImGui::Button("Keep", {ui.px(110.0f), 0.0f})) ImGui::CloseCurrentPopup();
        ui.widgets.mark("Delete/Keep");
        ImGui::EndPopup();
    }

    void drawUses(const char* none, const char* some) const {
        ImGui::PushStyleColor(ImGuiCol_Text, uses_.empty() ? palette::kTextDim : palette::kWarning);
        ImGui::TextUnformatted(uses_.empty() ? none : some);
        ImGui::PopStyleColor();
        constexpr std::size_t kMost = 12;
        for (std::size_t i = 0; i < std::min(uses_.size(), kMost); ++i)
            ImGui::BulletText("%s", format("{}{}", uses_[i].file,
                                           uses_[i].times > 1 ? format("  ({} times)", uses_[i].times) : "")
                                        .c_str());
        if (uses_.size() > kMost) ImGui::TextDisabled("and %zu more", uses_.size() - kMost);
    }

    void drawError() const {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
        if (!error_.empty()) ImGui::TextUnformatted(error_.c_str());
        ImGui::PopStyleColor();
        ImGui::Spacing();
    }

    std::unique_ptr<AssetBrowser> browser_;
    ImageDialog image_;
    double nextLook_ = 0.0;
    std::string hoveredPath_;
    double hoveredSince_ = 0.0;
    std::string hovering_;
    bool waits_ = false;  ///< true while ui.takeEvent is set by this panel
    int keysSeen_ = 0;    ///< last frame in which the files were drawn
    std::string rename_;  ///< path whose rename dialog is requested
    std::string delete_;
    std::string subject_;
    std::string newPath_;
    std::vector<AssetUse> uses_;
    std::string error_;
};

}  // namespace

std::unique_ptr<Panel> makeAssetsPanel() { return std::make_unique<AssetsPanel>(); }

}  // namespace plumb::editor::ui
