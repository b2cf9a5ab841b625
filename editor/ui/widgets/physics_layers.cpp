#include "editor/ui/widgets/physics_layers.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "core/text.hpp"
#include "editor/ui/overlays/overlay_list.hpp"

namespace plumb::editor::ui {
namespace {

struct Choice {
    PhysicsReach reach;
    const char* label;
    const char* name;
    const char* hidden;
};
constexpr std::array kChoices{Choice{PhysicsReach::Off, "Off", "off", "##off"},
                              Choice{PhysicsReach::Selected, "Selected", "selected", "##selected"},
                              Choice{PhysicsReach::All, "All", "all", "##all"}};

/// A row of the table: an overlay of the editor or a layer of the physics.
struct Line {
    std::string_view name;
    std::string_view label;
    std::string_view doc;
    bool ofSelected;
    std::function<PhysicsReach()> reach;
    std::function<void(PhysicsReach)> setReach;
};

struct Heading {
    const char* title;
    std::vector<std::string_view> names;
};

/// Groups of the table; rows in no group come last.
const std::vector<Heading>& headings() {
    static const std::vector<Heading> table{
        {"Entities", {"names", "shapes", "triggers", "centres", "bounds"}},
        {"Motion", {"ways", "reach", "trajectories", "velocities", "paths", "sweeps"}},
        {"Contacts", {"contacts", "normals", "impulses", "friction", "contactForces", "bodyErrors"}},
        {"Joints and fields", {"joints", "jointForces", "fields"}},
        {"Simulation", {"sleep", "islands", "broadPhase", "times", "counts"}},
    };
    return table;
}

std::vector<Line> linesOf(Workspace& workspace) {
    std::vector<Line> lines;
    for (const OverlayRow& row : overlayTable()) {
        if (!row.ofEntities) continue;
        lines.push_back({row.name,
                         row.label,
                         {},
                         true,
                         [&workspace, name = row.name] { return workspace.reachOf(name); },
                         [&workspace, name = row.name](PhysicsReach to) { workspace.setReach(name, to); }});
    }
    for (const PhysicsLayer& layer : physicsLayers()) {
        lines.push_back({layer.name, layer.label, layer.doc, layer.ofBodies,
                         [&workspace, &layer] { return workspace.physics.reachOf(layer); },
                         [&workspace, &layer](PhysicsReach to) { workspace.physics.setReach(layer, to); }});
    }
    return lines;
}

void drawLine(Ui& ui, const Line& line, const std::string& path) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(line.label.data(), line.label.data() + line.label.size());
    tooltip(line.doc);
    ImGui::PushID(line.name.data());
    for (const Choice& choice : kChoices) {
        ImGui::TableNextColumn();
        if (choice.reach == PhysicsReach::Selected && !line.ofSelected) continue;
        const bool chosen = line.reach() == choice.reach;
        if (ImGui::RadioButton(choice.hidden, chosen)) line.setReach(choice.reach);
        ui.widgets.mark(format("{}{}/{}", path, line.name, choice.name), chosen ? "on" : "off");
        tooltip(line.doc);
    }
    ImGui::PopID();
}

void drawHeading(const char* title) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", title);
}

}  // namespace

void physicsLayerItems(Ui& ui, const std::string& path) {
    if (!ImGui::BeginTable("layers", 4, ImGuiTableFlags_SizingFixedFit)) return;
    ImGui::TableSetupColumn("");
    for (const Choice& choice : kChoices) ImGui::TableSetupColumn(choice.label);
    ImGui::TableHeadersRow();
    std::vector<Line> lines = linesOf(ui.workspace);
    for (const Heading& heading : headings()) {
        drawHeading(heading.title);
        for (const std::string_view name : heading.names) {
            const auto line =
                std::find_if(lines.begin(), lines.end(), [&](const Line& each) { return each.name == name; });
            if (line == lines.end()) continue;
            drawLine(ui, *line, path);
            lines.erase(line);
        }
    }
    if (!lines.empty()) drawHeading("More");
    for (const Line& line : lines) drawLine(ui, line, path);
    ImGui::EndTable();
}

}  // namespace plumb::editor::ui
