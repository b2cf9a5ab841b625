#include "editor/ui/widgets/pickers.hpp"

#include <vector>

#include "assets/asset_store.hpp"
#include "core/file.hpp"

namespace plumb::editor::ui {
namespace {

const char* endingOf(AssetKind kind) {
    switch (kind) {
        case AssetKind::Texture: return ".png";
        case AssetKind::Tileset: return ".tileset.json";
        case AssetKind::Animation: return ".anim.json";
        case AssetKind::Sound: return ".wav";
        case AssetKind::Font: return ".ttf";
        case AssetKind::Scene: return ".scene.json";
        case AssetKind::Prefab: return ".prefab.json";
        case AssetKind::None: break;
    }
    return "";
}

bool choice(Ui& ui, const std::string& path, const std::string& label, bool now) {
    const bool chosen = ImGui::Selectable((label + "##" + path).c_str(), now);
    ui.widgets.mark(path);
    return chosen;
}

}  // namespace

bool pickEntity(Ui& ui, const std::string& path, ObjectId& id) {
    const Document& document = ui.workspace.document;
    const std::string shown = !id ? "nobody" : document.find(id) ? document.nameOf(id) : "gone";
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##entity", shown.c_str());
    ui.widgets.mark(path, shown);
    if (!open) return false;
    bool changed = false;
    if (choice(ui, path + "/nobody", "nobody", !id)) id = {}, changed = true;
    for (const ObjectId other : document.objects()) {
        const std::string name = document.nameOf(other);
        ImGui::PushID(static_cast<int>(other.value));
        if (choice(ui, path + "/" + name, name, other == id)) id = other, changed = true;
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return changed;
}

bool pickAsset(Ui& ui, const std::string& path, AssetKind kind, TextId& id) {
    Workspace& workspace = ui.workspace;
    std::string shown{workspace.document.world.texts().find(id)};
    if (shown.empty()) shown = workspace.assets.pathOf(kind, id);
    const std::string_view file = std::string_view{shown}.substr(shown.rfind('/') + 1);
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##asset", id.empty() ? "none" : std::string{file}.c_str());
    ui.widgets.mark(path, shown);
    if (!shown.empty() && !open) tooltip(shown);
    if (!open) return false;
    bool changed = false;
    if (choice(ui, path + "/none", "none", id.empty())) id = {}, changed = true;
    for (const std::string& name : filesBelow(workspace.project.root, endingOf(kind))) {
        if (startsWith(name, "art/")) continue;
        if (!choice(ui, path + "/" + name, name, name == shown)) continue;
        id = workspace.document.world.texts().add(name);
        workspace.assets.load(kind, name);
        changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

}  // namespace plumb::editor::ui
