#include "editor/ui/welcome_screen.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/text.hpp"
#include "editor/templates/project_templates.hpp"
#include "editor/ui/scene_picture.hpp"
#include "editor/ui/ui_compat.hpp"
#include "editor/ui/widgets/text_field.hpp"
#include "platform/image_file.hpp"

namespace plumb::editor::ui {
namespace {

// Sizes in px at scale 1.
constexpr float kWidth = 980.0f;  // width of the whole content
constexpr float kHeight = 672.0f;
constexpr float kLeft = 0.42f;  // ratio of the width for the part "New project"
constexpr float kTemplateHeight = 44.0f;
constexpr float kRowHeight = 64.0f;  // height of a row of the recent projects
constexpr float kLabels = 66.0f;     // width of the labels

Path homeFolder() {
    for (const char* name : {"HOME", "USERPROFILE"}) {
        if (const char* home = std::getenv(name); home != nullptr && *home != '\0') return Path{home};
    }
    std::error_code failed;
    return std::filesystem::current_path(failed);
}

/// Converts a path typed by the user; a leading "~" is the home folder.
Path pathFrom(const std::string& text) {
    const std::string_view plain = trimmed(text);
    if (plain == "~") return homeFolder();
    if (startsWith(plain, "~/")) return homeFolder() / plain.substr(2);
    return Path{plain};
}

std::string shortened(const std::string& folder) {
    const std::string home = homeFolder().string();
    if (home.size() > 1 && startsWith(folder, home + "/"))
        return format("~{}", std::string_view{folder}.substr(home.size()));
    return folder;
}

void heading(const Ui& ui, const char* text) {
    pushFont(ui.fonts.strong, ui.fonts.size);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::Dummy({0.0f, ui.px(2.0f)});
}

void message(Ui& ui, const std::string& text, const char* path) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ui.widgets.mark(path, text);
}

void label(const Ui& ui, const char* text) {
    const float start = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(start + ui.px(kLabels));
    ImGui::SetNextItemWidth(-1.0f);
}

/// Draws the logo of the program: a plumb bob.
void drawSign(ImDrawList& list, ImVec2 at, float size) {
    const auto point = [&](float x, float y) { return ImVec2{at.x + x * size, at.y + y * size}; };
    list.AddLine(point(0.5f, 0.0f), point(0.5f, 0.45f), palette::kTextDim, size * 0.05f);
    list.AddRectFilled(point(0.36f, 0.36f), point(0.64f, 0.48f), palette::kText, size * 0.04f);
    list.AddTriangleFilled(point(0.22f, 0.5f), point(0.78f, 0.5f), point(0.5f, 1.0f), palette::kAccent);
}

}  // namespace

void WelcomeScreen::open(Ui& ui, const std::string& folder) {
    shown_ = true;
    focus_ = true;
    message_.clear();
    openMessage_.clear();
    ownFolder_ = false;
    if (name_.empty()) name_ = "My Game";
    follow();
    readRecent(ui);
    if (!folder.empty()) openFolder(ui, folder);
}

void WelcomeScreen::readRecent(Ui& ui) {
    recent_.clear();
    for (const std::string& folder : ui.workspace.settings.recent) {
        Recent one{folder, projectNameOf(folder), isProject(folder), {}, false};
        const Result<std::string> bytes = readFile(projectPicture(folder));
        if (Result<Image> image = bytes ? decodeImage(*bytes, folder) : Result<Image>{Error{}}; image) {
            one.picture = ui.workspace.assets.addTexture("picture of " + folder, std::move(*image));
            one.hasPicture = true;
        }
        recent_.push_back(std::move(one));
    }
}

void WelcomeScreen::follow() {
    if (!ownFolder_) folder_ = shortened((homeFolder() / "Plumb" / folderNameFor(name_)).string());
}

void WelcomeScreen::draw(Ui& ui, ImVec2 size) {
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kChrome);
    ImGui::Begin("welcome", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    const float margin = ui.px(24.0f);
    const float gap = ui.px(20.0f);
    const float width = std::min(ui.px(kWidth), size.x - 2.0f * margin);
    const float height = std::min(ui.px(kHeight), size.y - 2.0f * margin);
    const ImVec2 from{std::floor((size.x - width) * 0.5f), std::floor((size.y - height) * 0.45f)};
    const float title = ui.px(76.0f);
    drawTitle(ui, from, width);

    const float left = std::floor((width - gap) * kLeft);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(16.0f), ui.px(14.0f)});
    ImGui::PushStyleVar(ImGuiStyleVar_ChildRounding, ui.px(6.0f));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel);
    ImGui::SetCursorScreenPos({from.x, from.y + title});
    beginChild("new", {left, height - title}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleColor();
    drawNew(ui);
    ImGui::EndChild();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel);
    ImGui::SetCursorScreenPos({from.x + left + gap, from.y + title});
    beginChild("recent", {width - left - gap, height - title}, false,
               ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    drawRecent(ui);
    drawOpen(ui);
    ImGui::EndChild();
    ImGui::End();
}

void WelcomeScreen::drawTitle(Ui& ui, ImVec2 at, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float side = ui.px(46.0f);
    drawSign(list, at, side);
    pushFont(ui.fonts.title, ui.fonts.titleSize);
    list.AddText({at.x + side + ui.px(10.0f), at.y}, palette::kText, "Plumb");
    ImGui::PopFont();
    list.AddText({at.x + side + ui.px(12.0f), at.y + ui.fonts.titleSize + ui.px(4.0f)}, palette::kTextDim,
                 "Levels, physics and play in one window");
    if (ui.workspace.project.isNone) return;
    const std::string back = format("Back to {}", ui.workspace.project.name);
    const float room = ImGui::CalcTextSize(back.c_str()).x + ui.px(24.0f);
    ImGui::SetCursorScreenPos({at.x + width - room, at.y + ui.px(8.0f)});
    if (ImGui::Button(back.c_str(), {room, ui.px(30.0f)})) close(ui);
    ui.widgets.mark("Welcome/Back");
    tooltip("Esc");
}

void WelcomeScreen::drawNew(Ui& ui) {
    heading(ui, "New project");
    for (std::size_t i = 0; i < projectTemplates().size(); ++i) drawTemplate(ui, i);
    ImGui::Dummy({0.0f, ui.px(4.0f)});
    label(ui, "Name");
    if (std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
    bool done = textField(
        "##name", name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll, "My Game");
    ui.widgets.mark("Welcome/name", name_);
    follow();
    label(ui, "Folder");
    const std::string before = folder_;
    done |= textField("##folder", folder_, ImGuiInputTextFlags_EnterReturnsTrue, "an empty folder");
    ownFolder_ |= folder_ != before;
    ui.widgets.mark("Welcome/folder", folder_);
    tooltip("The folder is created if it does not exist");
    ImGui::Dummy({0.0f, ui.px(4.0f)});
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccentPressed);
    done |= ImGui::Button("Create project", {-1.0f, ui.px(32.0f)});
    ImGui::PopStyleColor();
    ui.widgets.mark("Welcome/Create");
    if (done) create(ui);
    message(ui, message_, "Welcome/message");
}

void WelcomeScreen::drawTemplate(Ui& ui, std::size_t index) {
    const ProjectTemplate& row = projectTemplates()[index];
    const bool there = isHere(row);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, ui.px(kTemplateHeight)};
    const ImVec2 to{at.x + size.x, at.y + size.y};
    const std::string id{row.id};
    if (ImGui::InvisibleButton(id.c_str(), size) && there) template_ = index, focus_ = true;
    const bool chosen = template_ == index;
    ui.widgets.mark("Welcome/template/" + id, chosen ? "chosen" : "");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    list.AddRectFilled(at, to,
                       chosen    ? palette::kAccentSoft
                       : hovered ? palette::kHover
                                 : palette::kCard,
                       ui.px(5.0f));
    if (chosen) outline(list, at, to, palette::kAccent, ui.px(5.0f), ui.px(1.5f));
    const float inset = ui.px(12.0f);
    list.PushClipRect(at, to, true);
    list.AddText(ui.fonts.strong, ui.fonts.size, {at.x + inset, at.y + ui.px(5.0f)},
                 there ? palette::kText : palette::kTextDim, row.name.data(),
                 row.name.data() + row.name.size());
    const std::string what = there ? std::string{row.what} : std::string{"Not installed with this program."};
    const ImVec2 line{at.x + inset, at.y + ui.px(4.0f) + ui.fonts.size * 1.25f};
    const ImVec2 room = ImGui::CalcTextSize(what.c_str());
    list.AddText(ui.fonts.text, ui.fonts.size, line, palette::kTextDim, what.c_str());
    ui.widgets.mark("Welcome/what/" + id, {{line.x, line.y}, {line.x + room.x, line.y + room.y}}, what);
    list.PopClipRect();
}

void WelcomeScreen::create(Ui& ui) {
    const Result<Path> made = createProject(projectTemplates()[template_], name_, pathFrom(folder_));
    if (!made) {
        message_ = made.error().text();
        return;
    }
    openFolder(ui, made->string());
}

void WelcomeScreen::drawRecent(Ui& ui) {
    heading(ui, "Recent projects");
    beginChild("list", {0.0f, -ui.px(78.0f)}, false);
    if (recent_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette::kTextDim);
        ImGui::TextWrapped("No recent projects. Create one on the left, or open a folder below.");
        ImGui::PopStyleColor();
    }
    for (std::size_t i = 0; i < recent_.size(); ++i) drawRecentRow(ui, i);
    ImGui::EndChild();
}

void WelcomeScreen::drawRecentRow(Ui& ui, std::size_t index) {
    const Recent& row = recent_[index];
    const std::string path = format("Welcome/recent/{}", index);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, ui.px(kRowHeight)};
    ImGui::PushID(static_cast<int>(index));
    const bool pressed = ImGui::InvisibleButton("row", size);
    allowOverlapAfter();
    ui.widgets.mark(path, row.name);
    const bool hovered = ImGui::IsItemHovered();
    if (hovered)
        tooltip(
            row.there
                ? row.folder
                : row.folder +
                      "\nThis folder no longer contains a project. Right-click to remove it from the list.");
    bool forget = false;
    if (ImGui::BeginPopupContextItem("menu")) {
        forget = ImGui::MenuItem("Remove from list");
        ui.widgets.mark(path + "/forget");
        ImGui::EndPopup();
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to{at.x + size.x, at.y + size.y};
    if (hovered) list.AddRectFilled(at, to, palette::kHover, ui.px(5.0f));
    const float inset = ui.px(6.0f);
    const float high = size.y - 2.0f * inset;
    const ImVec2 from{at.x + inset, at.y + inset};
    const ImVec2 end{from.x + std::floor(high * 16.0f / 9.0f), from.y + high};
    list.AddRectFilled(from, end, palette::kCanvas, ui.px(3.0f));
    if (row.hasPicture && ui.picture != nullptr) {
        const TexturePart part = ui.picture->part(row.picture, {});
        list.AddImageRounded(textureId(part.texture), from, end, {part.from.x, part.from.y},
                             {part.to.x, part.to.y}, IM_COL32_WHITE, ui.px(3.0f));
    } else {
        const float side = high * 0.5f;
        drawSign(list, {(from.x + end.x - side) * 0.5f, (from.y + end.y - side) * 0.5f}, side);
    }
    const float x = end.x + ui.px(12.0f);
    list.PushClipRect(at, {to.x - inset, to.y}, true);
    list.AddText(ui.fonts.strong, ui.fonts.size, {x, at.y + ui.px(13.0f)},
                 row.there ? palette::kText : palette::kTextDim, row.name.c_str());
    const std::string where =
        row.there ? shortened(row.folder) : format("not found: {}", shortened(row.folder));
    list.AddText({x, at.y + ui.px(16.0f) + ui.fonts.size * 1.25f}, palette::kTextDim, where.c_str());
    list.PopClipRect();
    ImGui::PopID();
    if (forget) {
        ui.workspace.settings.forget(std::string{row.folder});
        readRecent(ui);
    } else if (pressed) {
        openFolder(ui, std::string{row.folder});
    }
}

void WelcomeScreen::drawOpen(Ui& ui) {
    ImGui::Dummy({0.0f, ui.px(2.0f)});
    ImGui::AlignTextToFramePadding();
    const float button = ui.px(80.0f);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
    bool done = textField("##place", place_, ImGuiInputTextFlags_EnterReturnsTrue,
                          "Another folder, e.g. ~/games/tower");
    ui.widgets.mark("Welcome/place", place_);
    ImGui::SameLine();
    done |= ImGui::Button("Open", {button, 0.0f});
    ui.widgets.mark("Welcome/Open");
    tooltip("A folder that contains a file project.json");
    if (done) openFolder(ui, place_);
    message(ui, openMessage_, "Welcome/openMessage");
}

void WelcomeScreen::openFolder(Ui& ui, const std::string& folder) {
    Path path = pathFrom(folder);
    std::error_code failed;
    if (path.filename() == "project.json") path = path.parent_path();
    openMessage_.clear();
    if (path.empty() || !std::filesystem::is_directory(path, failed)) {
        openMessage_ =
            path.empty() ? "Enter the path of a folder." : format("There is no folder {}", path.string());
    } else if (isProject(path)) {
        ui.workspace.projectToOpen = std::filesystem::absolute(path, failed).lexically_normal().string();
        ui.workspace.request = WindowRequest::OpenProject;
    } else {
        folder_ = std::filesystem::absolute(path, failed).lexically_normal().string();
        ownFolder_ = true;
        name_ = Path{folder_}.filename().string();
        focus_ = true;
        message_ = "This folder does not contain a project. Enter a name to create one there.";
    }
}

}  // namespace plumb::editor::ui
